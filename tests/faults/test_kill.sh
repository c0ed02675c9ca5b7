#!/bin/bash
# Kills a run with SIGKILL at random moments; resumed, each ends with the very results of a run that
# nothing befell.  kill.sh WASHTUB [TIMES [RANKS]], three times on one rank and on two by default
. "$(dirname "$0")/common.sh"
times=${2:-3}

for ranks in ${3:-1 2}; do
  begin=$(date +%s%N)
  run "$work/whole$ranks" -n "$ranks" || fail "the undisturbed run"
  length=$((($(date +%s%N) - begin) / 1000000)) # ms

  for i in $(seq "$times"); do
    directory=$work/killed$i
    start "$directory" -n "$ranks"
    moment $length
    # One rank of several: mpirun then ends the others.
    victim=$(pgrep -n -f -- "-o $directory " || echo $pid)
    kill -KILL "$victim" 2>/dev/null
    wait $pid 2>/dev/null
    run "$directory" -n "$ranks" --resume || { fail "resume $i"; tail -n 3 "$directory.out"; }
    same_results "$work/whole$ranks" "$directory" && no_leftovers "$directory" && rm -rf "$directory" "$directory.out"
  done
  echo "$times runs of $ranks ranks killed and resumed in $SECONDS s"
done
finish
