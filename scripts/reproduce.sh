#!/usr/bin/env bash
# reproduce.sh [--check] DATASET [ARGUMENT ...]: the paper's Table I on SemanticKITTI, beside what
# was published. With --check it only looks whether labelled scans are there.
set -euo pipefail
cd "$(dirname "$0")/.."

explain() {
  cat >&2 <<'TEXT'
Table I of the paper is about SemanticKITTI, sequences 00 to 10, which we may not ship:

  1. From https://semantic-kitti.org/dataset.html get "KITTI Odometry Benchmark Velodyne point
     clouds" (80 GB) and "calibration data", and "SemanticKITTI label data" (179 MB).
  2. Unpack them into one folder, so that it looks like this (one sequence is enough):

       dataset/sequences/00/velodyne/000000.bin ...
                            labels/000000.label ...
                            calib.txt  poses.txt

  3. make reproduce DATA=path/to/dataset

Sequences and scans that are missing are said below the table.
TEXT
}

check_only=false
if [[ "${1:-}" == --check ]]; then check_only=true; shift; fi
data=${1:-}

if [[ -z "$data" ]]; then
  explain
  exit 1
fi
for kind in bin label; do
  if [[ -z "$(find -L "$data" -name "*.$kind" -print -quit 2>/dev/null)" ]]; then
    echo "There are no .$kind files below '$data'." >&2
    echo >&2
    explain
    exit 1
  fi
done
if $check_only; then exit 0; fi

exec build/release/src/program/groundgrid reproduce "$@"
