#!/bin/sh
# What the build says of its commit: of a repository, of a changed one, of an archive inside another.
#   commit.sh CMAKE
# Exits with 77 (skipped) where git is missing, unless WASHTUB_CI is set.
set -eu

cmake=$1
root=$(cd "$(dirname "$0")/../.." && pwd)

command -v git >/dev/null || {
  echo "git is missing"
  [ -z "${WASHTUB_CI-}" ] || exit 1
  exit 77
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
own_git() { git -C "$work/tree" -c user.name=test -c user.email=test@localhost "$@"; }

# expect COMMIT SOURCE: what is written for a tree.
expect() {
  "$cmake" -DSOURCE="$work/$2" -DOUTPUT="$work/commit.cpp" -P "$root/cmake/Commit.cmake"
  grep -q "commit = \"$1\"" "$work/commit.cpp" || { echo "expected $1 in"; cat "$work/commit.cpp"; exit 1; }
}

mkdir -p "$work/tree/src" "$work/tree/cases" "$work/tree/archive/src"
echo '/archive/' >"$work/tree/.gitignore"
echo one >"$work/tree/src/a.cpp"
own_git init --quiet
own_git add .
own_git commit --quiet --message first
head=$(own_git rev-parse --short=12 HEAD)

expect "$head" tree
touch -d '2001-01-01' "$work/commit.cpp"
echo case >"$work/tree/cases/case.toml"
expect "$head" tree
[ "$(date -r "$work/commit.cpp" +%Y)" = 2001 ] || { echo "written although nothing changed"; exit 1; }

echo two >"$work/tree/src/b.cpp"
expect "$head-dirty" tree
rm "$work/tree/src/b.cpp"
echo three >"$work/tree/src/a.cpp"
expect "$head-dirty" tree
expect unknown tree/archive
