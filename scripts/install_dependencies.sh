#!/usr/bin/env bash
# Installs the Debian packages that are missing for the groups given: arm, bare, build, bench,
# coverage, fuzz, lint, peers, python. Where none is missing apt is not called at all.
set -euo pipefail

packages_of() {
  case "$1" in
    # No oneTBB: its libudev1 must be of the same version on both architectures, and with it the
    # whole of systemd.
    arm) echo cmake ninja-build g++-aarch64-linux-gnu qemu-user libeigen3-dev \
              nlohmann-json3-dev libfmt-dev:arm64 libgtest-dev:arm64 libhwy-dev:arm64 \
              liblzf-dev:arm64 ;;
    build) echo g++ cmake ninja-build libeigen3-dev libtbb-dev libcli11-dev libspdlog-dev \
                libfmt-dev nlohmann-json3-dev libtoml11-dev liblzf-dev libgtest-dev libhwy-dev \
                libgdal-dev libembree-dev libyaml-cpp-dev pkg-config \
                libcairo2-dev fonts-dejavu-core libegl-dev libopengl-dev libgl-dev \
                libgl1-mesa-dri libgif-dev python3-numpy ;;
    bare) echo debootstrap ;;
    bench) echo libbenchmark-dev valgrind ;;
    coverage) echo gcovr ;;
    fuzz) echo clang-14 libclang-rt-14-dev ;;
    lint) echo clang-format-14 clang-tidy-14 ;;
    peers) echo python3-venv libusb-1.0-0 ;;
    python) echo python3-dev python3-venv ;;
    *) echo "install_dependencies.sh: unknown group '$1'" >&2; return 2 ;;
  esac
}

# A name without an architecture is this machine's: the same package for another one does not count.
is_installed() {
  local architecture=$native
  if [[ "$1" == *:* ]]; then architecture=${1#*:}; fi
  grep -qxE "($architecture|all) installed" <<<"$(dpkg-query --show \
    --showformat='${Architecture} ${db:Status-Status}\n' "${1%:*}" 2>/dev/null)"
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

native=$(dpkg --print-architecture)
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

if [[ "${missing[*]}" == *:arm64* ]] && ! dpkg --print-foreign-architectures | grep -qx arm64; then
  echo "Letting apt install packages for arm64 beside those of this machine"
  "${as_root[@]}" dpkg --add-architecture arm64
fi
echo "Installing ${missing[*]} with ${as_root[*]:+sudo }apt-get"
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -qq --no-install-recommends "${missing[@]}"
