#!/usr/bin/env python3
"""Counts the instructions of a scan under Callgrind and compares them with what is stored.

    make check-instructions             # fails where a count is off by more than 3 %
    make check-instructions UPDATE=1    # stores the counts of now

Real scans are those of GROUNDGRID_DATA; simulated ones are counted anywhere. The counts hold for
one compiler and one set of vector instructions, which are stored with them.
"""

import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
PROGRAM = ROOT / "build/bench/benchmarks/groundgrid_instruction_counts"
STORED = pathlib.Path(__file__).with_suffix(".json")
MARGIN = 0.03
MACHINE = ("compiler", "vectors")


class CountError(Exception):
    """What cannot be counted or compared, in words."""


def counted(dump):
    """The name of the case and the instructions in a file that Callgrind wrote."""
    text = dump.read_text()
    name = re.search(r"^desc: Trigger: Client Request: (.+)$", text, re.MULTILINE)
    total = re.search(r"^totals: (\d+)$", text, re.MULTILINE)
    if not name or not total:
        raise CountError(f"{dump.name}: expected a case and its total, as Callgrind writes them")
    return name[1], int(total[1])


def count(program, data):
    """Head and cases as the program prints them, each case with its instructions."""
    environment = os.environ if data is None else {**os.environ, "GROUNDGRID_DATA": data}
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(
            ["valgrind", "--quiet", "--tool=callgrind", "--instr-atstart=no",
             f"--callgrind-out-file={folder}/counts", program],
            env=environment, stdout=subprocess.PIPE, text=True, check=False)
        if run.returncode != 0:
            raise CountError(f"{program} failed with {run.returncode}")
        totals = dict(map(counted, pathlib.Path(folder).glob("counts.*")))
    head, *cases = map(json.loads, run.stdout.splitlines())
    for case in cases:
        if case["case"] not in totals:
            raise CountError(f"Callgrind wrote nothing for '{case['case']}'")
        case["instructions"] = totals[case["case"]]
    return head, cases


def per_scan(case):
    return round(case["instructions"] / case["scans"])


def stored_counts():
    return json.loads(STORED.read_text()) if STORED.exists() else {}


def check_machine(stored, head):
    for name in MACHINE:
        if stored.get(name) != head[name]:
            raise CountError(
                f"{name}: counts are stored for {stored.get(name)}, this is {head[name]}; they "
                "cannot be compared. UPDATE=1 stores those of this machine")


def compare(stored, head, cases):
    """Prints a line a case; the number of those that are off."""
    known = stored["instructions_per_scan"].get(head["data"], {})
    off = 0
    print(f"{head['data']}, {head['compiler']}, {head['vectors']}")
    print(f"  {'':26} {'per scan':>12} {'per point':>9} {'stored':>12} {'change':>8}")
    for case in cases:
        now, before = per_scan(case), known.get(case["case"])
        change = now / before - 1 if before else None
        is_off = change is None or abs(change) > MARGIN
        off += is_off
        print(f"  {case['case']:26} {now:12,} {case['instructions'] / case['points']:9.1f} "
              f"{before or 0:12,} {'none' if change is None else f'{change:+.2%}':>8}"
              f"{'  OFF' if is_off else ''}")
    return off


def store(stored, head, cases):
    if any(stored.get(name) != head[name] for name in MACHINE):
        stored.clear()
        stored.update({name: head[name] for name in MACHINE}, instructions_per_scan={})
    stored["instructions_per_scan"][head["data"]] = {case["case"]: per_scan(case) for case in cases}
    STORED.write_text(json.dumps(stored, indent=2) + "\n")


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    parser.add_argument("--update", action="store_true", help="store the counts of now")
    options = parser.parse_args(arguments)
    runs = [count(options.program, None), count(options.program, os.devnull)]
    if runs[0][0]["data"] == "simulated":
        if "GROUNDGRID_REQUIRE_DATA" in os.environ:
            raise CountError("GROUNDGRID_DATA: expected SemanticKITTI's sequence 00, got none")
        print("No real scans (GROUNDGRID_DATA): only simulated ones are counted")
        runs.pop(0)
    stored = stored_counts()
    off = 0
    for head, cases in runs:
        if options.update:
            store(stored, head, cases)
        else:
            check_machine(stored, head)
        off += compare(stored, head, cases)
    if off:
        raise CountError(f"{off} counts are off by more than {MARGIN:.0%}, or not stored. Where "
                         "that is meant, fewer too: make check-instructions UPDATE=1")


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except CountError as error:
        sys.exit(f"instruction_counts.py: {error}")
