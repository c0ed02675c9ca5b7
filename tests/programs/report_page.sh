#!/bin/sh
# Makes the pages of small runs and tries them in headless Chromium.
#   report_page.sh WASHTUB
# Exits with 77 (skipped) where Chromium is missing, unless WASHTUB_CI is set.
set -eu

program=$1
root=$(cd "$(dirname "$0")/../.." && pwd)

command -v chromium >/dev/null || {
  echo "chromium is missing: install chromium"
  [ -z "${WASHTUB_CI-}" ] || exit 1
  exit 77
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

quietly() { "$@" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }; }

# small_run NAME DIMENSION CELLS SETTING END: up to a cycle and a half, frames every 0.1 s, a report.
# Grids this coarse overstretch soft cloth, sooner or later with the seed and the processor, which is
# no matter of the page: the limit is out of the way.
small_run() {
  quietly "$program" run "$root/cases/wash-$2d/case.toml" -o "$work/$1" -n 1 \
    --set domain.cells="$3" --set "$4" --set "time.end=$5 s" --set 'output.frames=0.1 s' \
    --set "output.window=[\"0.8 s\", \"$5 s\"]" --set coupling.strain_limit=1
}

small_run space 3 16 cloth.seed=1 2.4
small_run seed 3 16 cloth.seed=2 1.6
small_run plane 2 64 domain.mapping=sharp 2.4
quietly "$program" compare "$work/space" "$work/seed" -o "$work/comparison.html"

WASHTUB_PAGE_3D=$work/space/report.html WASHTUB_PAGE_2D=$work/plane/report.html \
  WASHTUB_PAGE_COMPARE=$work/comparison.html npm --prefix "$root/viewer" run --silent e2e
