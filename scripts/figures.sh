#!/usr/bin/env bash
# figures.sh DATASET [OUTPUT]: pictures of the paper's three scenes (fig. 3), from above and in
# perspective, by label and, where there are labels, by error and as the labels have it.
# Needs the built program. SCENES="SEQUENCE/SCAN ..." chooses other ones.
set -euo pipefail
cd "$(dirname "$0")/.."

data=${1:-}
output=${2:-build/figures}
scenes=${SCENES:-01/000040 09/001590 10/000164}
groundgrid=build/release/src/program/groundgrid

if [[ -z "$data" ]]; then
  echo "Say where a dataset in SemanticKITTI layout lies: make figures DATA=path/to/dataset" >&2
  exit 1
fi
if [[ ! -d "$data/sequences" ]]; then
  echo "There is no folder 'sequences' in '$data'." >&2
  exit 1
fi

draw() { # WHAT NAME ARGUMENT ...
  local file="$output/$2.png"
  "$groundgrid" render "$1" "${@:3}" --output "$file"
  echo "  $file"
}

missing=()
drawn=0
mkdir -p "$output"
for scene in $scenes; do
  sequence=${scene%%/*}
  scan=${scene##*/}
  folder=$data/sequences/$sequence
  if [[ ! -e "$folder/velodyne/$scan.bin" ]]; then
    missing+=("$scene")
    continue
  fi
  echo "Scene $scene, its map remembering all scans before it:"
  number=$((10#$scan))
  chosen=("$data" --sequence "$sequence" --scan "$number")
  draw scan "$sequence-$scan-above" "${chosen[@]}"
  draw scan "$sequence-$scan-perspective" "${chosen[@]}" --view perspective --size 1600x1000
  if [[ -e "$folder/labels/$scan.label" ]]; then
    draw scan "$sequence-$scan-errors" "${chosen[@]}" --errors
    draw scan "$sequence-$scan-truth" "${chosen[@]}" --labels "$folder/labels/$scan.label" \
      --view perspective --size 1600x1000 --title "sequence $sequence, scan $scan, ground truth"
  fi
  drawn=$((drawn + 1))
done

echo "$drawn scenes are drawn."
if [[ ${#missing[@]} -gt 0 ]]; then
  echo "Not in '$data': ${missing[*]}" >&2
fi
[[ $drawn -gt 0 ]]
