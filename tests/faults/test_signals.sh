#!/bin/bash
# Signals that ask a run to stop: it writes a checkpoint and goes on as if nothing had been.
#   signals.sh WASHTUB
. "$(dirname "$0")/common.sh"

for ranks in 1 2; do
  run "$work/whole$ranks" -n $ranks || fail "the undisturbed run on $ranks ranks"
  for signal in INT TERM USR1 HUP; do
    directory=$work/$signal$ranks
    start "$directory" -n $ranks
    until [ -s "$directory/frames.xdmf" ] || ! kill -0 $pid 2>/dev/null; do sleep 0.01; done
    kill -$signal $pid
    wait $pid
    [ $? -eq 130 ] || fail "SIG$signal on $ranks ranks does not end the run with code 130"
    expect_text "$directory.out" "stopped: t "
    no_leftovers "$directory"
    run "$directory" -n $ranks --resume || fail "resume after SIG$signal"
    expect_text "$directory.out" "going on from"
    same_results "$work/whole$ranks" "$directory"
  done
done
finish
