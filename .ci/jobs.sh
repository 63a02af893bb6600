# shellcheck shell=bash
# Jobs one after another, of which each is passed or failed. For .ci/run and .ci/nightly.
set -uo pipefail

root=$(unset CDPATH; cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
passed=0
failed=0
skipped=0

# job COMMAND...: runs the command and counts its result. A failure does not stop the jobs after it.
job() {
  printf '\n== %s\n' "$*"
  "$@"
  count $? "$*"
}

# job_beside LOG COMMAND...: starts the command. Its output goes to the file LOG until end_beside.
job_beside() {
  beside_log=$1 beside_words=${*:2}
  mkdir -p "$(dirname "$beside_log")"
  "${@:2}" &>"$beside_log" &
  beside=$!
  trap 'kill "$beside" 2>/dev/null' EXIT
}

# Waits for the job that was started beside others, prints its output, and counts its result.
end_beside() {
  local status=0
  wait "$beside" || status=$?
  trap - EXIT
  printf '\n== %s\n' "$beside_words"
  cat "$beside_log"
  count "$status" "$beside_words"
}

# count STATUS WORDS: counts a job that has ended.
count() {
  case $1 in
    0) passed=$((passed + 1)) ;;
    77)
      printf '== skipped: %s\n' "$2"
      skipped=$((skipped + 1))
      ;;
    *)
      printf '== failed: %s\n' "$2"
      failed=$((failed + 1))
      ;;
  esac
}

# Copies of the upstream meshes, and of the sources of public codes, beside the checkout stand for
# the network: the tests fetch the real ones, from the folder and over HTTP.
for name in datasets:mirror peers:peers; do
  variable=GEODESIC_${name%:*}_MIRROR
  variable=${variable^^} folder=$root/../shared/${name#*:}
  if [[ -z ${!variable:-} && -d $folder ]]; then
    export "$variable=$(cd "$folder" && pwd -P)"
  fi
done
