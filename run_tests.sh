#!/usr/bin/env bash
# Runs all tests: C++ with CTest, Python with pytest. See --help.
set -euo pipefail

program=run_tests.sh
root=$(unset CDPATH; cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
# shellcheck source=tools/common.sh
source "$root/tools/common.sh"

presets=(release ci debug)
preset=release
install=yes
tests=run_tests

usage() {
  cat <<EOF
Usage: ./run_tests.sh [OPTION...]

Builds everything and runs every test: C++ with CTest, Python with pytest.

Options:
  --preset NAME   release (default: what run_all.sh builds), ci (the same, warnings are
                  errors) or debug (address and undefined-behaviour sanitizers; slow)
  --nightly       in place of these, only the tests that take too long for every change
  --no-install    never install a package: print the line that would, and stop
  --help          this text

Missing packages are installed with apt, as root or with sudo. Log: build/logs/run_tests.log;
results in JUnit's format: build/logs/ctest.xml and build/logs/pytest.xml, and
build/NAME/tests/reports with every case of the C++ programs
EOF
}

take_word() {
  case $1 in
    --preset) take_preset "$@" ;;
    --nightly) tests=run_nightly ;;
    *) unknown_option "$1" ;;
  esac
}

# Runs pytest even if CTest fails. Two jobs per processor, because tests of programs wait half of the time.
run_tests() {
  local failed=0
  rm -rf "$logs/ctest.xml" "$logs/pytest.xml" "$root/build/$preset/tests/reports"
  (cd "$root" && logged ctest --preset "$preset" --parallel "$((2 * $(processors)))" \
    --output-junit "$logs/ctest.xml") || failed=1
  run_pytest --junitxml "$logs/pytest.xml" || failed=1
  return $failed
}

run_nightly() {
  want_optional "$install" optional-nightly
  run_pytest -m nightly
}

run_pytest() {
  (cd "$root" && GEODESIC_BENCH="$root/build/$preset/geodesic-bench" \
    logged "$python" -m pytest -q tests --numprocesses "$(processors)" "$@")
}

parse_options "$@"
start_log run_tests
set_up "$install" python build test
build_preset "$preset" -DGEODESIC_TESTS=ON
logged "$python" "$root/view/three.py" || say "without three.js: the tests of view are skipped"
"$tests"
