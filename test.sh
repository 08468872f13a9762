#!/usr/bin/env bash
# ./test.sh [ctest options]: installs what is missing, builds everything and runs all tests.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
source "$root/scripts/setup.sh"
trap 'exit 130' INT

install_packages
configure_and_build release build
ctest --test-dir "$root/build" --output-on-failure --parallel "$(nproc)" "$@"
