# Sourced by render.sh, test.sh and .ci/run, which share these steps. Needs bash and `root`, the
# folder of the repository.

packages=(cmake g++ ninja-build ccache libembree-dev libtbb-dev libopenexr-dev zlib1g-dev
  libxxhash-dev libpng-dev libjpeg-dev libfmt-dev libcli11-dev libgtest-dev libgmock-dev
  nlohmann-json3-dev pkg-config libcairo2-dev fonts-dejavu-core)

say() { printf '%s\n' "$*" >&2; }

# What dpkg does not know as installed; all of it where there is no dpkg.
missing_packages() {
  local installed
  installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' "${packages[@]}" 2>/dev/null || true)
  local package
  for package in "${packages[@]}"; do
    grep -qx "$package installed" <<<"$installed" || printf '%s ' "$package"
  done
}

# Tries to install what is missing; whatever happens, configure_and_build tells what is still amiss.
install_packages() {
  local missing
  missing=$(missing_packages)
  [ -z "$missing" ] && return
  if ! command -v apt-get >/dev/null; then
    say "This system has no apt-get: please see to it that the like of these Debian packages is" \
      "installed: ${missing% }. Trying to build with what there is."
    return
  fi
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      say "Packages are missing, and there is neither root nor sudo to install them. As root run:" \
        "apt-get install ${missing% }. Trying to build with what there is."
      return
    fi
    as_root=(sudo)
  fi
  say "Installing ${missing% }"
  # shellcheck disable=SC2086  # one word per package
  if ! { "${as_root[@]}" apt-get update -q &&
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
      apt-get install -q -y --no-install-recommends $missing; } >&2; then
    say "apt-get could not install everything. Trying to build with what there is."
  fi
}

# configure_and_build <preset> <folder> [target...]: configures once, then builds what has changed.
configure_and_build() {
  local preset=$1 build=$root/$2
  shift 2
  if ! command -v cmake >/dev/null; then
    say "cmake is missing: please install it (3.25 or newer)."
    return 1
  fi
  # A folder that was configured elsewhere (a moved or copied clone) cannot be used.
  if [ ! -f "$build/build.ninja" ] ||
    ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt"; then
    (cd "$root" && cmake --fresh --preset "$preset" --log-level=NOTICE) >&2 || return
  fi
  local targets=()
  [ $# -gt 0 ] && targets=(--target "$@")
  cmake --build "$build" --parallel "$(nproc)" "${targets[@]}" >&2
}
