#!/usr/bin/env bash
# Runs linters on the code. See --help.
set -euo pipefail

program=lint.sh
root=$(unset CDPATH; cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
# shellcheck source=tools/common.sh
source "$root/tools/common.sh"

install=yes
tidy=no

usage() {
  cat <<EOF
Usage: tools/lint.sh [OPTION...]

Checks the format of C++ files (clang-format), the types of Python files (mypy) and the scripts
(shellcheck). Ends with 1 when any of them complains.

Options:
  --tidy          clang-tidy on every C++ file too, compiled by itself by clang: takes half an hour
                  of two cores; in build/lint
  --no-install    never install a package: print the line that would, and stop
  --help          this text

Log: build/logs/lint.log
EOF
}

take_word() {
  case $1 in
    --tidy) tidy=yes ;;
    *) unknown_option "$1" ;;
  esac
}

format() {
  git ls-files '*.h' '*.cpp' | xargs clang-format --dry-run --Werror
}

# Checks each folder separately, because test files in different folders have the same names.
types() {
  local folder status=0
  for folder in results plots datasets gate peers python tools view tests/*/; do
    [[ -n $(git ls-files "$folder/*.py") ]] || continue
    "$python" -m mypy "$folder" || status=1
  done
  return $status
}

scripts() {
  shellcheck ./*.sh examples/*.sh tools/*.sh tests/*/*.sh .ci/*
}

# Does not use unity builds, so that definitions of one file are not visible in others.
tidy() {
  cmake -S . -B build/lint -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=clang++ \
    -DGEODESIC_UNITY=OFF -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
  cmake --build build/lint --target geodesic_build_info
  run-clang-tidy -quiet -p build/lint -j "$(processors)" "^$root/(geodesic|harness|meshes|python|solvers|tests)/"
}

parse_options "$@"
start_log lint
groups=(python lint)
if [[ $tidy == yes ]]; then groups+=(build test lint-tidy); fi
set_up "$install" "${groups[@]}"
cd "$root"
failed=()
for check in format types scripts $([[ $tidy == no ]] || echo tidy); do
  logged "$check" || failed+=("$check")
done
[[ ${#failed[@]} -eq 0 ]] || die "complaints of: ${failed[*]}; they are above and in $log"
