#!/bin/bash
# A step that fails is tried again from the last row: with more cycles where the pressure solve
# stalled, with smaller steps; then the run ends with a checkpoint of that row.  remedies.sh WASHTUB
. "$(dirname "$0")/common.sh"

stall=(-n 1 --set solver.max_cycles=2 --set solver.divergence=1e-8)
run "$work/stall" "${stall[@]}" || fail "more cycles do not help"
expect_text "$work/stall.out" "Trying again from t = 0 s with 4 times the cycles and 0.5 of the step"
run "$work/fixed" "${stall[@]}" --set time.fixed=true --set "time.step='0.3 ms'" ||
  fail "more cycles do not help where the step is fixed"
grep -q 'Trying again from t = 0 s with 4 times the cycles$' "$work/fixed.out" ||
  fail "a fixed step is not tried with more cycles alone"

# Nothing helps: three tries, one message, and what is left can go on once the cause is gone.
expect_code 1 run "$work/strained" -n 1 --set coupling.strain_limit=1e-4
[ "$(grep -c 'Trying again' "$work/strained.out")" -eq 3 ] || fail "not three tries"
grep -q '^washtub: step .* of the cloth is .*limit 0.01 %' "$work/strained.out" ||
  fail "no message of the strain in: $(cat "$work/strained.out")"
no_leftovers "$work/strained"
run "$work/strained" -n 1 --resume --set coupling.strain_limit=0.2 || fail "it cannot go on"
run "$work/whole" -n 1 || fail "the undisturbed run"
same_results "$work/whole" "$work/strained"
finish
