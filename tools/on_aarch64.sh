#!/usr/bin/env bash
# Runs the solvers on an emulated aarch64 processor. See --help.
set -euo pipefail

program=on_aarch64.sh
root=$(unset CDPATH; cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
# shellcheck source=tools/common.sh
source "$root/tools/common.sh"

meshes=1000
native=$root/build/release/geodesic-bench
build=$root/build/aarch64
export SYSROOT=$build/sysroot
packages=(libhwy-dev libopenmesh-dev libbenchmark-dev libssl-dev zlib1g-dev libgtest-dev libcli11-dev
  nlohmann-json3-dev libboost-dev libmpfi-dev)

solvers=edge-based,edge-based-approximate,mmp,fwp-mmp,ich,fwp-ch,dijkstra,virtual-source,straight-graph,saddle-vertex-graph,steiner,fast-marching,flip-out

usage() {
  cat <<EOF
Usage: tools/on_aarch64.sh [OPTION...]

Compiles for aarch64 by Debian's cross compiler, and runs with an emulator (qemu-user):
  - the properties of every solver (conformance_tests), and the tests of its vector kernels
  - all solvers on random meshes (as verify --random)
  - all solvers on six meshes: the same bits and counters as the program of this machine
Libraries come from Debian's archive, into build/aarch64/sysroot. CGAL is left out.

Options:
  --meshes N       random meshes (default: 1000)
  --native FILE    program of this machine to compare with (default: build/release/geodesic-bench)
  --help           this text

Needs the packages g++-aarch64-linux-gnu, qemu-user and ninja-build, and the meshes of the corpora
quick and frontier (./run_all.sh fetch). Exit codes: 0 all the same and right, 1 otherwise.
EOF
}

take_word() {
  case $1 in
    --meshes) take_number "$@"; meshes=$value ;;
    --native) take_value "$@"; native=$value ;;
    *) unknown_option "$1" ;;
  esac
}

check_needs() {
  local tool
  for tool in aarch64-linux-gnu-g++ qemu-aarch64 ninja apt-get dpkg; do
    type -P "$tool" >/dev/null || die "needs $tool; see $program --help"
  done
  [[ -x $native ]] || die "no program $native to compare with: ./run_all.sh build makes one"
}

# Runs apt-get for arm64 with its own state. From this machine it only uses the address of the archive.
apt_of_arm() {
  apt-get -qq -o APT::Architecture=arm64 -o APT::Architectures::=arm64 -o Dir::State="$build/apt" \
    -o Dir::State::status="$build/apt/status" -o Dir::Cache="$build/apt" -o Debug::NoLocking=1 \
    -o APT::Sandbox::User= "$@"
}

make_sysroot() {
  [[ ! -d $SYSROOT ]] || return 0
  mkdir -p "$build/apt/lists/partial" "$build/apt/archives/partial" "$SYSROOT.partial"
  : >"$build/apt/status"
  apt_of_arm update
  apt_of_arm install --yes --no-install-recommends --download-only "${packages[@]}"
  local package
  for package in "$build"/apt/archives/*.deb; do dpkg -x "$package" "$SYSROOT.partial"; done
  mv "$SYSROOT.partial" "$SYSROOT"
}

emulated() {
  qemu-aarch64 -L "$SYSROOT" "$@"
}

# Runs the process that `verify --random` starts, because an emulated program cannot start it.
check_random_meshes() {
  local properties=(distances-equal-the-reference paths-begin-in-faces-and-on-edges-too
    sources-in-faces-and-on-edges-equal-inserted-vertices
    targets-in-faces-and-on-edges-equal-inserted-vertices)
  local mesh property solver asks=()
  for ((mesh = 0; mesh < meshes; mesh++)); do
    for property in "${properties[@]}"; do
      for solver in ${solvers//,/ }; do
        asks+=("{\"solver\": \"$solver\", \"property\": \"$property\", \"seconds\": 600,
          \"random\": {\"seed\": 1, \"number\": $mesh}}")
      done
    done
  done
  (IFS=,; echo "{\"vectors\": \"auto\", \"scratch\": \"$build\",
    \"log\": \"$build/random.jsonl\", \"asks\": [${asks[*]}]}") >"$build/random.json"
  emulated "$build/geodesic-bench" check-cases "$build/random.json"
  ! grep '"outcome":[345]' "$build/random.jsonl" >&2 || die "solvers are wrong on random meshes"
}

parse_options "$@"
check_needs
make_sysroot
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_TOOLCHAIN_FILE="$root/tools/aarch64.cmake" >"$build/configure.log"
ninja -C "$build" geodesic-bench conformance_tests edge_based_test
emulated "$build/tests/edge_based_test" --gtest_brief=1
emulated "$build/tests/conformance_tests" --gtest_brief=1
check_random_meshes
"$root/tools/same_bits.py" "$native" "qemu-aarch64 -L $SYSROOT $build/geodesic-bench" \
  --meshes terrain,torus,needles,spot,fandisk,rocker-arm \
  --solvers "$solvers"
