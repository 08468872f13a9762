#!/usr/bin/env bash
# bench/run.sh [options]: compares this renderer with Mitsuba 3 and bare Embree, measures cost against
# size, and writes bench/RESULTS.md and the table in README.md; some 25 minutes on two quiet cores the
# first time, less when the references in build/bench exist. `bench/run.sh --help` lists options.
# Ends with 1 if pictures do not agree.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
source "$root/scripts/setup.sh"
trap 'exit 130' INT

find_llvm() {
  local library
  for library in "${DRJIT_LIBLLVM_PATH:-}" /usr/lib/*/libLLVM.so.19* /usr/lib/llvm-19/lib/libLLVM*.so*; do
    [ -f "$library" ] && printf '%s\n' "$library" && return
  done
  return 1
}

install_packages
configure_and_build release build pbrt bench_rays imgtool feathergen
venv=$root/build/venv-bench
[ -x "$venv/bin/python" ] || python3 -m venv "$venv"
if ! "$venv/bin/python" -c 'import mitsuba, numpy, OpenEXR, flip_evaluator, matplotlib' 2>/dev/null; then
  "$venv/bin/pip" install --quiet mitsuba==3.9.1 numpy OpenEXR flip-evaluator matplotlib
fi

# Mitsuba's llvm variants need LLVM 16 or newer; this one is known to work.
packages=(libllvm19)
llvm=$(find_llvm) || { install_packages && llvm=$(find_llvm); } || llvm=
options=("$@")
if [ -n "$llvm" ]; then
  export DRJIT_LIBLLVM_PATH=$llvm
else
  say "There is no libLLVM 19: Mitsuba's llvm_ad_spectral is left out."
  options+=(--no-llvm)
fi
cd "$root/bench"
exec "$venv/bin/python" -m compare "${options[@]}"
