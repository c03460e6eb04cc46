"""Pictures of what compare.py found. IoU is drawn so that half the errors are the same step
everywhere: 90 to 95 is as far as 98 to 99."""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np

from results import group_name

TICKS = [20, 40, 60, 70, 80, 90, 95, 98, 99, 99.5, 99.8]
COLORS = ["#4477aa", "#ee6677", "#228833", "#ccbb44", "#66ccee", "#aa3377", "#ee8833", "#882255",
          "#44aa99", "#332288"]
OURS = {"groundgrid": "#000000", "groundgrid single scan": "#555555", "groundgrid paper": "#999999"}
MARKERS = "osD^vPX<>*"


def set_iou_axis(axis, along, values):
    """From the worst of the values to the best, with some room."""
    errors = 100 - np.array(values)
    limits = (1.15 * errors.max(), 0.85 * errors.min())
    ticks = [tick for tick in TICKS if limits[1] <= 100 - tick <= limits[0]]
    getattr(axis, f"set_{along}scale")("log")
    getattr(axis, f"set_{along}lim")(*limits)
    getattr(axis, f"set_{along}ticks")([100 - tick for tick in ticks],
                                       [f"{tick:g}" for tick in ticks])
    getattr(axis, f"set_{along}ticks")([], minor=True)
    axis.grid(True, color="#dddddd", linewidth=0.6)
    axis.set_axisbelow(True)


def colors(methods):
    others = [method for method in methods if method not in OURS]
    return {**OURS, **{method: COLORS[i % len(COLORS)] for i, method in enumerate(others)}}


def save(figure, path):
    figure.savefig(path, dpi=110, bbox_inches="tight")
    plt.close(figure)


def draw_accuracy(results, path):
    """A row a method, a mark a sequence, the best mean at the top."""
    groups = results.groups
    figure, axes = plt.subplots(len(groups), 1, squeeze=False, layout="constrained",
                                figsize=(8, (0.9 + 0.3 * len(results.methods)) * len(groups)))
    for axis, simulated in zip(axes[:, 0], groups):
        rows = {method: results.ious(method, simulated) for method in results.methods}
        order = sorted(rows, key=lambda method: rows[method]["mean"])
        titles = [title for title in rows[order[0]] if title != "mean"]
        for i, title in enumerate(titles):
            axis.plot([100 - rows[method][title] for method in order], range(len(order)),
                      MARKERS[i % len(MARKERS)], color=COLORS[i % len(COLORS)], markersize=6,
                      label=title)
        axis.plot([100 - rows[method]["mean"] for method in order], range(len(order)), "|",
                  color="black", markersize=15, markeredgewidth=2, label="mean", zorder=1)
        axis.set_yticks(range(len(order)), order)
        set_iou_axis(axis, "x", [value for row in rows.values() for value in row.values()])
        axis.set_xlabel("IoU of ground up to 50 m, percent")
        axis.set_title(group_name(simulated))
        axis.legend(fontsize="small", loc="upper left", bbox_to_anchor=(1.01, 1))
    save(figure, path)


def draw_distance(results, path):
    groups = results.groups
    figure, axes = plt.subplots(1, len(groups), squeeze=False, layout="constrained",
                                figsize=(1.6 + 4.2 * len(groups), 4.2))
    color = colors(results.methods)
    for axis, simulated in zip(axes[0], groups):
        rows = {method: results.distance_ious(method, simulated) for method in results.methods}
        names = [name for name in next(iter(rows.values()))
                 if all(np.isfinite(row[name]) for row in rows.values())]
        for i, (method, row) in enumerate(rows.items()):
            axis.plot(range(len(names)), [100 - row[name] for name in names],
                      marker=MARKERS[i % len(MARKERS)], markersize=4, color=color[method],
                      linewidth=2.4 if method in OURS else 1.3, label=method)
        axis.set_xticks(range(len(names)), [name.removesuffix(" m") for name in names])
        set_iou_axis(axis, "y", [row[name] for row in rows.values() for name in names])
        axis.set_xlabel("distance from the sensor, m")
        axis.set_title(group_name(simulated))
    axes[0, 0].set_ylabel("IoU of ground, percent")
    axes[0, -1].legend(fontsize="small", loc="upper left", bbox_to_anchor=(1.01, 1))
    save(figure, path)


def draw_time(results, path):
    groups = results.groups
    figure, axes = plt.subplots(1, len(groups), squeeze=False, layout="constrained",
                                figsize=(1.8 + 4.4 * len(groups), 4.2))
    color = colors(results.timed_methods)
    for axis, simulated in zip(axes[0], groups):
        means = {method: results.ious(method, simulated)["mean"]
                 for method in results.timed_methods}
        for i, (method, mean) in enumerate(means.items()):
            marker = {"color": color[method], "marker": MARKERS[i % len(MARKERS)]}
            medians = {kind: np.median(values) for kind in ("own", "call")
                       if len(values := results.milliseconds(method, simulated, kind))}
            axis.plot(list(medians.values()), [100 - mean] * len(medians), linewidth=1,
                      color=color[method])
            for kind, median in medians.items():
                axis.plot(median, 100 - mean, markersize=8, **marker,
                          markerfacecolor=color[method] if kind == "own" else "white")
            axis.plot([], [], linestyle="", **marker, label=method)
        axis.set_xscale("log")
        axis.xaxis.set_major_formatter("{x:g}")
        set_iou_axis(axis, "y", list(means.values()))
        axis.set_xlabel("milliseconds a scan, median, one core")
        axis.set_title(group_name(simulated))
    axes[0, 0].set_ylabel("mean IoU of ground up to 50 m, percent")
    axes[0, -1].legend(fontsize="small", loc="upper left", bbox_to_anchor=(1.01, 1),
                       title="filled: method alone\nhollow: called from Python",
                       title_fontsize="small", alignment="left")
    save(figure, path)


def draw(results, folder):
    folder.mkdir(parents=True, exist_ok=True)
    draw_accuracy(results, folder / "peers-accuracy.png")
    draw_distance(results, folder / "peers-distance.png")
    if results.timed_methods:
        draw_time(results, folder / "peers-time.png")
