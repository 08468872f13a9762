#!/bin/sh
# check_includes.sh folder [sibling room]: fails if a file of the folder includes anything but
# "sibling.h", <std header> or the compiler's own header of instructions, or "../<room>/file.h".
room=${2:-no-room}
wrong=$(grep -n '^ *# *include' "$1"/*.h $(ls "$1"/*.cpp 2>/dev/null) |
    grep -vE "# *include (\"(\.\./$room/)?[a-z_0-9]+\.h\"|<[a-z_]+>|<immintrin\.h>)$")
[ -z "$wrong" ] && exit 0
echo "neither a sibling nor a standard header:" >&2
echo "$wrong" >&2
exit 1
