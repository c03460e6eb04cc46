#!/usr/bin/env bash
# python_environment.sh FOLDER EXTRA...: a virtual environment with what building and testing the
# Python package with these extras needs. Where it is there already and pyproject.toml is not newer,
# nothing is done.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$1
shift

if [[ -e $folder/complete && ! pyproject.toml -nt $folder/complete ]]; then exit 0; fi

# Debian's own, which is the one that its python3-dev is for.
python3=/usr/bin/python3
[[ -x $python3 ]] || python3=python3
"$python3" -m venv "$folder"
mapfile -t packages < <("$python3" - "$@" <<'PYTHON'
import re
import sys
import tomllib

with open("pyproject.toml", "rb") as file:
    content = tomllib.load(file)
project = content["project"]
extras = project["optional-dependencies"]


def packages(names):
    for name in names:
        for each in extras[name]:
            # Those of the package itself stand for other extras.
            own = re.fullmatch(project["name"] + r"\[(.*)\]", each)
            yield from packages(own[1].split(",")) if own else [each]


build = content["build-system"]["requires"] if "test" in sys.argv else []
print(*build, *project["dependencies"], *packages(sys.argv[1:]), sep="\n")
PYTHON
)
"$folder/bin/pip" install --quiet --disable-pip-version-check "${packages[@]}"
touch "$folder/complete"
