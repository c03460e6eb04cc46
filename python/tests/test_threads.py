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
    """In the middle of a call this thread looks at the clock, which it could not without the GIL."""
    points = np.random.default_rng(0).uniform(-50, 50, (4_000_000, 3)).astype(np.float32)
    grid = GroundGrid(sensor_height_m=1.5)
    seen_inside = False
    # One call would do, were it not for a machine so busy that this thread has to wait for it.
    for _ in range(20):
        spans, looks = [], []

        def work(spans=spans):
            begin = time.perf_counter()
            grid.process(points)
            spans.append((begin, time.perf_counter()))

        thread = threading.Thread(target=work)
        thread.start()
        while thread.is_alive():
            looks.append(time.perf_counter())
            time.sleep(0.001)
        (begin, end), = spans
        quarter = (end - begin) / 4
        seen_inside |= any(begin + quarter < look < end - quarter for look in looks)
        if seen_inside:
            break
    assert seen_inside
