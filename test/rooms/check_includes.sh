#!/bin/sh
# check_includes.sh <src/pbrt>: the rooms' includes against the rules of check_includes.awk.
rules=$(cd "$(dirname "$0")" && pwd -P)/check_includes.awk
cd "$1" && find . -name CMakeLists.txt -o -name '*.h' -o -name '*.cpp' | sort | xargs awk -f "$rules"
