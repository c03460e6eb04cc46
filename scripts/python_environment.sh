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
    content = tomllib.load(file)
project = content["project"]
extras = project["optional-dependencies"].values()
packages = content["build-system"]["requires"] + project["dependencies"] + sum(extras, [])
# The package itself is what is built.
print(*(each for each in packages if not each.startswith(project["name"])), sep="\n")
PYTHON
)
"$folder/bin/pip" install --quiet --disable-pip-version-check "${packages[@]}"
touch "$folder/complete"
