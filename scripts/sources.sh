#!/usr/bin/env bash
# Lists our C++ sources, or those below the folders given.
set -euo pipefail
cd "$(dirname "$0")/.."
folders=("$@")
if [[ ${#folders[@]} -eq 0 ]]; then folders=(include src python tests benchmarks examples); fi
find "${folders[@]}" -name '*.hpp' -o -name '*.cpp' | sort
