#!/usr/bin/env bash
# python_environment.sh FOLDER: a virtual environment with what building and testing the Python
# package needs. Where it is there already and pyproject.toml is not newer, nothing is done.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$1

if [[ -e $folder/complete && ! pyproject.toml -nt $folder/complete ]]; then exit 0; fi

# Debian's own, which is the one that its python3-dev is for.
python3=/usr/bin/python3
[[ -x $python3 ]] || python3=python3
"$python3" -m venv "$folder"
mapfile -t packages < <("$python3" - <<'PYTHON'
import tomllib
with open("pyproject.toml", "rb") as file:
    project = tomllib.load(file)
print(*project["build-system"]["requires"], sep="\n")
print(*project["project"]["dependencies"], sep="\n")
print(*project["project"]["optional-dependencies"]["test"], sep="\n")
PYTHON
)
"$folder/bin/pip" install --quiet --disable-pip-version-check "${packages[@]}"
touch "$folder/complete"
