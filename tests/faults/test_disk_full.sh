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
full=0
for kilobytes in 0 4 40 100 200 400; do
  directory=$work/small/run
  start "$directory" -n 1
  until [ -s "$directory/history.csv" ] || ! kill -0 $pid 2>/dev/null; do sleep 0.01; done
  dd if=/dev/zero of="$work/small/filler" bs=1k 2>/dev/null
  truncate -s -${kilobytes}K "$work/small/filler"
  wait $pid
  code=$?
  rm -f "$work/small/filler"
  case $code in
  0) ;; # there was room enough for rows and frames
  1) full=1 && expect_text "$work/run.out" "No space left on device" ;;
  *) fail "exit code $code at $kilobytes kB" ;;
  esac
  rm "$work/run.out"
  no_leftovers "$directory"
  run "$directory" -n 1 --resume || { fail "resume at $kilobytes kB"; tail -n 3 "$work/run.out"; }
  same_results "$work/whole" "$directory"
  rm -rf "$work"/small/*
done
[ $full -eq 1 ] || fail "no run has met a full disk"
finish
