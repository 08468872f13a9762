#!/usr/bin/env bash
# Grows the feather of hair-and-feather.pbrt: generate.sh <folder of the programs>.
cd "$(dirname "${BASH_SOURCE[0]}")" && "$1/feathergen" --preset rock-dove-green --seed 3 --out feather
