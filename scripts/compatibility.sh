#!/usr/bin/env bash
# Prints docs/COMPATIBILITY.md: what scenes and command lines can say here, and what pbrt-v4 has
# beyond it. Asked of the programs themselves, by --explain and --help, so that it cannot differ from
# what they do:
#
#     scripts/compatibility.sh > docs/COMPATIBILITY.md
#
# An argument: the folder of the programs (default: build/bin).
set -euo pipefail
export LC_ALL=C
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
bin=${1:-$root/build/bin}

quoted() { grep -o '"[^"]*"' | tr -d '"'; }

# Names of a kind of plug-in; nothing of other kinds.
names() {
  case $1 in
    'option of '* | 'command of '* | medium) ;;
    'texture class') "$bin/pbrt" --explain 'float texture' ;;
    *) "$bin/pbrt" --explain "$1" ;;
  esac
}

# The table of src/pbrt/util/upstream.cpp, a row a line: kind, name and advice, between tabs; quotes in
# them as `.
rows=$(tr -s ' \n' '  ' < "$root/src/pbrt/util/upstream.cpp" | grep -o 'UpstreamName{"[^}]*}' |
  sed 's/\\"/`/g; s/" "//g; s/^UpstreamName{"//; s/"}$//; s/", "/\t/g')

# What pbrt-v4 has beyond: names of this kind, but for those built since.
missing() {
  awk -F '\t' -v kind="$1" '$1 == kind { print $2 "\t" $3 }' <<< "$rows" |
    grep -vE "^($(names "$1" | paste -sd '|'))"$'\t' || true
}

# Their names in one line.
listed() { cut -f 1 | sed 's/.*/`&`/' | paste -sd, | sed 's/,/, /g'; }

cat <<'TEXT'
# What exists here, and what pbrt-v4 has beyond it

Written by `scripts/compatibility.sh`, which asks the programs; a test compares. The parameters of each name are
in [REFERENCE.md](REFERENCE.md); what they do is pbrt-v4's: see [PBRT_FORMAT.md](PBRT_FORMAT.md). Whatever else a
scene names is refused with a message.
TEXT
for kind in film camera sampler filter integrator accelerator shape material medium 'texture class' \
  light 'area light'; do
  here=$(names "$kind" | listed)
  printf '\n## %s\n\n%s.\n' "${kind^}" "${here:-None}"
  case $kind in
    integrator)
      printf '\n`path` renders in the place of, with a warning: %s.\n' \
        "$(grep -o 'StandIn{"[a-z]*"' "$root/src/pbrt/integrators/stand_ins.cpp" | quoted | listed)" ;;
  esac
  beyond=$(missing "$kind" | awk -F '\t' '{ print "- `" $1 "`. " $2 ($2 == "" ? "" : ".") }')
  [ -z "$beyond" ] || printf '\nNot built here:\n\n%s\n' "$beyond"
done

printf '\n## Parameters of pbrt-v4 that are not built here\n\n'
awk -F '\t' '$1 ~ /`/ { print "- " $1 ": `" $2 "`. " $3 ($3 == "" ? "" : ".") }' <<< "$rows"

printf '\n## Directives\n\n'
grep -o 'Directive{"[A-Za-z]*"' "$root/src/pbrt/scene/directives.cpp" | quoted | sed 's/.*/`&`/' |
  paste -sd, | sed 's/,/, /g'

printf '\n## Option directives\n\n'
"$bin/pbrt" --explain option | sed -n '2,$s/^\([a-z]\+\) .*/- `\1`/p'
sed -n '/kIgnored{/,/};/p' "$root/src/pbrt/scene/option_directive.cpp" | quoted |
  sed 's/.*/- `&`: no effect, and a warning/'

printf '\n## Command lines\n\nNot built here, of pbrt: %s; of imgtool: %s.\n' \
  "$(missing 'option of pbrt' | listed)" "$(missing 'command of imgtool' | listed)"
for program in pbrt imgtool bsdftool feathergen 'feathergen neck'; do
  # shellcheck disable=SC2086
  set -- $program
  commands=$("$bin/$1" --help | sed -n 's/^  \([a-z]\+\)  .*/\1/p')
  case $1 in
    imgtool | bsdftool)
      for command in $commands; do
        printf '\n```\n'
        "$bin/$1" help "$command"
        printf '```\n'
      done ;;
    *)
      printf '\n```\n'
      "$bin/$1" "${@:2}" --help | sed '/^parameters for --set/,$d'
      printf '```\n' ;;
  esac
done
