#!/usr/bin/env bash
# Installs the Debian packages that are missing for the groups given: build, bench, coverage, fuzz,
# lint, peers, python. Where none is missing apt is not called at all.
set -euo pipefail

packages_of() {
  case "$1" in
    build) echo g++ cmake ninja-build libeigen3-dev libtbb-dev libcli11-dev libspdlog-dev \
                libfmt-dev nlohmann-json3-dev libtoml11-dev liblzf-dev libgtest-dev \
                libgdal-dev libembree-dev libyaml-cpp-dev pkg-config \
                libcairo2-dev fonts-dejavu-core libegl-dev libopengl-dev libgl-dev \
                libgl1-mesa-dri libgif-dev python3-numpy ;;
    bench) echo libbenchmark-dev ;;
    coverage) echo gcovr ;;
    fuzz) echo clang-14 libclang-rt-14-dev ;;
    lint) echo clang-format-14 clang-tidy-14 ;;
    peers) echo python3-venv libusb-1.0-0 ;;
    python) echo python3-dev python3-venv ;;
    *) echo "install_dependencies.sh: unknown group '$1'" >&2; return 2 ;;
  esac
}

is_installed() {
  [[ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" == installed ]]
}

wanted=()
for group in "$@"; do
  names=$(packages_of "$group")
  read -r -a group_packages <<<"$names"
  wanted+=("${group_packages[@]}")
done

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "This is no Debian-like system (no apt-get): nothing is installed for you." >&2
  echo "Needed, by their Debian names: ${wanted[*]}" >&2
  echo "Once they are there, build without make:" >&2
  echo "  cmake --preset release && cmake --build --preset release && ctest --preset release" >&2
  exit 1
fi

missing=()
for package in "${wanted[@]}"; do
  is_installed "$package" || missing+=("$package")
done
if [[ ${#missing[@]} -eq 0 ]]; then exit 0; fi

as_root=()
if [[ "$(id -u)" -ne 0 ]]; then
  if ! command -v sudo >/dev/null; then
    echo "These packages are missing, and without root or sudo they cannot be installed:" >&2
    echo "  ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

echo "Installing ${missing[*]} with ${as_root[*]:+sudo }apt-get"
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -qq --no-install-recommends "${missing[@]}"
