"""One scan of which nothing else is known: labels, heights, and how high the LiDAR is.

    python examples/python/one_scan.py [SCAN]

SCAN is anything that a loader reads, such as a .bin, .pcd, .ply, .npy or .laz file; without it a
scan is simulated.
"""

import sys

import groundgrid
from groundgrid import Label


def read_points(arguments):
    if not arguments:
        return groundgrid.simulation.Drive("urban", "hdl-64e", scans=1)[0].points
    return next(iter(groundgrid.datasets.open(arguments[0]))).points


def main(arguments):
    points = read_points(arguments)
    grid = groundgrid.GroundGrid()  # or GroundGrid(sensor_height_m=1.73)
    result = grid.process(points)

    ground = points[result.labels == Label.GROUND]
    obstacles = points[result.labels == Label.OBSTACLE]
    print(f"{len(points)} points: {len(ground)} ground, {len(obstacles)} obstacles, "
          f"{result.outlier} below the ground, {result.unknown} without an answer")
    if result.sensor_height_m is not None:
        print(f"the LiDAR is {result.sensor_height_m:.2f} m over the ground")

    # Label and height belong to the point of the same index.
    heights = result.height_above_ground[result.labels == Label.OBSTACLE]
    if len(heights):
        print(f"the highest obstacle is {heights.max():.1f} m high")


if __name__ == "__main__":
    main(sys.argv[1:])
