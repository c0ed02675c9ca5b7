# What the tests of this folder share; to be sourced. Usage of each: NAME.sh WASHTUB [COUNT]
set -u
program=$1
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'cd /; umount "$work"/small 2>/dev/null; rm -rf "$work"' EXIT
case=$here/case.toml
failures=0

# run DIR [OPTION...]: a run of the small case; its words go to $work/NAME.out, with the NAME of DIR,
# its exit code is returned.
words() { echo "$work/$(basename "$directory").out"; }
run() {
  directory=$1
  shift
  "$program" run "$case" -o "$directory" --no-report "$@" >>"$(words)" 2>&1
}
# start DIR [OPTION...]: the same in the background, as process $pid.
start() {
  directory=$1
  shift
  "$program" run "$case" -o "$directory" --no-report "$@" >>"$(words)" 2>&1 &
  pid=$!
}
# moment MILLISECONDS: sleeps for a random part of them.
moment() { sleep "$(awk -v n=$RANDOM -v most="$1" 'BEGIN { print most * n / 32768 / 1000 }')"; }
fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}
# expect_text FILE TEXT: the file has the text.
expect_text() { grep -qF -- "$2" "$1" || { fail "\"$2\" is missing in:"; cat "$1"; }; }
# expect_code CODE COMMAND...
expect_code() {
  expected=$1
  shift
  "$@"
  code=$?
  [ $code -eq "$expected" ] || fail "exit code $code, expected $expected: $*"
}
# no_leftovers DIR: no half-written file.
no_leftovers() {
  found=$(find "$1" -name '*.part')
  [ -z "$found" ] || fail "left behind: $found"
}
# same_results A B: rows, tracks, frames and statistics of two runs are the same, bit for bit.
same_results() {
  for name in history.csv tracks.csv frames.xdmf; do
    cmp -s "$1/$name" "$2/$name" || { fail "$name differs between $1 and $2"; return 1; }
  done
  for frame in "$1"/frames/*.h5; do
    h5diff -q "$frame" "$2/frames/$(basename "$frame")" || {
      fail "$(basename "$frame") differs between $1 and $2"
      return 1
    }
  done
  statistics "$1" >"$work/a"
  statistics "$2" >"$work/b"
  cmp -s "$work/a" "$work/b" || { fail "summary.json differs between $1 and $2"; diff "$work/a" "$work/b"; }
}
# statistics DIR: the summary without what depends on the clock or on the command line.
statistics() {
  sed '/"phases": {/,/}/d' "$1/summary.json" | grep -v 'wall time\|per second\|"title"'
}

finish() {
  [ $failures -eq 0 ] && echo "$(basename "$0"): all as it should be"
  exit $((failures > 0))
}
