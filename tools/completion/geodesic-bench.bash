# Completion of geodesic-bench for bash. Installed beside an installed program; from a checkout:
#   source tools/completion/geodesic-bench.bash
_geodesic_bench_words=${BASH_SOURCE[0]%/*}/words.sh
[[ -x $_geodesic_bench_words ]] ||
  _geodesic_bench_words=${BASH_SOURCE[0]%/*}/../../geodesic-bench/completion/words.sh

_geodesic_bench() {
  local word=${COMP_WORDS[COMP_CWORD]} command='' before=''
  [[ $COMP_CWORD -le 1 ]] || command=${COMP_WORDS[1]}
  if [[ $word == *,* ]]; then before=${word%,*},; fi  # a list of names: --solvers mmp,ich
  local words
  words=$("$_geodesic_bench_words" "$1" "$command" "${COMP_WORDS[COMP_CWORD - 1]}")
  mapfile -t COMPREPLY < <(compgen -P "$before" -W "$words" -- "${word##*,}")
  case ${COMP_WORDS[COMP_CWORD - 1]} in
    --solver | --solvers | --against | --reference | --corpus | --vectors | --to | --format | --up) ;;
    *) # a file may stand there, too
      local files=()
      if [[ -n $command ]]; then mapfile -t files < <(compgen -f -- "$word"); fi
      if [[ ${#files[@]} -gt 0 ]]; then
        COMPREPLY+=("${files[@]}")
        compopt -o filenames 2>/dev/null
      fi
      ;;
  esac
  if [[ ${COMPREPLY[*]} == *= ]]; then compopt -o nospace 2>/dev/null; fi # a value follows
}
complete -o bashdefault -o default -F _geodesic_bench geodesic-bench
