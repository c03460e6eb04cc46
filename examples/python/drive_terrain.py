"""A drive: the terrain that it saw as a GeoTIFF, and where a car can go now.

    python examples/python/drive_terrain.py TERRAIN.tif [INPUT]

INPUT is anything with poses that a loader reads, such as a sequence of KITTI or a bag; without it
a drive is simulated. Needs groundgrid[geo].
"""

import sys

import numpy as np

import groundgrid
from groundgrid import Traversability, TraversabilityLimits


def open_scans(arguments):
    if arguments:
        return groundgrid.datasets.open(arguments[0])
    return groundgrid.simulation.Drive("urban", "hdl-64e", scans=10)


def main(arguments):
    if not arguments:
        sys.exit(__doc__)
    path, *rest = arguments
    grid = groundgrid.GroundGrid()
    mosaic = groundgrid.rasters.TerrainMosaic(path)  # crs="EPSG:32632" where the poses are in it
    for scan in open_scans(rest):
        result = grid.process(scan.points, scan.pose)
        mosaic.add(grid)
    mosaic.finish()
    print(f"{path}: the terrain of the drive")

    # The rolling map around the vehicle is there after each scan.
    terrain = grid.terrain
    column, row = np.floor((scan.pose[:2, 3] - (terrain.min_x_m, terrain.min_y_m))
                           / terrain.resolution_m).astype(int)
    print(f"under the sensor the ground is at {terrain.height[row, column]:.2f} m, "
          f"give or take {terrain.standard_deviation[row, column]:.2f} m")

    layers = groundgrid.TerrainLayers()
    layers.update(grid, scan.points, scan.pose, result.labels,
                  limits=TraversabilityLimits(max_step_m=0.05))
    cell_m2 = terrain.resolution_m**2
    for name in ("YES", "NO"):
        cells = np.count_nonzero(layers.traversability == Traversability[name])
        print(f"{cells * cell_m2:.0f} m2 can{'' if name == 'YES' else 'not'} be driven over")
    print(f"the steepest of it has {np.nanmax(layers.slope_deg):.0f} degrees")


if __name__ == "__main__":
    main(sys.argv[1:])
