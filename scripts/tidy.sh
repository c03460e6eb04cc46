#!/usr/bin/env bash
# tidy.sh BUILD_FOLDER JOBS: clang-tidy 14 over src, python/src and, through them, include. Needs a
# folder that the preset tidy configured with the Python package, whose units are several sources
# each: most of the time goes into the headers, which are then read once for all of them. Headers
# that no source includes (the adapters) are left to the tests that use them.
set -euo pipefail
cd "$(dirname "$0")/.."
build=$1
jobs=$2

# Clang's analyzer follows the paths through a source that another one includes only where that one
# has this name. And it does not know all of GCC's warnings.
readonly unified="$build/unified"
mkdir -p "$unified"
while read -r unit; do
  cp "$unit" "$(sed -E 's|unity_([0-9]+)_cxx|UnifiedSource\1|' <<<"$unit")"
done < <(find "$build/src" "$build/python" -name 'unity_*_cxx.cxx')
sed -E 's|unity_([0-9]+)_cxx\.cxx([" ])|UnifiedSource\1.cxx\2|g; s| -Wno-subobject-linkage||g' \
  "$build/compile_commands.json" \
  >"$unified/compile_commands.json"

sources=$(scripts/sources.sh src python/src | grep '\.cpp$' | sed "s|^|$PWD/|")
units=$(sed -nE 's/^ *"file": "(.*)",?$/\1/p' "$unified/compile_commands.json" |
  grep -E "^$PWD/(src|python/src)/|^$PWD/build/[a-z]+/(src|python)/.*/groundgrid[a-z_]*\.dir/" |
  sort -u)
in_units=$({ echo "$units"; xargs sed -nE 's/^#include "(.*)"$/\1/p' <<<"$units"; } | sort -u)
missing=$(comm -23 <(sort <<<"$sources") <(echo "$in_units"))
if [[ -n $missing ]]; then
  printf 'tidy.sh: no target of %s has these sources:\n%s\n' "$build" "$missing" >&2
  exit 1
fi

xargs --max-procs="$jobs" --max-args=1 \
  clang-tidy-14 -p "$unified" --quiet --warnings-as-errors='*' \
  <<<"$units" 2> >(grep -v 'warnings\? generated' >&2)
