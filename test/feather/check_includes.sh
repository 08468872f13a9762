#!/bin/sh
# Fails if a file of the directory $1 includes anything but "sibling.h" and <std header>.
wrong=$(grep -n '^ *# *include' "$1"/*.h "$1"/*.cpp |
    grep -vE '# *include ("[a-z_]+\.h"|<[a-z_]+>)$')
[ -z "$wrong" ] && exit 0
echo "not a sibling and not a standard header:" >&2
echo "$wrong" >&2
exit 1
