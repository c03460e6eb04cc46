"""Rerun recordings of what the method makes of scans: pip install 'groundgrid[view]'.

    with groundgrid.viewer.Recording("drive.rrd") as recording:
        for scan in groundgrid.datasets.open("path/to/recording"):
            result = grid.process(scan.points, scan.pose)
            recording.add(scan, result, grid)
"""

from .recording import Recording

__all__ = ["Recording"]
