#!/usr/bin/env bash
# fuzz.sh [SECONDS]: runs every fuzz target of build/asan that long (60 s), two at a time, each on a
# copy of its corpus. Prints a table, and for every finding the input that reproduces it; fails
# where there is one. Findings stay in build/fuzz/artifacts, logs in build/fuzz/run.
set -euo pipefail
cd "$(dirname "$0")/.."
readonly seconds=${1:-60}
readonly run=$PWD/build/fuzz/run
readonly artifacts=$PWD/build/fuzz/artifacts
export UBSAN_OPTIONS=print_stacktrace=1

fuzz_one() {
  local name=$1 corpus=$run/$1 status=0
  mkdir -p "$corpus" "$artifacts/$name"
  cp tests/fuzz/corpus/"$name"/* "$corpus"
  # The limit is for a target that does not heed its own.
  timeout --kill-after=10 $((seconds + 120)) "build/asan/tests/fuzz/fuzz_$name" \
    -max_total_time="$seconds" -rss_limit_mb=1024 -timeout=10 -print_final_stats=1 \
    -artifact_prefix="$artifacts/$name/" "$corpus" >"$run/$name.log" 2>&1 || status=$?
  echo "$status" >"$run/$name.status"
}

stat_of() {
  sed -nE "s/^stat::$2: +//p" "$run/$1.log"
}

names=()
for source in tests/fuzz/fuzz_*.cpp; do
  name=$(basename "$source" .cpp)
  names+=("${name#fuzz_}")
done

rm -rf "$run" "$artifacts"
mkdir -p "$run"
for name in "${names[@]}"; do
  while [[ $(jobs -pr | wc -l) -ge 2 ]]; do wait -n; done
  fuzz_one "$name" &
done
wait

failed=0
printf '%-16s %12s %14s %9s\n' target executions executions/s findings
for name in "${names[@]}"; do
  findings=$(find "$artifacts/$name" -type f ! -name 'slow-unit-*' | wc -l)
  printf '%-16s %12s %14s %9s\n' "$name" "$(stat_of "$name" number_of_executed_units)" \
    "$(stat_of "$name" average_exec_per_sec)" "$findings"
  [[ $findings -eq 0 && $(<"$run/$name.status") -eq 0 ]] || failed=1
done

for name in "${names[@]}"; do
  [[ $(<"$run/$name.status") -ne 0 ]] || continue
  echo
  echo "== fuzz_$name ended with $(<"$run/$name.status")"
  grep -E -m 3 '^does not hold|ERROR: |runtime error: ' "$run/$name.log" || tail -n 20 "$run/$name.log"
  while read -r file; do
    echo "$file, for base64 --decode:"
    base64 "$file"
  done < <(find "$artifacts/$name" -type f)
done
exit "$failed"
