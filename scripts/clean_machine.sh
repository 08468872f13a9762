#!/usr/bin/env bash
# scripts/clean_machine.sh SUITE [FOLDER]: tries the README's commands on a bare system. SUITE is a
# Debian release that debootstrap knows (bookworm, trixie). In FOLDER (default: /var/tmp/clean-machine)
# it makes FOLDER/SUITE anew, clones the committed state of this repository into it, and runs the
# commands of the README's section "Try it", word for word, as root. It ends with 0 where all of them
# did, no compiler warned, and the picture agrees with that of another suite tried before.
# FOLDER/SUITE.log has all output, FOLDER/SUITE.exr the picture; FOLDER/ccache-SUITE keeps compiled
# objects, so that a second run takes minutes. Needs root, debootstrap and some 6 GB of disk. The
# packages come from debootstrap's own mirror, or from the one that MIRROR names.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)

say() { printf '%s\n' "$*" >&2; }
fail() {
  say "clean_machine.sh: $*"
  exit 1
}

[ $# -ge 1 ] && [ $# -le 2 ] || fail "usage: scripts/clean_machine.sh bookworm|trixie [folder]"
suite=$1
[[ $suite =~ ^[a-z]+$ ]] || fail "$suite: not the name of a Debian release; bookworm and trixie are tried."
mkdir -p "${2:-/var/tmp/clean-machine}"
folder=$(cd "${2:-/var/tmp/clean-machine}" && pwd -P)
system=$folder/$suite log=$folder/$suite.log clone=/root/pbrt-feather
[ "$(id -u)" -eq 0 ] || fail "needs root, for debootstrap and chroot."
command -v debootstrap >/dev/null || fail "needs debootstrap: apt-get install debootstrap"
[ -z "$(git -C "$root" status --porcelain)" ] ||
  say "Note: only what is committed is tried; there are changes that are not."

# The commands as the README has them, without their comments.
mapfile -t commands < <(sed -n '/^## Try it/,/^## /{/^## /d;s/^    \(\.\/[^#]*[^# ]\) *\(#.*\)\?$/\1/p}' "$root/README.md")
[ "${#commands[@]}" -eq 2 ] || fail "README.md: expected two commands under \"Try it\", found ${#commands[@]}."

# inside COMMAND: in the new system; what is mounted is seen by this one command only.
inside() {
  unshare --mount --fork bash -c '
    mount --make-rprivate /
    mount -t proc proc "$1/proc" && mount --rbind /dev "$1/dev" || exit
    mount --bind "$2" "$1/root/.cache/ccache" || exit
    exec chroot "$1" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 \
      bash -c "cd $3 && $4"' _ "$system" "$folder/ccache-$suite" "$clone" "$1" </dev/null >>"$log" 2>&1
}

rm -rf --one-file-system "$system"
: >"$log"
say "$suite: a bare system in $system"
debootstrap --variant=minbase "$suite" "$system" ${MIRROR:+"$MIRROR"} >>"$log" 2>&1 ||
  fail "debootstrap failed, see $log"
mkdir -p "$folder/ccache-$suite" "$system/root/.cache/ccache"
git clone --quiet --no-hardlinks "$root" "$system$clone"

failed=
for command in "${commands[@]}"; do
  say "$suite: $command"
  start=$SECONDS code=0
  inside "$command" || code=$?
  say "$suite: $command ended with $code after $((SECONDS - start)) s"
  [ "$code" -eq 0 ] || failed=yes
done
warnings=$(grep -c ' warning: ' "$log" || true)
say "$suite: $warnings compiler warnings"
[ "$warnings" -eq 0 ] || failed=yes
inside 'g++ --version | head -n 1; dpkg-query -W "libembree*-?" libtbb12 "libfmt?*" libopenexr-dev libcli11-dev' || true
grep -E '^[0-9]+% tests passed|^Total Test time' "$log" | sed "s/^/$suite: /" >&2 || true

# The pictures of two systems have the same seed: they must not differ by more than pictures of two
# seeds do, whose mean squared difference is twice the noise's variance.
if cp "$system$clone/dove-swatch.exr" "$folder/$suite.exr" 2>/dev/null; then
  for other in "$folder"/*.exr; do
    [ "$other" = "$folder/$suite.exr" ] && continue
    cp "$other" "$system$clone/other-system.exr"
    say "$suite: its picture against that of $(basename "$other" .exr)"
    code=0
    inside 'build/bin/pbrt scenes/dove-swatch/dove-swatch.pbrt --seed 1 --quiet --outfile other-seed.exr &&
      noise=$(build/bin/imgtool diff dove-swatch.exr --reference other-seed.exr | sed -n "s/.*MSE //p") &&
      echo "mean squared difference of two seeds: $noise; of two systems:" &&
      build/bin/imgtool diff dove-swatch.exr --reference other-system.exr --difftol "$noise"' || code=$?
    [ "$code" -eq 0 ] || failed=yes
    tail -n 3 "$log" >&2
  done
fi
[ -z "$failed" ] || fail "$suite failed, see $log"
say "$suite: all well"
