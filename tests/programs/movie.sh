#!/bin/sh
# Makes a movie of a small run with Chromium and ffmpeg and looks at its size, length and picture.
#   movie.sh WASHTUB
# Exits with 77 (skipped) where a program is missing, unless WASHTUB_CI is set.
set -eu

program=$1
root=$(cd "$(dirname "$0")/../.." && pwd)

fail() {
  echo "$*"
  exit 1
}

for tool in chromium ffmpeg ffprobe; do
  command -v "$tool" >/dev/null && continue
  echo "$tool is missing: install chromium and ffmpeg"
  [ -z "${WASHTUB_CI-}" ] || exit 1
  exit 77
done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$program" run "$root/cases/wash-2d/case.toml" -o "$work/run" -n 1 --no-report \
  --set domain.cells=64 --set 'time.end=0.2 s' --set 'output.frames=0.05 s' \
  --set 'output.window=["0.1 s", "0.2 s"]' >"$work/log" 2>&1 || fail "$(cat "$work/log")"

movie=$work/wash.mp4
"$program" movie "$work/run" -o "$movie" --size 320x180 --fps 10 --speed 0.25 --colour total

entries=stream=codec_name,width,height,pix_fmt,nb_frames
about=$(ffprobe -v error -show_entries $entries -of csv=p=0 "$movie")
[ "$about" = h264,320,180,yuv420p,9 ] || fail "the movie is $about"

greys=$(ffmpeg -loglevel error -ss 0.4 -i "$movie" -frames:v 1 -f rawvideo -pix_fmt gray - |
  od -An -v -tu1 -w1 | sort -u | wc -l)
[ "$greys" -gt 60 ] || fail "a picture of the movie has $greys shades of grey only"

same=$(ffmpeg -loglevel error -i "$movie" -f framemd5 - | grep -v '^#' | sort -u -k6 | wc -l)
[ "$same" -eq 9 ] || fail "only $same of 9 pictures of the movie differ"

"$program" movie "$work/run" -o "$work/none.mp4" --from '3 s' 2>"$work/said" &&
  fail "there is a movie from 3 s on"
grep -q 'there is nothing from 3 to 0.2 s' "$work/said" || fail "$(cat "$work/said")"
[ ! -e "$work/none.mp4" ] && [ ! -e "$work/none.mp4.part" ] || fail "a part of a movie is left"
echo "the movie is $about"
