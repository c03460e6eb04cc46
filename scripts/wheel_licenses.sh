#!/usr/bin/env bash
# wheel_licenses.sh WHEEL PYTHON: puts the licences of what a repaired wheel has in it beside ours,
# as Debian's packages and nanobind bring them: who passes the wheel on passes all of that on. Needs
# a Python with the package wheel, and build/python.
set -euo pipefail
cd "$(dirname "$0")/.."
wheel=$1
python=$2
folder=$(mktemp --directory)
trap 'rm -rf "$folder"' EXIT

"$python" -m wheel unpack --dest "$folder" "$wheel" >/dev/null
content=$(echo "$folder"/groundgrid-*)
information=$(echo "$content"/groundgrid-*.dist-info)

add() {
  cp "$1" "$information/licenses/$2"
  sed -i "/^License-File: LICENSE\$/a License-File: $2" "$information/METADATA"
}

# Compiled in; the others are files of their own, to whose names auditwheel adds a hash.
packages=(libeigen3-dev libtoml11-dev nlohmann-json3-dev)
for library in "$content"/groundgrid.libs/*; do
  name=$(sed -E 's|.*/||; s|-[0-9a-f]{8}\.so|.so|' <<<"$library")
  packages+=("$(dpkg-query --search "*/$name" | cut --delimiter=: --fields=1 | sort --unique)")
done
for package in "${packages[@]}"; do add "/usr/share/doc/$package/copyright" "$package.txt"; done
add /usr/share/common-licenses/Apache-2.0 Apache-2.0.txt
add /usr/share/common-licenses/MPL-2.0 MPL-2.0.txt
add "$(find build/python/lib -path '*/nanobind-*.dist-info/*' -name LICENSE)" nanobind.txt

"$python" -m wheel pack --dest-dir "$(dirname "$wheel")" "$content" >/dev/null
