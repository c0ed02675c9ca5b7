#!/bin/bash
# Checkpoints that are truncated or have a flipped bit: the one before is taken, and said so; where
# none is whole, the run is refused.  damaged.sh WASHTUB
. "$(dirname "$0")/common.sh"

run "$work/whole" -n 1 || fail "the undisturbed run"
newest() { ls "$1"/checkpoints/*.h5 | tail -n 1; }
flip() { # FILE POSITION
  byte=$(od -An -tu1 -j "$2" -N 1 "$1")
  printf "\\$(printf '%03o' $((byte ^ 16)))" | dd of="$1" bs=1 seek="$2" conv=notrunc status=none
}

for damage in cut flip; do
  directory=$work/$damage
  start "$directory" -n 1
  until [ "$(ls "$directory"/checkpoints/*.h5 2>/dev/null | wc -l)" -ge 2 ] || ! kill -0 $pid; do
    sleep 0.01
  done
  kill -KILL $pid
  wait $pid 2>/dev/null
  file=$(newest "$directory")
  case $damage in
  cut) truncate -s -1000 "$file" ;;
  flip) flip "$file" $(($(stat -c %s "$file") / 2)) ;;
  esac
  cp "$file" "$work/damaged.h5"
  touch "$directory/checkpoints/of_the_user.h5" "$directory/checkpoints/checkpoint_9.h5.part"
  run "$directory" -n 1 --resume || { fail "resume past a damaged checkpoint"; tail "$directory.out"; }
  expect_text "$directory.out" "; falling back to $directory/checkpoints/"
  same_results "$work/whole" "$directory"
  no_leftovers "$directory"
  [ -e "$directory/checkpoints/of_the_user.h5" ] || fail "a file of the user is gone"
  ! cmp -s "$file" "$work/damaged.h5" || fail "the damaged checkpoint is still there"
done

for file in "$work"/whole/checkpoints/*.h5; do truncate -s 100 "$file"; done
expect_code 2 run "$work/whole" -n 1 --resume
expect_text "$work/whole.out" "holds no checkpoint to go on from"
expect_text "$work/whole.out" "is cut short, or never finished"
finish
