#!/bin/sh
# Refuses an #include of a room that the including room does not stand on.
# Which rooms a room stands on is read from src/CMakeLists.txt.
cd "$(dirname "$0")/../src" || exit 1

awk '
FNR == NR {  # washtub_room(coupling DEPENDS flow solid cloth)
  if ($0 !~ /^washtub_room\(/) next
  gsub(/washtub_room\(|\)|DEPENDS/, " ")
  room = $1
  rooms[room] = 1
  allowed[room, room] = 1
  for (i = 2; i <= NF; i++)
    for (known in rooms)
      if (allowed[$i, known]) allowed[room, known] = 1
  next
}
{  # flow/projection.cpp:7:#include "grid/mesh.hpp"
  split($0, part, "\"")
  split($0, place, ":")
  split(place[1], from, "/")
  split(part[2], to, "/")
  if (from[1] == "app" || (to[1] in rooms && allowed[from[1], to[1]])) next
  printf "%s:%s: %s must not include %s\n", place[1], place[2], from[1], part[2]
  failed = 1
}
END { exit failed }
' CMakeLists.txt - <<LIST
$(grep -rn --include='*.[ch]pp' '^#include "' -- */ | LC_ALL=C sort)
LIST
