#!/bin/bash
# A disk that fills up while a run writes its rows, frames or checkpoints, and that has room again
# when the run is resumed.  disk_full.sh WASHTUB
# Exits with 77 (skipped) where no small file system can be mounted.
. "$(dirname "$0")/common.sh"

mkdir "$work/small"
mount -t tmpfs -o size=3m none "$work/small" 2>/dev/null || {
  echo "a small file system cannot be mounted here"
  exit 77
}
run "$work/whole" -n 1 || fail "the undisturbed run"

# The disk is full but for KILOBYTES when the run has begun; each size fails at another file.
for kilobytes in 0 40 100 200 400 800; do
  directory=$work/small/run
  start "$directory" -n 1
  until [ -s "$directory/history.csv" ] || ! kill -0 $pid 2>/dev/null; do sleep 0.01; done
  room=$(df -k --output=avail "$work/small" | tail -n 1)
  [ "$room" -gt $kilobytes ] && fallocate -l $((room - kilobytes))K "$work/small/filler"
  wait $pid
  code=$?
  rm -f "$work/small/filler"
  case $code in
  0) grep -q "no checkpoint: cannot write" "$directory.out" || [ $kilobytes -ge 400 ] ||
    fail "nothing said at $kilobytes kB" ;;
  1) expect_text "$directory.out" "No space left on device" ;;
  *) fail "exit code $code at $kilobytes kB" ;;
  esac
  no_leftovers "$directory"
  run "$directory" -n 1 --resume || { fail "resume at $kilobytes kB"; tail -n 3 "$directory.out"; }
  same_results "$work/whole" "$directory"
  rm -rf "$work"/small/*
done
finish
