#!/usr/bin/env bash
# Runs a command in a fresh clone on a release of Debian, in a chroot. See --help.
set -euo pipefail

program=on_debian.sh
root=$(unset CDPATH; cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
# shellcheck source=tools/common.sh
source "$root/tools/common.sh"

roots=${GEODESIC_DEBIAN_ROOTS:-$root/build/debian}
mirror=
bare=
install=yes
release=
command=()
clone=/root/geodesic-bench  # in the chroot

# Variables with folders that have the same path in the chroot: to read, and to write.
read_folders=(GEODESIC_DATASETS_MIRROR GEODESIC_PEERS_MIRROR)
written_folders=(CCACHE_DIR GEODESIC_DATASETS)

usage() {
  cat <<EOF
Usage: tools/on_debian.sh [OPTION...] RELEASE COMMAND [WORD...]

Runs a command in a fresh clone of the checkout's HEAD, in a chroot with a release of Debian:
  tools/on_debian.sh trixie ./run_tests.sh
The chroot is made by debootstrap and kept, with what was installed in it; with --bare it is made anew,
and has only git and certificates. The clone stays in it, as $clone, until the next
command. Uncommitted changes are left out.

RELEASE is a name that debootstrap knows: bookworm (Debian 12), trixie (Debian 13).

Options:
  --bare          begin with a chroot that is made anew
  --roots DIR     folder of the chroots, one for each release (default: build/debian)
  --mirror URL    of Debian (default: the one that apt uses here)
  --no-install    never install debootstrap: print the line that would, and stop
  --help          this text

Environment:
  GEODESIC_DEBIAN_ROOTS      as --roots
  GEODESIC_DATASETS_MIRROR, GEODESIC_PEERS_MIRROR
                             a folder is seen in the chroot, read-only
  GEODESIC_DATASETS, CCACHE_DIR
                             a folder is seen in the chroot, to be written; with CCACHE_DIR ccache is
                             installed
Variables named GEODESIC_*, CMAKE_*, CCACHE_*, CC, CXX, TERM and *_proxy are passed on, no others.
The chroot gets apt's options and further certificates (/usr/local/share/ca-certificates) from here.

Needs root, git, and the right to mount (CAP_SYS_ADMIN; a container: --privileged): without them the
exit code is 77. All mounts are in a mount namespace of their own: they are gone when the command has
ended, however it ends. The exit code is the command's.
EOF
}

# Options end at the first other word, with which the command begins.
parse_options() {
  while [[ $# -gt 0 ]]; do
    case $1 in
      --help | -h) usage; exit 0 ;;
      --roots=* | --mirror=*) set -- "${1%%=*}" "${1#*=}" "${@:2}" ;;
      --bare) bare=yes; shift ;;
      --no-install) install=no; shift ;;
      --roots) take_value "$@"; roots=$value; shift 2 ;;
      --mirror) take_value "$@"; mirror=$value; shift 2 ;;
      -*) unknown_option "$1" ;;
      *) break ;;
    esac
  done
  [[ $# -ge 2 ]] || die "needs a release and a command; see $program --help"
  release=$1
  command=("${@:2}")
  [[ $release =~ ^[a-z]+$ ]] || die "a release is a name such as trixie, not '$release'"
  roots=$(absolute "$roots")
  chroot=$roots/$release
}

cannot() {
  printf '%s: %s\n' "$program" "$*" >&2
  exit 77
}

check_rights() {
  [[ $(id -u) == 0 ]] || cannot "needs root, for debootstrap, mount and chroot"
  unshare --mount true 2>/dev/null ||
    cannot "may not mount here (CAP_SYS_ADMIN is needed; a container: --privileged)"
}

# repository SUITE: prints the address from which apt of this machine gets the suite, or nothing.
repository() {
  apt-get indextargets --format "\$(CREATED_BY) \$(COMPONENT) \$(RELEASE) \$(REPO_URI)" 2>/dev/null |
    sed -n "s/^Packages main $1 //p" | head -n 1
}

host_release() {
  sed -n 's/^VERSION_CODENAME=//p' /etc/os-release
}

find_mirror() {
  [[ -z $mirror ]] || return 0
  mirror=$(repository "$(host_release)")
  [[ -n $mirror ]] || die "apt has no mirror of Debian on this machine: name one with --mirror"
}

make_chroot() {
  if [[ -n $bare ]]; then rm -rf --one-file-system "${chroot:?}"; fi
  [[ ! -f $chroot/etc/debian_version ]] || return 0
  find_mirror
  printf '%s: making %s with debootstrap\n' "$program" "$chroot"
  local partial=$chroot.partial
  rm -rf "$partial"
  debootstrap --variant=minbase --include=ca-certificates,git "$release" "$partial" "$mirror" \
    >"$roots/$release.log" 2>&1 || {
    tail -n 5 "$roots/$release.log" >&2
    die "debootstrap failed; all that it says is in $roots/$release.log"
  }
  write_sources "$partial"
  mv "$partial" "$chroot"
}

# write_sources CHROOT: writes apt's sources with the same suites, for the chroot's release.
write_sources() {
  local suite address
  printf 'deb %s %s main\n' "$mirror" "$release" >"$1/etc/apt/sources.list"
  for suite in updates security; do
    address=$(repository "$(host_release)-$suite")
    [[ -z $address ]] || printf 'deb %s %s-%s main\n' "$address" "$release" "$suite"
  done >>"$1/etc/apt/sources.list"
}

# Copies configuration that may change on this machine. Called each time.
copy_configuration() {
  local file
  for file in /etc/resolv.conf /etc/hosts; do
    [[ ! -f $file ]] || cp "$file" "$chroot/etc/"
  done
  apt-config dump 2>/dev/null | grep '^Acquire::' | grep -v '^Acquire::\(IndexTargets\|cdrom\)' \
    >"$chroot/etc/apt/apt.conf.d/90host" || true
  if compgen -G '/etc/apt/auth.conf.d/*' >/dev/null; then cp /etc/apt/auth.conf.d/* "$chroot/etc/apt/auth.conf.d/"; fi
  if compgen -G '/usr/local/share/ca-certificates/*.crt' >/dev/null; then
    mkdir -p "$chroot/usr/local/share/ca-certificates"
    cp /usr/local/share/ca-certificates/*.crt "$chroot/usr/local/share/ca-certificates/"
  fi
}

make_clone() {
  rm -rf "${chroot:?}$clone"
  git clone --quiet --no-hardlinks "$root" "$chroot$clone"
  git -C "$chroot$clone" -c advice.detachedHead=false checkout --quiet "$(git -C "$root" rev-parse HEAD)"
}

# bind SOURCE [OPTION]: mounts a file or folder of this machine in the chroot under the same path.
bind() {
  local target=$chroot$1
  if [[ -d $1 ]]; then
    mkdir -p "$target"
  else
    [[ -e $target ]] || : >"$target"
  fi
  mount --bind "$1" "$target"
  [[ -z ${2:-} ]] || mount -o "remount,bind,$2" "$target"
}

# Mounts everything that a command may need of a machine, without disks. Runs in a mount namespace.
mount_all() {
  mount --bind "$chroot" "$chroot"  # as the root of a machine it is a mount: unshare wants that
  mount -t proc proc "$chroot/proc"
  bind /sys ro
  mount -t tmpfs -o mode=755 tmpfs "$chroot/dev"
  local device name folder
  for device in null zero full random urandom tty; do bind "/dev/$device"; done
  for name in fd stdin=fd/0 stdout=fd/1 stderr=fd/2; do
    folder=/proc/self/fd
    [[ $name != *=* ]] || folder=/proc/self/${name#*=}
    ln -s "$folder" "$chroot/dev/${name%=*}"
  done
  mkdir "$chroot/dev/pts" "$chroot/dev/shm"
  mount -t devpts -o newinstance,ptmxmode=0666,mode=620,gid=5 devpts "$chroot/dev/pts"
  ln -s pts/ptmx "$chroot/dev/ptmx"
  mount -t tmpfs -o mode=1777 tmpfs "$chroot/dev/shm"
  mount -t tmpfs -o mode=1777 tmpfs "$chroot/run"
  for name in "${read_folders[@]}"; do
    [[ ${!name:-} != /* || ! -d ${!name} ]] || bind "${!name}" ro
  done
  for name in "${written_folders[@]}"; do
    [[ ${!name:-} != /* ]] || { mkdir -p "${!name}" && bind "${!name}"; }
  done
}

# in_chroot COMMAND...: runs a command with the environment of a fresh login and the forwarded variables.
in_chroot() {
  local passed=(HOME=/root LANG=C.UTF-8 CCACHE_BASEDIR="$clone"
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin) name
  while read -r name; do
    case $name in
      GEODESIC_DEBIAN_ROOTS | CCACHE_BASEDIR) ;;
      GEODESIC_* | CMAKE_* | CCACHE_* | CC | CXX | TERM | *_proxy | *_PROXY) passed+=("$name=${!name}") ;;
    esac
  done < <(compgen -e)
  chroot "$chroot" env -i "${passed[@]}" "$@"
}

prepare() {
  if compgen -G '/usr/local/share/ca-certificates/*.crt' >/dev/null; then
    in_chroot update-ca-certificates >"$roots/$release.log" 2>&1 ||
      die "update-ca-certificates failed: see $roots/$release.log"
  fi
  [[ -n ${CCACHE_DIR:-} ]] || return 0
  in_chroot sh -c 'command -v ccache >/dev/null ||
    { apt-get update && apt-get install -y --no-install-recommends ccache; }' >"$roots/$release.log" 2>&1 ||
    die "cannot install ccache: see $roots/$release.log"
}

# Runs in the namespace, in which this script calls itself with the first word --inside.
inside() {
  chroot=$roots/$release
  mount_all
  prepare
  # shellcheck disable=SC2016 # expanded in the chroot
  in_chroot sh -c 'cd "$1" && shift && exec "$@"' sh "$clone" "${command[@]}"
}

if [[ ${1:-} == --inside ]]; then
  shift
  parse_options "$@"
  inside
  exit
fi
parse_options "$@"
check_rights
start_log on_debian
set_up "$install" debian
mkdir -p "$roots"
exec 9>"$roots/$release.lock"
flock --nonblock 9 || die "$chroot is in use"
make_chroot
[[ -z $(git -C "$root" status --porcelain) ]] || printf '%s: uncommitted changes are left out\n' "$program" >&2
copy_configuration
make_clone
exec unshare --mount --propagation private "${BASH_SOURCE[0]}" --inside --roots "$roots" "$release" "${command[@]}"
