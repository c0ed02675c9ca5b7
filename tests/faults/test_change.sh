#!/bin/bash
# What may change when a run goes on, and what may not.  change.sh WASHTUB
. "$(dirname "$0")/common.sh"

run "$work/whole" -n 1 || fail "the undisturbed run"

# A longer run, in two steps, the second one named by its directory alone.
run "$work/parts" -n 1 --set 'time.end=40 ms' --set 'output.window=["20 ms", "40 ms"]' ||
  fail "the short run"
run "$work/parts" -n 1 --resume --set 'time.end=80 ms' --set 'output.window=["20 ms", "80 ms"]' ||
  fail "the longer run"
"$program" run --resume "$work/parts" --no-report -n 1 --set 'time.end=120 ms' \
  --set 'output.window=["20 ms", "120 ms"]' >>"$work/parts.out" 2>&1 || fail "by its directory"
same_results "$work/whole" "$work/parts"

# What helps a run that gave up may change, and is told.
run "$work/parts" -n 1 --resume --set 'time.end=124 ms' --set 'output.window=["20 ms", "120 ms"]' \
  --set solver.max_cycles=90 || fail "with more cycles"
expect_text "$work/parts.out" "washtub: before: solver.max_cycles = 60, here 90"
expect_text "$work/parts/log.txt" "before: solver.max_cycles = 60, here 90"

# Another case is refused with the difference; as a start of its own run it is welcome.
expect_code 2 run "$work/whole" -n 1 --resume --set 'fluid.viscosity=2 Pa s'
expect_text "$work/whole.out" 'is of another case: fluid.viscosity = "1 Pa s", here "2 Pa s"'
run "$work/thicker" -n 1 --from "$work/whole" --set 'fluid.viscosity=2 Pa s' \
  --set checkpoint.keep=100 || fail "--from"
[ -e "$work/thicker/checkpoints/checkpoint_0000000000.h5" ] || fail "no checkpoint of its start"

# A window that begins after the checkpoint is new; one that began otherwise is not.
run "$work/short" -n 1 --set 'time.end=40 ms' --set 'output.window=["20 ms", "40 ms"]' || fail "short"
expect_code 2 run "$work/short" -n 1 --resume --set 'output.window=["10 ms", "120 ms"]'
expect_text "$work/short.out" "add --set 'output.window=[\"0.02 s\", \"0.04 s\"]'"
expect_code 2 run "$work/short" -n 1 --resume --set 'time.end=30 ms' \
  --set 'output.window=["20 ms", "30 ms"]'
expect_text "$work/short.out" "is at t = 0.04 s, beyond time.end"
later=(--set 'output.window=["60 ms", "120 ms"]')
run "$work/short" -n 1 --resume "${later[@]}" || fail "a later window"
run "$work/later" -n 1 "${later[@]}" || fail "a run with the later window"
same_results "$work/later" "$work/short"

# What another run starts from is not overwritten, nor is another case by --resume.
expect_code 2 run "$work/whole" -n 1 --from "$work/whole" --force
expect_text "$work/whole.out" "whose results would be overwritten"
mkdir "$work/table" && echo a,b >"$work/table/history.csv"
expect_code 2 run "$work/table" -n 1 --resume
[ -s "$work/table/history.csv" ] || fail "a table of the user is gone"

# What is no run, or a long one that has lost its checkpoints, is not overwritten.
mkdir "$work/mine" && cp "$case" "$work/mine/case.toml"
expect_code 2 "$program" run --resume "$work/mine" 2>"$work/mine.out"
expect_text "$work/mine.out" "holds no run to go on with"
rm -r "$work/parts/checkpoints" "$work/parts/summary.json"
touch -d '1 hour ago' "$work/parts/case.toml"
expect_code 2 run "$work/parts" -n 1 --resume
expect_text "$work/parts.out" "but no checkpoint to go on from"
expect_code 2 run "$work/finer" -n 1 --from "$work/whole" --set domain.cells=64
expect_text "$work/finer.out" "has another domain.cells, so that its water and cloth cannot start this case"
expect_code 2 run "$work/more" -n 1 --from "$work/whole" --set 'cloth[1].count=3'
expect_text "$work/more.out" "has another cloth[1].count"
finish
