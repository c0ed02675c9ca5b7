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
run "$work/thicker" -n 1 --from "$work/whole" --set 'fluid.viscosity=2 Pa s' || fail "--from"
expect_code 2 run "$work/finer" -n 1 --from "$work/whole" --set domain.cells=64
expect_text "$work/finer.out" "the grid of run/simulation/flow/water/velocity x is 1 x 34 x 34"
expect_code 2 run "$work/more" -n 1 --from "$work/whole" --set 'cloth[1].count=3'
expect_text "$work/more.out" "run/simulation/cloth/position"
finish
