#!/usr/bin/env bash
# Prints docs/COMPATIBILITY.md: what scenes and command lines can say here, and what pbrt-v4 has
# beyond it. Asked of the programs themselves, by mistakes and by --help, so that it cannot differ
# from what they do:
#
#     scripts/compatibility.sh > docs/COMPATIBILITY.md
#
# An argument: the folder of the programs (default: build/bin).
set -euo pipefail
export LC_ALL=C
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
bin=${1:-$root/build/bin}

# What pbrt says about a scene.
ask() { "$bin/pbrt" --quiet <<<"$1" 2>&1 || true; }

# The scene whose plug-in of this kind is named $2 and has the parameters $3.
scene() {
  case $1 in
    film) echo "Film \"$2\" $3 WorldBegin" ;;
    camera) echo "Camera \"$2\" $3 WorldBegin" ;;
    sampler) echo "Sampler \"$2\" $3 WorldBegin" ;;
    filter) echo "PixelFilter \"$2\" $3 WorldBegin" ;;
    integrator) echo "Integrator \"$2\" $3 WorldBegin" ;;
    accelerator) echo "Accelerator \"$2\" $3 WorldBegin" ;;
    shape) echo "WorldBegin Shape \"$2\" $3" ;;
    material) echo "WorldBegin Material \"$2\" $3" ;;
    'texture class')
      echo "WorldBegin Texture \"f\" \"float\" \"$2\" $3 Texture \"s\" \"spectrum\" \"$2\" $3" ;;
    light) echo "WorldBegin LightSource \"$2\" $3" ;;
    'area light') echo "WorldBegin AreaLightSource \"$2\" $3 Shape \"sphere\"" ;;
  esac
}
say() { ask "$(scene "$@")"; }

quoted() { grep -o '"[^"]*"' | tr -d '"'; }
once() { awk '!seen[$0]++'; }

# Names of a kind.
names() { say "$1" '?' '' | sed -n "s/.*unknown $1 \"?\"\. Known: //p" | head -n 1 | quoted; }
# Names of the parameters that are read beside $3.
parameters() {
  say "$1" "$2" "$3 \"normal ?\" [ 0 0 0 ]" |
    sed -n 's/.*unknown parameter "normal ?" of .*; known: //p' | head -n 1 | sed 's/, /\n/g'
}
# Lines `name choice choice ...`
choices() {
  local given='' name
  for name in $3; do given+=" \"string $name\" \"?\""; done
  say "$1" "$2" "$given" |
    sed -n 's/.*"string \([^"]*\)": "?" is not one of \([^;]*\).*/\1 \2/p' |
    sed 's/, / /g; s/ or / /g; s/"//g' | once
}
# Lines `type name`, of the names $3, read beside $4. Normals alone are no mistake.
types() {
  local given='' name told
  for name in $3; do given+=" \"normal $name\" [ 0 0 0 ]"; done
  told=$(say "$1" "$2" "$4 $given" | sed -n 's/.*"normal [^"]*": expected \(.*\)/\1/p' | quoted | once)
  for name in $3; do
    grep " $name\$" <<<"$told" || echo "normal $name"
  done
}

row() {
  local kind=$1 plug=$2 known of beside list='' name value type options
  known=$(parameters "$kind" "$plug" '')
  of=$(choices "$kind" "$plug" "$known")
  # What a choice brings with it.
  local all=$known typed
  typed=$(types "$kind" "$plug" "$known" '')
  while read -r name options; do
    for value in $options; do
      beside="\"string $name\" \"$value\""
      local more
      more=$(parameters "$kind" "$plug" "$beside" | grep -vxF "$all" || true)
      [ -z "$more" ] && continue
      all+=$'\n'$more
      typed+=$'\n'$(types "$kind" "$plug" "$more" "$beside")
    done
  done <<<"$of"
  for name in $all; do
    type=$(sed -n "s/ $name\$//p" <<<"$typed" | once | paste -sd/)
    value=$(sed -n "s/^$name //p" <<<"$of" | sed 's/ /, /g')
    list+="${list:+; }$type \`$name\`${value:+ ($value)}"
  done
  echo "| \`$plug\` | $list |"
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

Written by `scripts/compatibility.sh`, which asks the programs; a test compares. What the names mean, and
their defaults, is pbrt-v4's: see [PBRT_FORMAT.md](PBRT_FORMAT.md). Whatever else a scene names is refused with
a message.
TEXT
for kind in film camera sampler filter integrator accelerator shape material 'texture class' light \
  'area light'; do
  printf '\n## %s\n\n| name | parameters |\n|---|---|\n' "${kind^}"
  for plug in $(names "$kind"); do row "$kind" "$plug"; done
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
sed -n '/kNames{/,/};/p' "$root/src/pbrt/scene/option_directive.cpp" | quoted | while read -r name; do
  if ask "Option \"$name\" ? WorldBegin" | grep -q 'expected\|not one of'; then
    echo "- \`$name\`"
  else
    echo "- \`$name\`: no effect, and a warning"
  fi
done

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
