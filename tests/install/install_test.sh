#!/usr/bin/env bash
# install_test.sh NAME: one test of what is installed; the functions below are the tests.
# Takes SOURCE (the repository), BUILD (a finished build), WORK (a folder to use), CMAKE, CXX and
# WERROR (-Werror or nothing) from the environment. What is built here is not optimised, and for one
# instruction set: it is the linking that is tested.
set -euo pipefail

readonly quick="-DCMAKE_BUILD_TYPE=Debug -DCMAKE_UNITY_BUILD=ON -DCMAKE_CXX_FLAGS=-DHWY_COMPILE_ONLY_STATIC"

readonly tree=$WORK/moved
readonly warnings="-Wall -Wextra -Wpedantic -Wshadow -Wconversion ${WERROR:-}"
export PKG_CONFIG_PATH=$tree/lib/pkgconfig
unset LD_LIBRARY_PATH DESTDIR

fail() {
  echo "install_test.sh: $*" >&2
  exit 1
}

# expect TEXT REGEX: the regular expression matches one line of the text.
expect() {
  grep -qE -- "$2" <<<"$1" || fail "no line matches '$2' in:"$'\n'"$1"
}

# Installs a build for /opt/groundgrid below one folder, no other test's, and moves the tree to
# another.
install_and_move() {
  local build=$1 destination=$2 staging=$2.staging
  rm -rf "$staging" "$destination"
  DESTDIR=$staging "$CMAKE" --install "$build" --prefix /opt/groundgrid
  mv "$staging/opt/groundgrid" "$destination"
}

# Builds one example against the package in a prefix, into WORK/NAME.
build_example() {
  local example=$1 prefix=$2 build=$WORK/$3
  rm -rf "$build"
  "$CMAKE" -S "$SOURCE/examples/$example" -B "$build" -DCMAKE_CXX_COMPILER="$CXX" \
    -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS="$warnings" -DCMAKE_PREFIX_PATH="$prefix"
  expect "$(cat "$build/CMakeCache.txt")" "^groundgrid_DIR:PATH=$prefix/"
  "$CMAKE" --build "$build"
}

expect_single_scan() {
  expect "$1" '^128000 points: 99\.[0-9] % ground, 0\.[0-9] % obstacle, 0\.0 % outlier, 0\.0 % unk'
  expect "$1" '^the LiDAR is 1\.73 m above the ground$'
  expect "$1" '^the way ahead is free for 12\.0 m$'
}

tree() {
  install_and_move "$BUILD" "$tree"
  local named
  named=$(ls "$tree" | grep -vxE 'bin|include|lib|share') &&
    fail "neither library nor program: $named"
  named=$(grep -rlF -e "$BUILD" -e "$SOURCE" -e /opt/groundgrid "$tree" --include='*.cmake' \
    --include='*.pc' --include='*.hpp') || return 0
  fail "these files know where they were built or installed:"$'\n'"$named"
}

# Each header alone, and in the installed tree, so that it includes nothing that stays behind, and
# oneTBB only where its name says so.
headers() {
  local header count=0 needs
  while read -r header; do
    needs=$(echo "#include <$header>" | "$CXX" -x c++ -fsyntax-only -MD -MF /dev/stdout \
      -Wall -Wextra -Werror $(pkg-config --cflags groundgrid) -)
    if [[ $header == */tbb_* ]]; then expect "$needs" '/task_arena\.h'
    elif [[ $needs == */task_arena.h* ]]; then fail "$header needs oneTBB"; fi
    count=$((count + 1))
  done < <(cd "$tree/include" && find . -name '*.hpp' | sed 's|^\./||' | sort)
  [[ $count -eq $(find "$SOURCE/include" -name '*.hpp' | wc -l) ]] || fail "$count headers"
}

examples() {
  local example output
  for example in 01_single_scan 02_drive 03_own_point_type 04_several_sensors \
    05_own_threads; do
    build_example "$example" "$tree" "$example"
    output=$("$WORK/$example/${example#*_}")
    echo "$output"
    case "$example" in
      01*) expect_single_scan "$output" ;;
      02*) [[ $(grep -cE '^(100\.0|99\.[0-9]) % ground; 10 m ahead .* \+0\.5[01] m' \
        <<<"$output") -eq 10 ]] || fail "not ten scans of a road that climbs 5 m in 100 m" ;;
      03*) expect "$output" '^  one pose for all points: -0\.3'
        expect "$output" '^  motion-corrected: [+-]0\.00 m$' ;;
      04*) expect "$output" '^front: .* points, (100\.0|99\.[0-9]) % ground$'
        expect "$output" '^rear: .* points, 7[0-9]\.[0-9] % ground$' ;;
      05*) expect "$output" '^an arena of 2 threads: the same labels$'
        expect "$output" '^own threads: the same labels$' ;;
    esac
  done
  # What is not in the folder of scans is said, not passed over.
  if output=$("$WORK/01_single_scan/single_scan" "$WORK/none.bin" 2>&1); then fail "no error"; fi
  expect "$output" '^cannot open .*none\.bin$'
}

pkg_config() {
  local how
  for how in "" --static; do
    "$CXX" "$SOURCE/examples/01_single_scan/main.cpp" -o "$WORK/by_pkg_config" \
      $(pkg-config --cflags --libs $how groundgrid)
    expect_single_scan "$("$WORK/by_pkg_config")"
    "$CXX" "$SOURCE/examples/05_own_threads/main.cpp" -o "$WORK/arena_by_pkg_config" \
      $(pkg-config --cflags --libs $how groundgrid tbb)
    expect "$("$WORK/arena_by_pkg_config")" '^an arena of 2 threads: the same labels$'
  done
}

# Where nobody asks for threads nothing of oneTBB is called, not even to count cores. Functions are
# looked for when first called, and the dynamic linker says so.
one_thread() {
  local example calls
  for example in 01_single_scan 05_own_threads; do
    "$CXX" "$SOURCE/examples/$example/main.cpp" -o "$WORK/$example.lazy" -Wl,-z,lazy \
      $(pkg-config --cflags --libs groundgrid tbb)
    calls=$(LD_DEBUG=bindings "$WORK/$example.lazy" 2>&1 |
      grep -E "binding file $WORK/$example.lazy .* to .*/libtbb\.so.* normal symbol") || true
    if [[ $example == 01* ]]; then [[ -z $calls ]] || fail "oneTBB is called: $calls"
    else expect "$calls" 'task_arena'; fi
  done
}

program() {
  expect "$("$tree/bin/groundgrid" --version)" '^[0-9]+\.[0-9]+\.[0-9]+$'
  [[ -e $tree/share/groundgrid/semantic-kitti-api/ground.yaml ]] || fail "no semantic-kitti-api"
}

# The library alone.
shared_library() {
  local build=$WORK/shared_build prefix=$WORK/shared symbols
  "$CMAKE" -S "$SOURCE" -B "$build" -DCMAKE_CXX_COMPILER="$CXX" $quick \
    -DBUILD_SHARED_LIBS=ON -DGROUNDGRID_BUILD_PROGRAM=OFF -DGROUNDGRID_BUILD_TESTS=OFF
  "$CMAKE" --build "$build" --parallel 2
  install_and_move "$build" "$prefix"
  build_example 01_single_scan "$prefix" with_shared
  expect "$(ldd "$WORK/with_shared/single_scan")" "libgroundgrid\.so\.[0-9.]+ => $prefix/lib/"
  expect_single_scan "$("$WORK/with_shared/single_scan")"
  build_example 05_own_threads "$prefix" threads_with_shared
  expect "$("$WORK/threads_with_shared/own_threads")" '^an arena of 2 threads: the same labels$'

  PKG_CONFIG_PATH=$prefix/lib/pkgconfig
  [[ $(pkg-config --libs groundgrid) != *tbb* ]] || fail "users of the shared library link TBB"
  "$CXX" "$SOURCE/examples/04_several_sensors/main.cpp" -o "$WORK/shared_by_pkg_config" \
    -Wl,-rpath,"$prefix/lib" $(pkg-config --cflags --libs groundgrid)
  expect "$("$WORK/shared_by_pkg_config")" '^rear: .* % ground$'

  symbols=$(nm --dynamic --demangle --defined-only "$prefix/lib/libgroundgrid.so")
  expect "$symbols" ' T groundgrid::GroundGrid::reset\(\)$'
  if grep -E 'ElevationMap|TileRunner|Pipeline' <<<"$symbols"; then fail "the stages show"; fi
}

# add_subdirectory() builds the library and nothing else, and installs nothing.
inside_another_project() {
  local project=$WORK/project
  rm -rf "$project"
  mkdir -p "$project"
  cp "$SOURCE/examples/01_single_scan/main.cpp" "$project"
  cat >"$project/CMakeLists.txt" <<TEXT
cmake_minimum_required(VERSION 3.22)
project(other LANGUAGES CXX)
add_subdirectory($SOURCE groundgrid)
add_executable(other main.cpp)
target_link_libraries(other PRIVATE groundgrid::groundgrid)
TEXT
  "$CMAKE" -S "$project" -B "$project/build" -DCMAKE_CXX_COMPILER="$CXX" $quick
  "$CMAKE" --build "$project/build" --parallel 2
  expect_single_scan "$("$project/build/other")"
  [[ ! -e $project/build/groundgrid/src/io ]] || fail "more than the library is built"
  DESTDIR=$project/staging "$CMAKE" --install "$project/build"
  [[ ! -e $project/staging ]] || fail "it installs something"
}

mkdir -p "$WORK"
"$1"
