#!/usr/bin/env bash
# Makes the folder of a new solver, which builds and runs without changes. See --help.
set -euo pipefail

program=new_solver.sh
root=$(unset CDPATH; cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
# shellcheck source=tools/common.sh
source "$root/tools/common.sh"

starts=(template edge-based mmp chen-han)
longest_name=32
# Words of C++, this project and CMake that look like a name but are reserved.
reserved="alignas alignof and asm auto bitand bitor bool break case catch char class compl concept
  const consteval constexpr constinit continue decltype default delete do double else enum explicit
  export extern false float for friend goto if inline int long mutable namespace new noexcept not
  nullptr operator or private protected public register requires return short signed sizeof static
  struct switch template this throw true try typedef typeid typename union unsigned using virtual
  void volatile while xor
  all clean core closed-form geodesic help install package std test"

name=
from=template
outside=

usage() {
  cat <<EOF
Usage: ./new_solver.sh NAME [--from START] [--outside DIR]

Makes the folder of a new solver, solvers/variants/NAME: registered under NAME, exact, documented,
and built with everything else; no other file changes. A solver there runs only when it is named.

  NAME           lower case letters and digits, in words joined by hyphens: my-variant
  --from START   what to start from:
                   template     a whole solver in one short file, slow (default)
                   edge-based   a variant of edge-based propagation, by its policies
                   mmp          a variant of MMP, by its policies
                   chen-han     a variant of Chen and Han's algorithm, by its policies
  --outside DIR  into DIR and not into solvers/variants/: a project of its own, which makes a
                 plug-in with an installed geodesic-bench
  --help         this text

docs/adding-a-solver.md continues from there, to a variant that is verified and ranked.
EOF
}

take_word() {
  case $1 in
    --from)
      take_value "$@"
      [[ " ${starts[*]} " == *" $value "* ]] ||
        die "cannot start from '$value'; there are ${starts[*]}"
      from=$value
      ;;
    --outside) take_value "$@"; outside=$(realpath -m -- "$value") ;;
    -*) unknown_option "$1" ;;
    *)
      [[ -z $name ]] || die "one name at a time: '$name' or '$1'?"
      name=$1
      ;;
  esac
}

check_name() {
  [[ -n $name ]] || die "give the solver a name: ./new_solver.sh my-variant; --help has more"
  [[ $name =~ ^[a-z][a-z0-9]*(-[a-z0-9]+)*$ ]] ||
    die "invalid solver name '$name': use lower case letters and digits, in words joined by" \
      "hyphens, a letter first: my-variant"
  [[ ${#name} -le $longest_name ]] || die "'$name' is longer than $longest_name characters"
  [[ " ${reserved//$'\n'/ } " != *" $name "* ]] || die "'$name' is reserved"
  local taken
  taken=$(grep -rlF --include='*.cpp' ".name = \"$name\"" "$root/solvers") || return 0
  die "there is a solver named '$name' already, in ${taken#"$root/"}"
}

# write_instance SKELETON FILE: writes the skeleton with the names inserted.
write_instance() {
  sed -e "s/@name@/$name/g" -e "s/@folder@/$folder_name/g" "$1" >"$folder/$2"
}

# In the template's files the word "template" is only used as its name.
write_template() {
  local start="$root/solvers/variants/template"
  sed "s/\<template\>/$name/g" "$start/template.cpp" >"$folder/$folder_name.cpp"
  sed "s/\<template\>/$folder_name/g" "$start/CMakeLists.txt" >"$folder/CMakeLists.txt"
  sed -e "s/\<template\.cpp\>/$folder_name.cpp/g" -e "s/\<template\>/$name/g" "$start/README.md" \
    >"$folder/README.md"
}

write_variant() {
  local skeletons="$root/tools/new_solver"
  write_instance "$skeletons/$from/solver.cpp.in" "$folder_name.cpp"
  write_instance "$skeletons/$from/README.md.in" README.md
  write_instance "$skeletons/CMakeLists.txt.in" CMakeLists.txt
}

# An incomplete folder would make the next build fail.
remove_unfinished() {
  local status=$?
  if [[ $status -ne 0 ]]; then rm -rf "$folder"; fi
}

write_folder() {
  local taken folders=("$folder")
  if [[ -z $outside ]]; then folders+=("$root/solvers/$folder_name"); fi
  for taken in "${folders[@]}"; do
    [[ ! -e $taken ]] || die "$taken exists; nothing was changed"
  done
  local why
  why=$(mkdir -p "$folder" 2>&1) || die "cannot make $folder: ${why##*: }; nothing was changed"
  trap remove_unfinished EXIT
  if [[ $from == template ]]; then
    write_template
  else
    write_variant
  fi
  if [[ -n $outside ]]; then write_instance "$root/tools/new_solver/outside.txt.in" CMakeLists.txt; fi
}

rivals() {
  if [[ $from == template ]]; then echo ich; else echo "${from/chen-han/ich}"; fi
}

say_what_next() {
  local bench=build/release/geodesic-bench where=$root steps=() build
  if [[ -n $outside ]]; then
    where="any folder, with the one that geodesic-bench is installed in for PREFIX"
    printf -v build '%q' "$folder/build"
    bench="PREFIX/bin/geodesic-bench --plugin $build/lib$name.so"
    steps=("cmake -S ${build%/build} -B $build -DCMAKE_PREFIX_PATH=PREFIX && cmake --build $build"
      "PREFIX/share/geodesic-bench/datasets/fetch.py --corpus tiny")
  else
    steps=("./run_all.sh build fetch --corpus tiny")
  fi
  printf '%s is there; its README.md says what to change first. Next, from %s:\n' \
    "$folder" "$where"
  printf '  %s\n' "${steps[@]}" "$bench verify --solver $name" \
    "$bench rank --solver $name --against $(rivals) --corpus tiny"
}

parse_options "$@"
check_name
folder_name=${name//-/_}
folder=${outside:-$root/solvers/variants/$folder_name}
write_folder
say_what_next
