#!/usr/bin/env bash
# bare_wheel_test.sh WHEEL: makes a Debian 12 below build/ that has Python and nothing else, no
# compiler, no -dev package and none of our libraries, installs the wheel there and runs the
# package's tests, with the real scans in GROUNDGRID_DATA where that is set. Needs root, debootstrap
# and the network.
set -euo pipefail
cd "$(dirname "$0")/.."
wheel=$(realpath "$1")
root=$PWD/build/bare
data=${GROUNDGRID_DATA:-}

if [[ $(id -u) -ne 0 ]]; then
  echo "bare_wheel_test.sh: needs root, for chroot" >&2
  exit 1
fi

rm -rf "$root"
trap 'rm -rf "$root"' EXIT
unshare --mount debootstrap --variant=minbase --include=ca-certificates,python3-venv bookworm \
  "$root" >/dev/null
# Names and certificates as this machine has them.
cp --dereference /etc/resolv.conf /etc/hosts "$root/etc"
cp --dereference /etc/ssl/certs/ca-certificates.crt "$root/etc/ssl/certs"
mkdir -p "$root/checkout/examples" "$root/checkout/python" "$root/data"
cp "$wheel" pyproject.toml "$root/checkout"
cp -r examples/python "$root/checkout/examples"
cp -r python/tests "$root/checkout/python"

cat >"$root/checkout/test.sh" <<'SHELL'
set -euo pipefail
cd /checkout
if dpkg-query --show --showformat='${Package}\n' |
  grep -E -- '-dev$|^(gcc|g\+\+|clang)(-[0-9]+)?$|gdal|tbb|embree|libhwy|libfmt|lzf'; then
  echo "bare_wheel_test.sh: not as bare as it must be" >&2
  exit 1
fi
python3 -m venv /environment
/environment/bin/pip install --quiet --disable-pip-version-check "$(ls ./*.whl)[test]"
# Ouster's SDK goes with no other extra, and needs OpenGL of the system.
/environment/bin/python -m pytest -q -p no:cacheprovider --ignore=python/tests/test_ouster.py
SHELL

# What is mounted goes with the namespace.
export root data
unshare --mount --pid --fork -- bash -euo pipefail -c '
  mount -t proc proc "$root/proc"
  mount --rbind /dev "$root/dev"
  if [[ -n $data ]]; then mount --bind -o ro "$data" "$root/data"; fi
  chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/bin:/bin ${data:+GROUNDGRID_DATA=/data} \
    ${data:+GROUNDGRID_REQUIRE_DATA=1} bash /checkout/test.sh'
