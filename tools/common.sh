# shellcheck shell=bash
# Sourced by the scripts at the root: messages, logging, options, and building.
# The caller sets -euo pipefail, `program` (its name, for messages) and `root` (the checkout).
: "${program:?}" "${root:?}"

logs="$root/build/logs"
# shellcheck source=tools/setup.sh
source "$root/tools/setup.sh"

die() {
  printf '%s: %s\n' "$program" "$*" >&2
  exit 1
}

# start_log NAME: from now on `say` and `logged` write to the terminal and to build/logs/NAME.log.
start_log() {
  log="$logs/$1.log"
  { mkdir -p "$logs" && : >"$log"; } 2>/dev/null ||
    die "cannot write $log; check who owns the checkout, and the space on its disk"
}

say() {
  printf '%s\n' "$*" | tee -ia "$log"
}

# Ctrl-C ends the command; the rest of its output is still logged (tee -i).
logged() {
  "$@" 2>&1 | tee -ia "$log"
}

# parse_options WORD...: calls the script's `take_word WORD [NEXT...]` for each word, which sets `taken`
# to 2 if it also uses the next word. --option=value counts as two words. Handles --help and, in a
# script with the variable `install`, --no-install.
parse_options() {
  local taken value
  while [[ $# -gt 0 ]]; do
    taken=1
    case $1 in
      --*=*) set -- "${1%%=*}" "${1#*=}" "${@:2}"; continue ;;
      --help | -h) usage; exit 0 ;;
      --no-install) [[ -n ${install:-} ]] || unknown_option "$1"; install=no ;;
      *) take_word "$@" ;;
    esac
    shift "$taken"
  done
}

# take_value OPTION [VALUE...]: sets `value` to the required value of an option, and sets `taken`.
take_value() {
  [[ $# -ge 2 && -n $2 && $2 != --* ]] || die "$1 needs a value; see $program --help"
  value=$2
  taken=2
}

# take_number OPTION [VALUE...]: like take_value, for a positive integer.
take_number() {
  take_value "$@"
  [[ $value =~ ^[1-9][0-9]{0,6}$ ]] || die "$1 must be a positive integer, not '$value'"
}

# take_preset OPTION [VALUE...]: sets `preset` to one of the script's `presets`, and sets `taken`.
take_preset() {
  take_value "$@"
  # shellcheck disable=SC2154 # the script has them
  [[ " ${presets[*]} " == *" $value "* ]] || die "unknown preset $value; presets are ${presets[*]}"
  preset=$value
}

# unknown_option WORD: names the option of the script's usage that is nearest, if one is near.
unknown_option() {
  local least=$((1 + ${#1} / 4)) nearest='' word
  while read -r word; do
    edit_distance "$1" "$word" "$least"
    if [[ $distance -le $least ]]; then least=$((distance - 1)) nearest=$word; fi
  done < <(usage | grep -oE -- '--[a-z][a-z-]*')
  die "unknown option $1${nearest:+ (did you mean $nearest?)}; see $program --help"
}

# edit_distance A B MOST: sets `distance` to the number of insertions, deletions, substitutions and
# swaps of neighbours that turn A into B, or to more than MOST.
edit_distance() {
  local a=$1 b=$2 i j cost above=() before=()
  distance=$(($3 + 1))
  [[ $((${#a} - ${#b})) -le $3 && $((${#b} - ${#a})) -le $3 ]] || return 0
  local edits=()
  for ((j = 0; j <= ${#b}; j++)); do edits[j]=$j; done
  for ((i = 1; i <= ${#a}; i++)); do
    above=("${edits[@]}")
    edits[0]=$i
    for ((j = 1; j <= ${#b}; j++)); do
      [[ ${a:i-1:1} == "${b:j-1:1}" ]] && cost=0 || cost=1
      edits[j]=$((above[j - 1] + cost))
      ((edits[j - 1] + 1 >= edits[j])) || edits[j]=$((edits[j - 1] + 1))
      ((above[j] + 1 >= edits[j])) || edits[j]=$((above[j] + 1))
      if [[ $i -gt 1 && $j -gt 1 && ${a:i-1:1} == "${b:j-2:1}" && ${a:i-2:1} == "${b:j-1:1}" ]]; then
        ((before[j - 2] + 1 >= edits[j])) || edits[j]=$((before[j - 2] + 1))
      fi
    done
    before=("${above[@]}")
  done
  distance=${edits[${#b}]}
}

# absolute PATH: prints the absolute path, relative to the folder in which the user started the script.
absolute() {
  case $1 in
    /*) printf '%s\n' "$1" ;;
    *) printf '%s\n' "$PWD/$1" ;;
  esac
}

processors() {
  nproc 2>/dev/null || echo 2
}

# build_preset PRESET [-DNAME=VALUE...] [cmake --build options...]
# Configures a build folder anew if it was moved or copied.
build_preset() {
  local preset=$1 cache="$root/build/$1/CMakeCache.txt" fresh=() definitions=()
  shift
  while [[ ${1:-} == -D* ]]; do
    definitions+=("$1")
    shift
  done
  if [[ -f $cache ]] && ! grep -qxF "CMAKE_CACHEFILE_DIR:INTERNAL=${cache%/*}" "$cache"; then
    fresh=(--fresh)
  fi
  (
    cd "$root" || exit
    logged cmake "${fresh[@]}" --preset "$preset" "${definitions[@]}"
    logged cmake --build --preset "$preset" --parallel "$(processors)" "$@"
  )
}
