#!/usr/bin/env bash
# reference.sh scene.pbrt [runs, default 64]: writes reference.exr and reference-variance.exr beside
# the scene, which the test Scenes compares its pictures with: the mean of many small renders
# (pbrt --quick --spp 16) that differ in their seeds, and the variance of that mean.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
scene=$1 runs=${2:-64}
folder=$(cd "$(dirname "$scene")" && pwd -P)
[ ! -x "$folder/generate.sh" ] || "$folder/generate.sh" "$root/build/bin"
pictures=$(mktemp -d)
trap 'rm -rf "$pictures"' EXIT
for seed in $(seq 1 "$runs"); do
  "$root/build/bin/pbrt" "$scene" --quick --spp 16 --seed "$seed" --quiet \
    --outfile "$pictures/$seed.exr"
done
"$root/build/bin/imgtool" average --outfile "$folder/reference.exr" \
  --variance-outfile "$folder/reference-variance.exr" "$pictures"/*.exr
