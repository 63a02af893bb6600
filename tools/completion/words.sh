#!/bin/sh
# words.sh PROGRAM COMMAND PREVIOUS: prints the words that may follow the word PREVIOUS on a command
# line of geodesic-bench, one per line, from the lists of the program; nothing if files may follow.
# COMMAND is empty if the command itself is to be completed.
program=$1 command=$2 previous=$3

# names KIND: prints the first column of the table of `list` whose heading begins with KIND, "solver" or
# "mesh". For a solver with parameters also "solver?parameter=".
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

# commands: prints the first words below "Subcommands:" or "Commands:".
commands() {
  "$program" --help | awk '/ommands:$/ { inside = 1; next } inside && NF { print $1 }'
}

options() {
  "$program" "$command" --help | grep -oE '^ +(-[a-z], ?)?--[a-z][a-z-]*' | grep -oE -- '--[a-z-]+'
}

# choices OPTION: prints the choices that the command's help shows, "--to {csv,github-action-benchmark}".
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
