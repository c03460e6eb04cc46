#!/usr/bin/env python3
"""GroundGrid beside the open peers that PyPI carries: accuracy by one judge, `groundgrid evaluate`,
and the time of each scan on one core. docs/benchmarks.md tells how, and what came out.

    make peers DATA="path/to/SemanticKITTI" PEERS_FLAGS="--repetitions 7"

Datasets are in SemanticKITTI layout, real or from `groundgrid simulate`.
"""

import one_thread

import argparse
import json
import pathlib
import sys
import tempfile

from package_peers import PEERS, PeerMissing
from results import Result, Results, text, to_json, write_csv
from runs import add_package_times, evaluate, run_peer, run_program, yardstick_ms
from sequences import ComparisonError, find_sequences

PROGRAM = pathlib.Path(__file__).resolve().parents[2] / "build/release/src/program/groundgrid"
OURS = {
    "groundgrid": [],
    "groundgrid single scan": ["--single-scan"],
    "groundgrid paper": ["--preset", "paper"],
}


def parse(arguments, peers):
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0],
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    every = [*OURS, *peers]
    parser.add_argument("datasets", nargs="+", type=pathlib.Path, metavar="DATASET")
    parser.add_argument("--sequence", action="append", help="only this one; may be repeated")
    parser.add_argument("--methods", default=",".join(every),
                        help=f"of {', '.join(every)}; all, if left out")
    parser.add_argument("--predictions", action="append", default=[], metavar="NAME=DIR",
                        help="another method's labels, DIR/sequences/NN/predictions, as one more")
    parser.add_argument("--repetitions", type=int, default=1,
                        help="runs of each method, for its times [1]")
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    parser.add_argument("--output", type=pathlib.Path,
                        help="keeps the labels in OUTPUT/NUMBER OF DATASET/METHOD")
    parser.add_argument("--csv", type=pathlib.Path, help="writes every figure to this file")
    parser.add_argument("--json", action="store_true", help="prints JSON instead of tables")
    parser.add_argument("--plots", type=pathlib.Path, metavar="DIR", help="draws into this folder")
    options = parser.parse_args(arguments)
    options.methods = [name.strip() for name in options.methods.split(",") if name.strip()]
    for name in options.methods:
        if name not in every:
            parser.error(f"there is no method '{name}', only {', '.join(every)}")
    for given in options.predictions:
        if "=" not in given:
            parser.error(f"--predictions takes NAME=DIR, not '{given}'")
    if options.repetitions < 1:
        parser.error("--repetitions takes 1 or more")
    return options


def run_once(method, sequence, output, options, peers):
    if method in OURS:
        flags = OURS[method]
        times = run_program(options.program, flags, sequence, output)
        return add_package_times(times, sequence, paper="paper" in flags,
                                 single_scan="--single-scan" in flags)
    return run_peer(peers[method], sequence, output)


def rotated(methods, repetition):
    """Each method goes first in its turn, so that none always follows the same one."""
    start = repetition % len(methods) if methods else 0
    return methods[start:] + methods[:start]


def labels_folder(sequence, method, output, datasets):
    return output / str(datasets.index(sequence.dataset)) / method.replace(" ", "_")


def run_methods(sequences, options, peers, output):
    """Results by method and sequence, and the yardstick before each run."""
    results, yardsticks_ms = {}, []
    for repetition in range(options.repetitions):
        for sequence in sequences:
            for method in rotated(options.methods, repetition):
                folder = labels_folder(sequence, method, output, options.datasets)
                yardsticks_ms.append(yardstick_ms())
                times = run_once(method, sequence, folder, options, peers)
                if repetition == 0:
                    figures = evaluate(options.program, sequence, folder)
                    results[method, sequence] = Result(method, sequence, figures)
                results[method, sequence].times.append(times)
                print(f"{repetition + 1}/{options.repetitions} {sequence.title} {method}",
                      file=sys.stderr)
    return list(results.values()), yardsticks_ms


def join_predictions(sequences, options):
    """What others have labelled; only accuracy."""
    results = []
    if options.predictions and len({sequence.name for sequence in sequences}) < len(sequences):
        raise ComparisonError("two of the datasets have a sequence of the same name, so that it is "
                              "not clear whose --predictions are; compare one dataset at a time")
    for given in options.predictions:
        name, folder = given.split("=", 1)
        for sequence in sequences:
            figures = evaluate(options.program, sequence, folder)
            results.append(Result(name, sequence, figures))
    return results


def compare(options, peers, output):
    sequences = find_sequences(options.datasets, options.sequence)
    results, yardsticks_ms = run_methods(sequences, options, peers, output)
    results += join_predictions(sequences, options)
    if not results:
        raise ComparisonError("nothing to compare: neither --methods nor --predictions")
    return Results(results, yardsticks_ms)


def main(arguments=None, peers=PEERS):
    options = parse(arguments, peers)
    one_thread.pin()
    try:
        with tempfile.TemporaryDirectory() as temporary:
            results = compare(options, peers, options.output or pathlib.Path(temporary))
    except (ComparisonError, PeerMissing) as error:
        sys.exit(f"compare.py: {error}")
    if options.csv:
        write_csv(results, options.csv)
    if options.plots:
        from plots import draw
        draw(results, options.plots)
    print(json.dumps(to_json(results), indent=2) if options.json else text(results))


if __name__ == "__main__":
    main()
