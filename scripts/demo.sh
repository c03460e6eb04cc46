#!/usr/bin/env bash
# demo.sh [--check] DATASET: segments a dataset into build/demo and, where it has labels, scores
# both presets. With --check it only looks whether the dataset is there.
set -euo pipefail
cd "$(dirname "$0")/.."

explain() {
  cat >&2 <<'TEXT'
The demo needs LiDAR scans, which we may not ship. SemanticKITTI has them, with labels:

  1. From https://semantic-kitti.org/dataset.html get "KITTI Odometry Benchmark Velodyne point
     clouds" (80 GB) and "calibration data", and "SemanticKITTI label data" (179 MB).
  2. Unpack them into one folder, so that it looks like this (one sequence is enough):

       dataset/sequences/00/velodyne/000000.bin ...
                            labels/000000.label ...
                            calib.txt  poses.txt  times.txt

  3. make demo DATA=path/to/dataset

Without labels, e.g. plain KITTI, the scans are segmented but not scored.
TEXT
}

check_only=false
if [[ "${1:-}" == --check ]]; then check_only=true; shift; fi
data=${1:-}

if [[ -z "$data" ]]; then
  explain
  exit 1
fi
if [[ -z "$(find -L "$data" -name '*.bin' -print -quit 2>/dev/null)" ]]; then
  echo "There are no scans (.bin files) below '$data'." >&2
  echo >&2
  explain
  exit 1
fi
if $check_only; then exit 0; fi

groundgrid=build/release/src/program/groundgrid
output=build/demo

"$groundgrid" segment "$data" --output "$output"
echo "One label per point is in $output (run.json says what was done)."
if [[ -n "$(find -L "$data" -path '*/labels/*.label' -print -quit)" ]]; then
  for preset in default paper; do
    echo
    "$groundgrid" evaluate "$data" --preset "$preset"
  done
else
  echo "There are no labels below '$data', so nothing is scored."
fi
