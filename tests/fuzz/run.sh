#!/bin/bash
# Fuzzes what reads files, with clang's libFuzzer and sanitizers: tests/fuzz/run.sh [SECONDS
# [TARGET...]], 600 s for each of all targets where none is named. build/clang-fuzz/found/ gets the
# input that ends a target, build/clang-fuzz/corpus/TARGET what reaches new code.
# tests/fuzz/run.sh merge TARGET takes from there into tests/fuzz/corpus/TARGET what adds to it.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."

build=build/clang-fuzz
[ -f $build/build.ninja ] || cmake --preset clang-fuzz
cmake --build $build --target fuzz
mkdir -p $build/found

export UBSAN_OPTIONS=print_stacktrace=1
export ASAN_OPTIONS=detect_leaks=0  # MPI and HDF5 keep memory until the process ends

# Files for the readers go to memory, and with it.
export TMPDIR
TMPDIR=$(mktemp -d -p /dev/shm)
trap 'rm -r "$TMPDIR"' EXIT

# The words of case files, from the input reference: keys and what stands between quotes.
words() {
  sed -n 's/^| `\([a-z_]*\)` |.*/"\1"/p' docs/input.md
  grep -o '"[a-z0-9 _-]*"' docs/input.md | sed 's/"\(.*\)"/"\\"\1\\""/'
}
words | sort -u >$build/words

# Of a binary file the targets take a short list of edits, of a text all of it.
length_of() {
  case $1 in frame | checkpoint) echo 300 ;; *) echo 6000 ;; esac
}

fuzz() {  # TARGET CORPUS... OPTIONS
  local target=$1
  shift
  $build/tests/fuzz/fuzz_"$target" "$@" -dict=$build/words -max_len="$(length_of "$target")" \
    -rss_limit_mb=2048 -malloc_limit_mb=1024 -timeout=60 -print_final_stats=1 \
    -artifact_prefix=$build/found/"$target"-
}

if [ "${1:-}" = merge ]; then
  fuzz "$2" tests/fuzz/corpus/"$2" $build/corpus/"$2" -set_cover_merge=1 -use_counters=0
  exit
fi
seconds=${1:-600}
targets=("${@:2}")
[ ${#targets[@]} -gt 0 ] || targets=(case table frame checkpoint run_directory)
for target in "${targets[@]}"; do
  mkdir -p $build/corpus/"$target"
  fuzz "$target" $build/corpus/"$target" tests/fuzz/corpus/"$target" \
    -max_total_time="$seconds" -len_control=0
done
