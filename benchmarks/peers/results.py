"""What was found, and the tables made of it."""

import csv
import dataclasses

import numpy as np

COUNTS = ("tp", "fp", "fn", "tn", "unanswered")


def iou(counts):
    """Percent; NaN where there is nothing to find."""
    union = counts["tp"] + counts["fp"] + counts["fn"]
    return 100 * counts["tp"] / union if union else float("nan")


def counts_of(figures):
    return {name: figures[name] for name in COUNTS}


def added(all_counts):
    return {name: sum(counts[name] for counts in all_counts) for name in COUNTS}


def near_parts(figures):
    """By distance, up to 50 m: there every method answers, and SemanticKITTI has its labels."""
    return [part for part in figures["distances"] if part["to_m"]]


def near(figures):
    return added([counts_of(part) for part in near_parts(figures)])


def distance_name(part):
    return f"{part['from_m']:g}-{part['to_m']:g} m" if part["to_m"] else f"{part['from_m']:g}+ m"


@dataclasses.dataclass
class Result:
    """One method on one sequence."""
    method: str
    sequence: object
    figures: dict  # of `groundgrid evaluate`
    times: list = dataclasses.field(default_factory=list)  # a list of ScanTime a repetition

    def milliseconds(self, kind):
        """For each scan the median of its repetitions; empty where that time is not known."""
        values = [[getattr(time, kind) for time in repetition] for repetition in self.times]
        if not values or values[0][0] is None:
            return np.array([])
        return np.median(np.array(values), axis=0)


class Results:
    def __init__(self, results, yardsticks_ms):
        self.all = results
        self.yardsticks_ms = yardsticks_ms

    @property
    def methods(self):
        return list(dict.fromkeys(result.method for result in self.all))

    @property
    def timed_methods(self):
        return list(dict.fromkeys(result.method for result in self.all if result.times))

    def of(self, method, simulated):
        return [result for result in self.all
                if result.method == method and result.sequence.simulated == simulated]

    @property
    def groups(self):
        """Whether simulated, of those that there are."""
        return sorted({result.sequence.simulated for result in self.all})

    def ious(self, method, simulated, counts=near):
        """By title of the sequence, and their mean."""
        values = {result.sequence.title: iou(counts(result.figures))
                  for result in self.of(method, simulated)}
        return {**values, "mean": float(np.mean(list(values.values())))}

    def ious_table(self, simulated, counts=near):
        return ious_table({method: self.ious(method, simulated, counts)
                           for method in self.methods})

    def reaches_far(self, simulated):
        """Whether there are points beyond 50 m that count."""
        return any(near(result.figures) != counts_of(result.figures)
                   for method in self.methods for result in self.of(method, simulated))

    def distance_ious(self, method, simulated):
        """All points of the sequences pooled."""
        parts = {}
        for result in self.of(method, simulated):
            for part in near_parts(result.figures):
                parts.setdefault(distance_name(part), []).append(counts_of(part))
        return {name: iou(added(counts)) for name, counts in parts.items()}

    def unanswered(self, method, simulated):
        """Percent of the points that have a label that counts."""
        results = self.of(method, simulated)
        total = sum(result.figures["points"] for result in results)
        return 100 * sum(result.figures["unanswered"] for result in results) / total

    def milliseconds(self, method, simulated, kind):
        return np.concatenate([result.milliseconds(kind)
                               for result in self.of(method, simulated)])


def group_name(simulated):
    return "simulated drives" if simulated else "real scans"


def ious_table(rows):
    """Rows of method and values by column; the best of each column is bold. Columns without any
    ground are left out."""
    columns = [column for column in next(iter(rows.values()))
               if any(np.isfinite(values[column]) for values in rows.values())]
    best = {column: np.nanmax([round(values[column], 2) for values in rows.values()])
            for column in columns}
    lines = ["| | " + " | ".join(columns) + " |", "| --- |" + " --- |" * len(columns)]
    for method, values in rows.items():
        texts = [iou_text(values[column], best[column]) for column in columns]
        lines.append(f"| {method} | " + " | ".join(texts) + " |")
    return "\n".join(lines)


def iou_text(value, best):
    if not np.isfinite(value):
        return "-"
    return f"**{value:.2f}**" if round(value, 2) == best else f"{value:.2f}"


def time_text(values):
    if not len(values):
        return "- | -"
    return f"{np.median(values):.1f} | {np.percentile(values, 95):.1f}"


def times_table(results, simulated):
    """Of the methods that were run here."""
    lines = ["| | method alone, median | 95 % | call from Python, median | 95 % |",
             "| --- | --- | --- | --- | --- |"]
    lines += [f"| {method} | {time_text(results.milliseconds(method, simulated, 'own'))} | "
              f"{time_text(results.milliseconds(method, simulated, 'call'))} |"
              for method in results.timed_methods]
    return "\n".join(lines)


def text(results):
    parts = []
    for simulated in results.groups:
        name = group_name(simulated)
        parts += [f"IoU of ground in percent up to 50 m, {name}", results.ious_table(simulated)]
        parts += [f"IoU by distance, points pooled, {name}", ious_table(
            {method: results.distance_ious(method, simulated) for method in results.methods})]
        if results.reaches_far(simulated):
            parts += [f"IoU of ground in percent at all distances, {name}",
                      results.ious_table(simulated, counts_of)]
        unanswered = {method: results.unanswered(method, simulated) for method in results.methods}
        parts += [f"{method} leaves {share:.2f} % of the points of the {name} unanswered: "
                  "counted nowhere" for method, share in unanswered.items() if share > 0]
        if results.timed_methods:
            parts += [f"Milliseconds a scan on one core, {name}", times_table(results, simulated)]
    if results.yardsticks_ms:
        low, high = np.min(results.yardsticks_ms), np.max(results.yardsticks_ms)
        parts.append(f"To copy 8 MB took {np.median(results.yardsticks_ms):.2f} ms in the median, "
                     f"{low:.2f} to {high:.2f}, between the runs.")
    return "\n\n".join(parts)


def times_summary(result):
    summary = {}
    for kind in ("own", "call", "cpu"):
        values = result.milliseconds(kind)
        summary[f"{kind}_ms_median"] = float(np.median(values)) if len(values) else None
        summary[f"{kind}_ms_95"] = float(np.percentile(values, 95)) if len(values) else None
    return summary


def to_json(results):
    return {
        "yardstick_ms": results.yardsticks_ms,
        "results": [{"method": result.method, "dataset": str(result.sequence.dataset),
                     "simulated": result.sequence.simulated, "title": result.sequence.title,
                     **result.figures, **times_summary(result)} for result in results.all]}


def write_csv(results, path):
    """A row for each method, sequence and distance, one for all up to 50 m, and one for all
    distances, which has the times."""
    with open(path, "w", newline="") as file:
        writer = csv.writer(file)
        times = list(times_summary(results.all[0]))
        writer.writerow(["method", "dataset", "sequence", "title", "distance", "iou", *COUNTS,
                         *times])
        for result in results.all:
            heading = [result.method, result.sequence.dataset, result.sequence.name,
                       result.sequence.title]
            for name, part in [("all", result.figures), ("0-50 m", near(result.figures))] + [
                    (distance_name(part), part) for part in result.figures["distances"]]:
                own_times = times_summary(result).values() if name == "all" else [None] * len(times)
                writer.writerow([*heading, name, f"{iou(part):.4f}", *counts_of(part).values(),
                                 *own_times])
