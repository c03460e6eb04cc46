#!/usr/bin/env bash
# demo.sh OUT [SCANS]: simulates a drive through a town and one up a wooded hill, segments both with
# both presets, sets labels and terrain beside the truth, and draws what came out. Needs no data.
set -euo pipefail
cd "$(dirname "$0")/.."

out=${1:?demo.sh OUT [SCANS]}
scans=${2:-120}
middle=$((scans / 2))
groundgrid=build/release/src/program/groundgrid
drives=$out/drives
scenes=(urban hill)  # sequences 00 and 01

simulate() {
  for i in "${!scenes[@]}"; do
    echo "Simulating $scans scans of a Velodyne HDL-64E, scene ${scenes[i]} ..."
    "$groundgrid" simulate "${scenes[i]}" "$drives" --sequence "0$i" --scans "$scans" 2>"$out/log" ||
      fail
  done
}

fail() {
  cat "$out/log" >&2
  exit 1
}

segment() {
  for preset in default paper; do
    local as_seen=()
    # The paper neither takes anything out of its terrain nor fills it from the whole drive.
    if [[ $preset == paper ]]; then as_seen=(--terrain-as-seen); fi
    echo "Segmenting both drives, preset $preset ..."
    "$groundgrid" segment "$drives" --output "$out/$preset" --preset "$preset" --terrain \
      "${as_seen[@]}" 2>"$out/log" || fail
  done
}

segmentation_table() {
  echo
  echo "Ground segmentation of the simulated drives (00 urban, 01 hill), percent"
  for preset in default paper; do
    "$groundgrid" evaluate "$drives" --preset "$preset" >"$out/$preset/segmentation.txt" \
      2>"$out/log" || fail
    echo
    echo "preset $preset"
    sed -n '/^sequence /,/^average /p' "$out/$preset/segmentation.txt"
  done
}

terrain_table() {
  echo
  echo "Terrain height of the simulated drives against the truth, metres"
  for preset in default paper; do
    for i in "${!scenes[@]}"; do
      local report=$out/$preset/sequences/0$i/terrain.txt
      "$groundgrid" evaluate-terrain "$out/$preset/sequences/0$i/terrain.tif" \
        "$drives/sequences/0$i/truth/terrain.tif" >"$report" 2>"$out/log" || fail
      echo
      echo "preset $preset, ${scenes[i]}"
      sed -n '/^all cells /,/^all /{/^$/q;p}' "$report"
    done
  done
}

draw() {
  echo
  echo "Drawing ..."
  mkdir -p "$out/pictures"
  for i in "${!scenes[@]}"; do
    local scene=${scenes[i]} sequence=$drives/sequences/0$i
    local terrain=$out/default/sequences/0$i/terrain.tif
    local scan=(scan "$drives" --sequence "0$i" --scan "$middle")
    local path=(--path "$sequence/poses.txt" --calibration "$sequence/calib.txt")
    local name="Simulated drive, $scene"
    picture "$scene-scan.png" "${scan[@]}" --title "$name: ground and obstacles"
    picture "$scene-errors.png" "${scan[@]}" --errors --title "$name: labels against the truth"
    picture "$scene-view.png" "${scan[@]}" --view perspective --title "$name: a scan"
    picture "$scene-terrain.png" terrain "$terrain" "${path[@]}" --title "$name: terrain"
    picture "$scene-terrain-view.png" terrain "$terrain" "${path[@]}" --view perspective \
      --title "$name: terrain"
    picture "$scene-terrain-errors.png" error "$terrain" "$sequence/truth/terrain.tif" \
      "${path[@]}" --title "$name: errors of the terrain"
  done
  picture hill-drive.gif drive "$drives" --sequence 01 --every 4 --title "Simulated drive, hill"
}

picture() {
  local name=$1
  shift
  "$groundgrid" render "$@" --output "$out/pictures/$name" 2>"$out/log" || fail
}

mkdir -p "$out"
simulate
segment
segmentation_table
terrain_table
draw
rm -f "$out/log"
echo
echo "Look at $out/pictures first. Labelled scans and terrain.tif are in $out/default and"
echo "$out/paper, the drives with their truth in $drives; they are a SemanticKITTI dataset."
