"""How the viewer shows a recording at first."""

from __future__ import annotations

from typing import Any

from ..datasets.extras import require
from .layer_images import LAYERS

FIRST = ("height", "slope", "obstacle_height", "traversability")


def blueprint(cells: int) -> Any:
    """The scan in space, beside it the layers of so many cells a side, below them the times."""
    rrb = require("rerun.blueprint", "view", "the viewer")
    # In the sensor's frame the eye follows it.
    space = rrb.Spatial3DView(
        name="Scan and terrain",
        origin="/world/sensor",
        contents="/world/**",
        background=rrb.Background(color=(18, 20, 24), kind=rrb.BackgroundKind.SolidColor),
        line_grid=rrb.LineGrid3D(visible=False),
        eye_controls=rrb.EyeControls3D(kind=rrb.Eye3DKind.Orbital, position=(-26, -14, 17),
                                       look_target=(6, 1, -2), eye_up=(0, 0, 1)),
    )
    # The rim of the map is seldom seen.
    shown = rrb.VisualBounds2D(x_range=(cells / 6, cells * 5 / 6), y_range=(cells / 6, cells * 5 / 6))
    views = {name: rrb.Spatial2DView(name=name.replace("_", " ").capitalize(),
                                     origin=f"/layers/{name}", visual_bounds=shown)
             for name in LAYERS}
    layers = rrb.Grid(*[views.pop(name) for name in FIRST], grid_columns=2, name="Layers")
    others = rrb.Grid(*views.values(), grid_columns=2, name="More layers")
    times = rrb.Tabs(
        rrb.TimeSeriesView(name="Milliseconds a scan", origin="/time"),
        rrb.TimeSeriesView(name="Points of a scan, %", origin="/share"),
    )
    return rrb.Blueprint(
        rrb.Horizontal(space, rrb.Vertical(rrb.Tabs(layers, others), times, row_shares=[3, 1]),
                       column_shares=[3, 2]),
        rrb.TimePanel(state="collapsed", timeline="scan"),
        rrb.SelectionPanel(state="hidden"),
        rrb.BlueprintPanel(state="hidden"),
    )
