#!/usr/bin/env bash
# Measures speed and error of the feather model, and writes docs/accuracy/*.csv, the plots
# docs/images/accuracy-*.png and the tables of docs/ACCURACY.md. Some two minutes; matplotlib goes
# into .venv. The machine should be quiet: times are the least of many rounds, but not magic.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"

[ -x .venv/bin/python ] || python3 -m venv .venv
.venv/bin/python -c 'import matplotlib' 2>/dev/null || .venv/bin/pip --quiet install matplotlib

[ -f build/build.ninja ] || cmake --preset release
cmake --build build --target bench_feather bench_sampling

mkdir -p docs/accuracy
feather='Material "featherbarbule"'
build/bin/bench_feather "$feather" --rounds 200 --pairs 2000 --csv docs/accuracy/default.csv
build/bin/bench_feather "$feather \"float spacing\" 2.5" --rounds 1 --pairs 1000 \
  --csv docs/accuracy/sparse.csv
build/bin/bench_feather "$feather \"float thickness\" 2000" --rounds 1 --pairs 1000 \
  --csv docs/accuracy/thick.csv
build/bin/bench_feather "$feather \"float opening\" 0.6" --rounds 1 --pairs 1000 \
  --csv docs/accuracy/bent.csv
build/bin/bench_feather "$feather \"float filmroughness\" 10" --rounds 200 --pairs 2000 \
  --csv docs/accuracy/rough.csv --rough-films docs/accuracy/rough-films.csv
build/bin/bench_feather "$feather \"float cellthickness\" 10 \"float celltilt\" .05 \"float cellbend\" .03
  \"float cellsacross\" 40 \"float cellsalong\" 25" --rounds 200 --pairs 50 \
  --csv docs/accuracy/cells.csv
build/bin/bench_sampling scenes/dove-swatch/dove-swatch.pbrt >docs/accuracy/sampling.csv
.venv/bin/python scripts/accuracy.py
