#!/bin/sh
# Refuses a class that is explicitly instantiated more than once: C++ allows one definition of it
# in the whole program ([temp.spec.general]), and no compiler says so.
cd "$(dirname "$0")/../src" || exit 1

twice=$(grep -rhE --include='*.cpp' '^template (class|struct) ' -- */ | LC_ALL=C sort | uniq -d)
[ -z "$twice" ] && exit 0
echo "$twice" | while IFS= read -r line; do
  echo "instantiated more than once: $line"
  grep -rnF --include='*.cpp' "$line" -- */ | LC_ALL=C sort
done
exit 1
