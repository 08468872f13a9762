#!/usr/bin/env bash
# scripts/denoiser.sh: installs Open Image Denoise for "imgtool denoise" and "pbrt --denoise": the
# Python package pyoidn 2.5.1, which holds the library (88 MB to fetch, 270 MB on disk), into a
# folder of its own, ~/.local/share/pbrt-feather/denoiser. Deleting that folder takes it away again.
set -euo pipefail

say() { printf '%s\n' "$*" >&2; }
folder=${XDG_DATA_HOME:-$HOME/.local/share}/pbrt-feather/denoiser
if ! command -v python3 >/dev/null || ! python3 -c 'import ensurepip, venv' 2>/dev/null; then
  say "denoiser.sh: needs Python with venv: apt-get install python3-venv"
  exit 1
fi
python3 -m venv "$folder"
"$folder/bin/pip" install --quiet --disable-pip-version-check pyoidn==2.5.1
say "Open Image Denoise is in $folder; \"imgtool denoise\" finds it there."
