# shellcheck shell=bash disable=SC2034,SC2154
# Sourced by tools/common.sh: finds the packages of tools/packages.txt and installs the missing ones.

# find_python MODULE...: sets `python` to an interpreter that has all modules. They are searched but
# not imported, which takes a second. Debian's interpreter is first, because another python3 on the
# PATH does not have the modules of Debian's packages.
find_python() {
  local candidate
  local look='import sys, importlib.util as u; sys.exit(not all(map(u.find_spec, sys.argv[1:])))'
  while read -r candidate; do
    if [[ -x $candidate ]] && "$candidate" -c "$look" "$@" >/dev/null 2>&1; then
      python=$candidate
      return 0
    fi
  done < <(echo /usr/bin/python3; type -ap python3 || true)
  return 1
}

# listed GROUP...: prints the lines of packages.txt that a group needs.
listed() {
  local package found_by group wanted
  while read -r package found_by group; do
    for wanted in "$@"; do
      [[ $group == "$wanted" ]] && printf '%s %s\n' "$package" "$found_by"
    done
  done < <(grep -v '^#' "$root/tools/packages.txt")
  return 0
}

is_installed() {
  command -v dpkg-query >/dev/null || return 0  # not Debian: CMake will say what it lacks
  [[ $(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null) == installed ]]
}

# missing GROUP...: prints the packages to install, one per line.
missing() {
  local package found_by modules=()
  while read -r package found_by; do
    [[ $found_by == python:* ]] && modules+=("${found_by#python:}")
  done < <(listed "$@")
  local have_modules=true
  find_python "${modules[@]}" || have_modules=false
  while read -r package found_by; do
    case $found_by in
      command:*) command -v "${found_by#command:}" >/dev/null || echo "$package" ;;
      python:*) $have_modules || is_installed "$package" || echo "$package" ;;
      package) is_installed "$package" || echo "$package" ;;
    esac
  done < <(listed "$@")
}

# set_up INSTALL GROUP...: installs everything that the groups need, and sets `python`.
# INSTALL is "yes", or "no" to stop with the command that would install the missing packages.
set_up() {
  local install=$1 packages modules=()
  shift
  mapfile -t packages < <(missing "$@")
  [[ ${#packages[@]} -eq 0 ]] || install_packages "$install" "${packages[@]}"
  if [[ " $* " == *" build "* ]]; then
    want_optional "$install" optional
    check_cmake
  fi
  if [[ " $* " == *" gate "* ]]; then want_optional "$install" optional-gate; fi
  mapfile -t modules < <(listed "$@" | sed -n 's/.* python://p')
  [[ ${#modules[@]} -eq 0 ]] || find_python "${modules[@]}" || die "no python3 has ${modules[*]}; Debian's packages of them" \
    "belong to /usr/bin/python3, which is tried first"
}

check_cmake() {
  local version
  version=$(cmake --version | sed -n '1s/.* //p')
  [[ $(printf '%s\n' 3.25 "$version" | sort -V | head -n 1) == 3.25 ]] ||
    die "cmake $version is too old for the presets: 3.25 or later is needed"
}

# may_install: sets `as_root` to the prefix of commands that install packages.
may_install() {
  as_root=()
  command -v apt-get >/dev/null || return 1
  [[ $(id -u) == 0 ]] && return 0
  command -v sudo >/dev/null || return 1
  as_root=(sudo)
  sudo -n true 2>/dev/null || [[ -t 0 ]]  # a person at the terminal can give a password
}

install_packages() {
  local install=$1
  shift
  if [[ $install != yes ]] || ! may_install; then
    printf '%s: missing: %s\nInstall with:\n  sudo apt-get install --no-install-recommends %s\n' \
      "$program" "$*" "$*" >&2
    exit 1
  fi
  say "installing: $*"
  apt_install "$@" || {
    cat "$logs/apt.log" >&2
    die "apt-get could not install: $*"
  }
}

# want_optional INSTALL GROUP: installs its packages, or prints a line about the missing features.
want_optional() {
  local optional
  mapfile -t optional < <(missing "$2")
  [[ ${#optional[@]} -gt 0 ]] || return 0
  if [[ $1 == yes ]] && may_install; then
    say "installing (optional): ${optional[*]}"
    apt_install "${optional[@]}" && return 0
  fi
  say "without the optional ${optional[*]}: what uses it is left out"
}

# apt_install PACKAGE...: installs packages; the output of apt goes to build/logs/apt.log. Package
# lists are fetched if there are none, and again if they are out of date.
apt_install() {
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -y
    -o DPkg::Lock::Timeout=120 -o Acquire::Retries=2)
  local get=("${apt[@]}" install --no-install-recommends "$@")
  compgen -G '/var/lib/apt/lists/*_Packages*' >/dev/null || "${apt[@]}" update
  "${get[@]}" || { "${apt[@]}" update && "${get[@]}"; }
} >"$logs/apt.log" 2>&1
