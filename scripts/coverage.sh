#!/usr/bin/env bash
# Runs the tests of the coverage preset, which must be built, and reports what they reached: a
# summary here, every line in build/coverage/report/index.html.
set -euo pipefail
cd "$(dirname "$0")/.."
readonly report=build/coverage/report
find build/coverage -name '*.gcda' -delete
ctest --preset coverage
rm -rf "$report"
mkdir -p "$report"
# Branches that only an exception takes say little: nearly every call has one.
gcovr --root . --filter src/ --filter include/ --exclude-throw-branches \
  --exclude-unreachable-branches --html-details "$report/index.html" --txt "$report/summary.txt" \
  --print-summary build/coverage
echo "Line by line: $report/index.html"
