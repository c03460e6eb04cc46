#!/usr/bin/env python3
"""What each parameter of the default brings a sequence when its value is chosen on the others: the
table of docs/accuracy.md.

    python3 scripts/leave_one_out.py path/to/groundgrid DATASET

For each parameter and each sequence the value (of PARAMETERS, all others at their defaults) with the
best mean IoU of the other sequences is taken, and the IoU of the sequence with it is set beside
that with the first value, which is the one without the change, and with the default. With
--single-scan every scan is on its own.
"""

import argparse
import json
import subprocess

# Without the change first, the default among the rest.
PARAMETERS = {
    "outlier-min-confidence": ["1.25", "4", "8", "16"],
    "outlier-min-depth-m": ["-1e6", "0.15", "0.3", "0.6"],
    "variance-distance-factor": ["1e-5", "2e-5", "5e-5", "1e-4"],
    "min-variance-threshold": ["5e-5", "2e-4", "5e-4", "1e-3"],
    "patch-change-distance-m": ["20", "30", "40", "60"],
    "own-variance-min-points": ["10", "3", "5", "7"],
    "max-cell-slope": ["0", "0.35", "0.7", "1"],
    "reject-raised": ["false", "true"],
    "fit-surface": ["false", "true"],
    "surface-block-m": ["1.6", "4.5", "14"],
    "surface-tolerance-m": ["0.5", "0.03", "0.06", "0.1", "0.15"],
    "surface-step-m": ["10", "0.2", "0.3", "0.4", "0.6"],
    "plateau-area-m2": ["1e6", "2", "5", "10", "20"],
    "plateau-height-m": ["0", "0.5", "1", "2"],
    "surface-min-confidence": ["1", "0.02", "0.05", "0.1", "0.2"],
    "surface-follow-m": ["0", "0.05", "0.1", "0.15", "0.2"],
    "threshold-by-column": ["false", "true"],
    "ground-threshold-m": ["0.3", "0.1", "0.15", "0.2", "0.25"],
    "tall-threshold-m": ["0.2", "0.03", "0.06", "0.09", "0.12"],
    "tall-height-m": ["10", "0.2", "0.3", "0.4", "0.6"],
    "tall-min-share": ["0", "0.05", "0.1", "0.15", "0.2", "0.3"],
    "level-band-m": ["0.01", "0.05", "0.1", "0.15", "0.2"],
}


def iou_by_sequence(arguments, *flags):
    command = [arguments.groundgrid, "evaluate", arguments.dataset, "--json",
               "--leave-unanswered-out", *flags]
    if arguments.single_scan:
        command.append("--single-scan")
    result = subprocess.run(command, check=True, capture_output=True, text=True)
    return {row["sequence"]: 100.0 * row["iou"] for row in json.loads(result.stdout)["sequences"]}


def mean(values):
    values = list(values)
    return sum(values) / len(values)


def chosen_without(sequence, results):
    """The value that is best for the other sequences."""
    def of_others(value):
        return mean(iou for other, iou in results[value].items() if other != sequence)
    return max(results, key=of_others)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("groundgrid")
    parser.add_argument("dataset")
    parser.add_argument("--single-scan", action="store_true")
    parser.add_argument("--parameter", action="append", choices=PARAMETERS)
    arguments = parser.parse_args()

    default = iou_by_sequence(arguments)
    sequences = list(default)
    print(f"| parameter | {' | '.join(sequences)} | mean | default brings |")
    print("| --- |" + " --- |" * (len(sequences) + 2))
    for parameter in arguments.parameter or PARAMETERS:
        values = PARAMETERS[parameter]
        results = {value: iou_by_sequence(arguments, f"--{parameter}", value) for value in values}
        without = results[values[0]]
        cells, gains = [], []
        for sequence in sequences:
            value = chosen_without(sequence, results)
            gains.append(results[value][sequence] - without[sequence])
            cells.append(f"{gains[-1]:+.2f} ({value})")
        brings = mean(default[s] - without[s] for s in sequences)
        print(f"| `{parameter.replace('-', '_')}` ({values[0]}) | {' | '.join(cells)} | "
              f"{mean(gains):+.2f} | {brings:+.2f} |", flush=True)


if __name__ == "__main__":
    main()
