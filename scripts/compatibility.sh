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
    'option of '* | 'command of '*) ;;
    'texture class') "$bin/pbrt" --explain 'float texture' ;;
    *) "$bin/pbrt" --explain "$1" ;;
  esac
}

# What pbrt-v4 has beyond: names of this kind, but for those built since.
missing() {
  grep -o 'UpstreamName{.*}' "$root/src/pbrt/util/upstream.cpp" |
    grep -vF -f <(names "$1" | sed "s/.*/\"$1\", \"&\"/") | sed 's/\\"/`/g' |
    sed -n "s/UpstreamName{\"$1\", \"\([^\"]*\)\", \"\([^\"]*\)\"}/\`\1\`\2/p" |
    sed 's/`\([a-z]\+\)$/` (near it: `\1`)/' | paste -sd, | sed 's/,/, /g'
}

cat <<'TEXT'
# What exists here, and what pbrt-v4 has beyond it

Written by `scripts/compatibility.sh`, which asks the programs; a test compares. The parameters of each name are
in [REFERENCE.md](REFERENCE.md); what they do is pbrt-v4's: see [PBRT_FORMAT.md](PBRT_FORMAT.md). Whatever else a
scene names is refused with a message.
TEXT
for kind in film camera sampler filter integrator accelerator shape material 'texture class' light \
  'area light'; do
  printf '\n## %s\n\n%s.\n' "${kind^}" "$(names "$kind" | sed 's/.*/`&`/' | paste -sd, | sed 's/,/, /g')"
  beyond=$(missing "$kind")
  [ -z "$beyond" ] || printf '\nNot built here: %s.\n' "$beyond"
done

printf '\n## Parameters of pbrt-v4 that are not built here\n\n'
grep -o 'UpstreamName{.*}' "$root/src/pbrt/util/upstream.cpp" | grep '\\"' | sed 's/\\"/`/g' |
  sed 's/UpstreamName{"\([^"]*\)", "\([^"]*\)".*/- \1: `\2`/'

printf '\n## Directives\n\n'
grep -o 'Directive{"[A-Za-z]*"' "$root/src/pbrt/scene/directives.cpp" | quoted | sed 's/.*/`&`/' |
  paste -sd, | sed 's/,/, /g'

printf '\n## Option directives\n\n'
"$bin/pbrt" --explain option | sed -n '2,$s/^\([a-z]\+\) .*/- `\1`/p'
sed -n '/kIgnored{/,/};/p' "$root/src/pbrt/scene/option_directive.cpp" | quoted |
  sed 's/.*/- `&`: no effect, and a warning/'

printf '\n## Command lines\n\nNot built here, of pbrt: %s; of imgtool: %s.\n' \
  "$(missing 'option of pbrt')" "$(missing 'command of imgtool')"
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
