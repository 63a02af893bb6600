# shellcheck shell=bash
# Jobs one after another, of which each is passed or failed. For .ci/run and .ci/nightly.
set -uo pipefail

root=$(unset CDPATH; cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
passed=0
failed=0
skipped=0

# job COMMAND...: runs the command and counts its result. A failure does not stop the jobs after it.
job() {
  local status=0
  printf '\n== %s\n' "$*"
  "$@" || status=$?
  case $status in
    0) passed=$((passed + 1)) ;;
    77)
      printf '== skipped: %s\n' "$*"
      skipped=$((skipped + 1))
      ;;
    *)
      printf '== failed: %s\n' "$*"
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
