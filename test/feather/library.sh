#!/bin/sh
# library.sh compiler document source-folder work-folder: compiles the document's C++ program with
# nothing but the source folder as include path, runs it, and checks that it prints four numbers
# that are neither negative nor all 0.
set -e
mkdir -p "$4"
sed -n '/^```cpp$/,/^```$/p' "$2" | sed '1d;$d' > "$4/library.cpp"
"$1" -std=c++20 -O1 -Wall -Wextra -Werror -Wno-psabi -I "$3" "$4/library.cpp" -o "$4/library"
"$4/library" > "$4/library.txt"
cat "$4/library.txt"
awk '$1 >= 0 { n++; sum += $1 } END { exit !(NR == 4 && n == 4 && sum > 0) }' "$4/library.txt"
