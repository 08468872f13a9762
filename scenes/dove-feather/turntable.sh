#!/usr/bin/env bash
# Renders dove-feather.pbrt under eight light angles: turntable.sh <folder of the programs> [pbrt
# options]. Pictures turntable-1.exr to turntable-8.exr go to the current folder.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
bin=$(cd "$1" && pwd)
shift
[ -e "$here/feather/feather.pbrt" ] || "$here/generate.sh" "$bin"
scene=$(mktemp "$here/turntable-XXXXXX.pbrt")
trap 'rm -f "$scene"' EXIT
i=0
for angle in -20 -5 10 25 40 55 70 85; do
  i=$((i + 1))
  sed "s/Rotate 40 0 1 0/Rotate $angle 0 1 0/" "$here/dove-feather.pbrt" >"$scene"
  "$bin/pbrt" "$scene" --outfile "turntable-$i.exr" "$@"
done
