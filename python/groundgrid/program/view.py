"""groundgrid-py view: a drive in the Rerun viewer."""

from __future__ import annotations

import argparse
import time
from pathlib import Path
from typing import Any

from .._core import GroundGrid
from ..viewer import Recording
from .options import Inputs, add_input, add_method, config_of, open_input, positive, scans_of
from .web_viewer import serve


def add_to(commands: Any) -> None:
    parser = commands.add_parser(
        "view", help="scans, terrain and layers in the Rerun viewer",
        description="Writes a Rerun recording: each scan coloured by label, the terrain as a mesh, "
        "its layers as images, the path, and the time of each scan. Show it with `rerun FILE.rrd`, "
        "or in a browser with --web.",
    )
    add_input(parser)
    add_method(parser)
    group = parser.add_argument_group("output")
    group.add_argument("--output", type=Path, metavar="FILE.rrd", help="[INPUT.rrd, here]")
    group.add_argument("--terrain-every", type=positive, default=5, metavar="N",
                       help="the terrain for one scan in N [5]")
    group.add_argument("--web", action="store_true", help="serve it to a browser until Ctrl-C")
    group.add_argument("--port", type=positive, default=9090, help="of --web, and the next one [9090]")
    parser.set_defaults(command=view)


def view(options: argparse.Namespace) -> None:
    output = options.output or Path(options.input.resolve().stem + ".rrd")
    dataset = open_input(options)
    Inputs(dataset, options).keep(output)
    config = config_of(options)
    grid = GroundGrid(config, threads=options.threads)
    count = 0
    with Recording(output, terrain_every=options.terrain_every) as recording:
        for scan in scans_of(dataset, options, config):
            if scan.pose is None:
                grid.reset()
            begin = time.perf_counter()
            result = grid.process(scan.points, scan.pose)
            recording.add(scan, result, grid, 1000 * (time.perf_counter() - begin))
            count += 1
        if count == 0:
            raise ValueError(f"{options.input}: expected scans, got none")
    print(f"{output}: {count} scans, {output.stat().st_size / 1e6:.1f} MB", flush=True)
    if options.web:
        serve(output, options.port)
