#!/usr/bin/env bash
# Grows the feathers of dove-neck.pbrt: generate.sh <folder of the programs>.
cd "$(dirname "${BASH_SOURCE[0]}")" && "$1/feathergen" neck --seed 7 --textures ptex --out feathers
