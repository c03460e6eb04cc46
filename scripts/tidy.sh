#!/usr/bin/env bash
# tidy.sh BUILD_FOLDER JOBS: clang-tidy 14 over src and, through it, include. Needs a configured
# build folder. Headers that no source includes (the adapters) are left to the tests that use them.
set -euo pipefail
cd "$(dirname "$0")/.."
build=$1
jobs=$2
scripts/sources.sh src | grep '\.cpp$' |
  xargs --max-procs="$jobs" --max-args=1 \
    clang-tidy-14 -p "$build" --quiet --warnings-as-errors='*' 2> >(grep -v 'warnings\? generated' >&2)
