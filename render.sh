#!/usr/bin/env bash
# ./render.sh [--generate] [scene.pbrt] [pbrt options]: installs what is missing, builds, renders the
# scene and makes a PNG of the picture. Without a scene: scenes/dove-swatch. Without --outfile the
# picture goes to the current folder under the scene's name. A generate.sh beside a scene of this
# repository is run first; it makes the files that the scene includes. Beside any other scene it is
# run with --generate only, for it may do anything.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
source "$root/scripts/setup.sh"
trap 'exit 130' INT

# A name that no program takes for an option.
as_path() { case $1 in -*) printf './%s' "$1" ;; *) printf '%s' "$1" ;; esac; }

may_generate=
if [ "${1-}" = --generate ]; then
  may_generate=yes
  shift
fi
scene=$root/scenes/dove-swatch/dove-swatch.pbrt
if [ $# -gt 0 ] && [[ $1 != -* || ($1 =~ \.pbrt(\.gz)?$ && -f ./$1) ]]; then
  scene=$(as_path "$1")
  shift
fi

# The value of --outfile, in any spelling that pbrt takes; whether only text is asked for.
outfile=
only_text=
previous=
words=()
for word in "$@"; do
  name=${word%%=*}
  name=${name,,}
  name=${name//[-_]/}
  if [ "$previous" = outfile ]; then
    word=$(as_path "$word")
    outfile=$word
    name=
  elif [[ $word == -* && $name == outfile && $word == *=* ]]; then
    outfile=$(as_path "${word#*=}")
    word=--outfile=$outfile
    name=
  elif [ "$word" = --generate ]; then
    may_generate=yes
    continue
  elif [[ $word == -* && $name =~ ^(h|help|version)$ ]]; then
    only_text=yes
  elif [[ $word != -* ]]; then
    name=
  fi
  words+=("$word")
  previous=$name
done
set -- "${words[@]}"

if [ "$previous" = outfile ]; then
  say "--outfile needs a value."
  exit 1
fi
if [ -z "$only_text" ] && [ ! -r "$scene" ]; then
  say "$scene: there is no such scene file."
  exit 1
fi
install_packages
folder=$(dirname "$scene")
generate=
if [ -z "$only_text" ] && [ -x "$folder/generate.sh" ]; then
  case $may_generate$(cd "$folder" && pwd -P)/ in
    yes* | "$root"/scenes/*) generate=$folder/generate.sh ;;
    *)
      say "$folder/generate.sh is not run, for it is not of this repository and may do anything." \
        "If you trust it: ./render.sh --generate $scene"
      ;;
  esac
fi
targets=(pbrt imgtool)
[ -n "$generate" ] && targets+=(feathergen)
configure_and_build release build "${targets[@]}"
bin=$root/build/bin
[ -n "$only_text" ] && exec "$bin/pbrt" "$@"
[ -n "$generate" ] && "$generate" "$bin"

if [ -z "$outfile" ]; then
  outfile=$(basename "$scene")
  outfile=${outfile%.gz}
  outfile=$(as_path "${outfile%.pbrt}.exr")
  set -- "$@" --outfile "$outfile"
fi
"$bin/pbrt" "$scene" "$@"

full_path() { printf '%s/%s' "$(cd "$(dirname "$1")" && pwd -P)" "$(basename "$1")"; }
echo "picture: $(full_path "$outfile")"
case ${outfile,,} in
  *.png) ;;
  *.exr | *.pfm)
    png=${outfile%.*}.png
    "$bin/imgtool" convert "$outfile" --outfile "$png"
    echo "PNG:     $(full_path "$png")"
    ;;
esac
