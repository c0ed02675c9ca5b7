#!/bin/sh
# Opens the frames of two small runs, in space and in the plane, in ParaView and draws them.
#   paraview.sh WASHTUB
# Exits with 77 (skipped) where ParaView is not installed, unless WASHTUB_CI is set.
set -eu

program=$1
root=$(cd "$(dirname "$0")/../.." && pwd)

for tool in pvpython xvfb-run xauth; do
  command -v "$tool" >/dev/null && continue
  echo "$tool is missing: install python3-paraview, xvfb and xauth"
  [ -z "${WASHTUB_CI-}" ] || exit 1
  exit 77
done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# small_run DIMENSION CELLS: a run of five frames.
small_run() {
  "$program" run "$root/cases/wash-$1d/case.toml" -o "$work/$1d" -n 1 --no-report \
    --set domain.cells="$2" --set 'time.end=0.2 s' --set 'output.frames=0.05 s' \
    --set 'output.window=["0.1 s", "0.2 s"]' \
    >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
}

check() {
  small_run "$1" "$2"
  pvpython "$root/tests/programs/paraview_frames.py" "$work/$1d" "$1"
  env -u DISPLAY pvpython "$root/tools/paraview_picture.py" "$work/$1d" "$work/$1d.png" \
    --size 640x480
  pvpython "$root/tests/programs/paraview_picture.py" "$work/$1d.png"
}

check 3 16
check 2 64
