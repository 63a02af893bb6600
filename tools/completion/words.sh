#!/bin/sh
# words.sh PROGRAM COMMAND PREVIOUS: what may follow the word PREVIOUS on a command line of
# geodesic-bench, one word a line, as the program itself lists it; nothing where files may follow.
# COMMAND is empty where it is itself to be completed.
program=$1 command=$2 previous=$3

# names KIND: the first column of a table of `list`, whose heading begins with "solver" or "mesh"; of
# a solver with parameters "solver?parameter=" too.
names() {
  "$program" list | awk -v kind="$1" '
    $1 == "solver" || $1 == "mesh" { table = $1; parameters = $2 == "parameter"; next }
    !NF { table = "" }
    table == kind { print parameters ? $1 "?" $2 "=" : $1 }'
}

corpora() {
  "$program" list --json | awk '
    /^  "corpora": / { inside = 1; next }
    /^  }/ { inside = 0 }
    inside && match($0, /"[^"]+": \[/) { print substr($0, RSTART + 1, RLENGTH - 5) }'
}

# commands: the first words below "Subcommands:" or "Commands:".
commands() {
  "$program" --help | awk '/ommands:$/ { inside = 1; next } inside && NF { print $1 }'
}

options() {
  "$program" "$command" --help | grep -oE '^ +(-[a-z], ?)?--[a-z][a-z-]*' | grep -oE -- '--[a-z-]+'
}

# choices OPTION: as the help of a command shows them, "--to {csv,github-action-benchmark}".
choices() {
  "$program" "$command" --help | sed -n "s/^  $1 {\([^}]*\)}.*/\1/p" | tr , '\n'
}

{
  case $previous in
    --solver | --solvers | --against | --reference) names solver ;;
    --mesh | --meshes) names mesh ;;
    --corpus) corpora ;;
    --to | --format | --up) choices "$previous" ;;
    --vectors) printf '%s\n' auto plain avx2 avx512 ;;
    --output | --out | -o | --plugin | --manifest | --run | --resume) ;;
    *)
      if [ -z "$command" ]; then commands; else options; fi
      case $command in
        solve) names mesh ;;
        generate) "$program" generate --list | awk '/^[a-z]/ { print $1 }' ;;
      esac
      ;;
  esac
} 2>/dev/null
