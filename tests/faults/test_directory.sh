#!/bin/bash
# What can be wrong with the directory of the results: read-only, removed in mid-run, used by another
# run.  directory.sh WASHTUB
. "$(dirname "$0")/common.sh"

# Removed in mid-run: the run ends and says which file cannot be written.
start "$work/removed" -n 1 --set 'time.end=1000 s' # longer than the removal takes
until [ -s "$work/removed/frames.xdmf" ] || ! kill -0 $pid 2>/dev/null; do sleep 0.01; done
until rm -rf "$work/removed" 2>/dev/null; do :; done # the run may be writing into it
wait $pid
[ $? -eq 1 ] || fail "a removed directory does not end the run with code 1"
expect_text "$work/removed.out" "washtub: cannot write $work/removed/"

# Two runs into one directory: the second one is refused, the first one ends as if alone.
start "$work/shared" -n 1
first=$pid
until [ -s "$work/shared/history.csv" ] || ! kill -0 $pid 2>/dev/null; do sleep 0.01; done
"$program" run "$case" -o "$work/shared" --force --no-report -n 1 >"$work/second.out" 2>&1
[ $? -eq 2 ] || fail "a second run into a directory in use is not refused"
expect_text "$work/second.out" "another run writes here: process $first on"
wait $first || fail "the first of two runs"
run "$work/whole" -n 1
same_results "$work/whole" "$work/shared"

# Read-only: one clear error. Root may write everywhere.
if [ "$(id -u)" -ne 0 ]; then
  mkdir "$work/fixed"
  chmod a-w "$work/fixed"
  expect_code 2 run "$work/fixed" -n 1
  expect_text "$work/fixed.out" "cannot be written; name another one with -o"
fi
finish
