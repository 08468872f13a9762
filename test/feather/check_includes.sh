#!/bin/sh
# Fails if a file of the directory $1 includes anything but "sibling.h" and <std header>, or the
# compiler's own header of instructions.
wrong=$(grep -n '^ *# *include' "$1"/*.h "$1"/*.cpp |
    grep -vE '# *include ("[a-z_]+\.h"|<[a-z_]+>|<immintrin\.h>)$')
[ -z "$wrong" ] && exit 0
echo "not a sibling and not a standard header:" >&2
echo "$wrong" >&2
exit 1
