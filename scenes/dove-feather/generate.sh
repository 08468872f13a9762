#!/usr/bin/env bash
# Grows the feather of dove-feather.pbrt: generate.sh <folder of the programs>.
cd "$(dirname "${BASH_SOURCE[0]}")" && "$1/feathergen" --preset rock-dove-neck --seed 7 --out feather
