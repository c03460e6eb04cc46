"""Other threads run while a scan is at work."""

import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from groundgrid import GroundGrid


def answers(grid, points, calls):
    found = []
    for _ in range(calls):
        result = grid.process(points)
        assert grid.terrain.size > 0
        found.append(result.labels.tobytes() + result.height_above_ground.tobytes())
    return found


def test_threads_take_turns(plane):
    """Three threads on one grid get what one thread would, two on grids of their own do, too."""
    calls = 20
    expected = answers(GroundGrid(sensor_height_m=1.5), plane, 3 * calls)
    shared = GroundGrid(sensor_height_m=1.5)
    grids = [shared] * 3 + [GroundGrid(sensor_height_m=1.5) for _ in range(2)]
    with ThreadPoolExecutor(len(grids)) as threads:
        found = list(threads.map(lambda grid: answers(grid, plane, calls), grids))
    assert sorted(found[0] + found[1] + found[2]) == sorted(expected)
    assert found[3] == found[4] == expected[:calls]


def test_other_threads_run_meanwhile():
    """While a call is at work, this thread counts on: it would stand still without the GIL."""
    points = np.random.default_rng(0).uniform(-50, 50, (4_000_000, 3)).astype(np.float32)
    grid = GroundGrid(sensor_height_m=1.5)
    done = threading.Event()

    def work():
        grid.process(points)
        done.set()

    thread = threading.Thread(target=work)
    thread.start()
    longest, last = 0.0, time.perf_counter()
    begin = last
    while not done.is_set():
        time.sleep(0.001)
        now = time.perf_counter()
        longest, last = max(longest, now - last), now
    thread.join()
    # Were the GIL held, all of the call would be one pause.
    assert longest < 0.5 * (last - begin)
