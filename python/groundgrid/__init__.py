"""LiDAR ground segmentation and terrain estimation: NumPy arrays in, NumPy arrays out.

    grid = groundgrid.GroundGrid()
    result = grid.process(points, pose)  # N x 3 or more, T_map_base 4 x 4
    result.labels                        # uint8, N: Label.GROUND, OBSTACLE, OUTLIER, UNKNOWN
    result.height_above_ground           # float32, N: metres, NaN where unknown
    grid.terrain.height                  # float64, rows x columns: metres, map frame

`groundgrid.datasets` reads scans, `groundgrid.evaluation` scores labels and
terrains, `groundgrid.simulation` drives LiDARs through made-up worlds whose labels and terrain are
known exactly.
"""

from . import datasets, evaluation, rasters, simulation, viewer
from ._core import (
    Config,
    GroundGrid,
    Label,
    Parameter,
    ScanResult,
    SensorScan,
    Terrain,
    TerrainLayers,
    Traversability,
    TraversabilityLimits,
    estimate_sensor_height,
    parameters,
)
from ._core import version as __version__

__all__ = [
    "Config",
    "GroundGrid",
    "Label",
    "Parameter",
    "ScanResult",
    "SensorScan",
    "Terrain",
    "TerrainLayers",
    "Traversability",
    "TraversabilityLimits",
    "__version__",
    "datasets",
    "estimate_sensor_height",
    "evaluation",
    "parameters",
    "rasters",
    "simulation",
    "viewer",
]
