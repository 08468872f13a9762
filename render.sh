#!/usr/bin/env bash
# ./render.sh [scene.pbrt] [pbrt options]: installs what is missing, builds, renders the scene and
# makes a PNG of the picture. Without a scene: scenes/dove-swatch. Without --outfile the picture goes
# to the current folder under the scene's name. A generate.sh beside the scene is run first; it makes
# the files that the scene includes.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
source "$root/scripts/setup.sh"
trap 'exit 130' INT

scene=$root/scenes/dove-swatch/dove-swatch.pbrt
if [ $# -gt 0 ] && [[ $1 != -* ]]; then
  scene=$1
  shift
fi

# The value of --outfile, in any spelling that pbrt takes; whether only text is asked for.
outfile=
only_text=
previous=
for word in "$@"; do
  name=${word%%=*}
  name=${name,,}
  name=${name//[-_]/}
  if [ "$previous" = outfile ]; then
    outfile=$word
    name=
  elif [[ $word == -* && $name == outfile && $word == *=* ]]; then
    outfile=${word#*=}
    name=
  elif [[ $word == -* && $name =~ ^(h|help|version)$ ]]; then
    only_text=yes
  elif [[ $word != -* ]]; then
    name=
  fi
  previous=$name
done

if [ "$previous" = outfile ]; then
  say "--outfile needs a value."
  exit 1
fi
if [ -z "$only_text" ] && [ ! -r "$scene" ]; then
  say "$scene: there is no such scene file."
  exit 1
fi
install_packages
generate=$(dirname "$scene")/generate.sh
targets=(pbrt imgtool)
[ -x "$generate" ] && targets+=(feathergen)
configure_and_build release build "${targets[@]}"
bin=$root/build/bin
[ -n "$only_text" ] && exec "$bin/pbrt" "$@"
[ -x "$generate" ] && "$generate" "$bin"

if [ -z "$outfile" ]; then
  outfile=$(basename "$scene")
  outfile=${outfile%.gz}
  outfile=${outfile%.pbrt}.exr
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
