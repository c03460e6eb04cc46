"""Poses from quaternions, between two times, and along a tree of frames."""

from __future__ import annotations

from bisect import bisect_left
from typing import Any

import numpy as np
import numpy.typing as npt

Matrix = npt.NDArray[np.float64]
Vector = npt.NDArray[np.float64]

# How far a time may lie before the first pose or behind the last one.
TOLERANCE_NS = 100_000_000


class PoseMissing(Exception):
    """Why a frame has no pose at a time, in words."""


def quaternion_of(orientation: Any) -> Vector:
    """x, y, z, w of length 1 from members of these names. Raises ValueError for another length."""
    quaternion = np.array([orientation.x, orientation.y, orientation.z, orientation.w], np.float64)
    length = np.linalg.norm(quaternion)
    if not abs(length - 1.0) <= 1e-3:
        raise ValueError(f"expected a quaternion of length 1, got one of length {length}")
    return quaternion / length


def matrix_of(position: Vector, quaternion: Vector) -> Matrix:
    """4 x 4 of a translation and a quaternion x, y, z, w."""
    x, y, z, w = quaternion
    matrix = np.eye(4)
    matrix[:3, :3] = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    matrix[:3, 3] = position
    return matrix


def quaternion_from(matrix: Matrix) -> Vector:
    """x, y, z, w of the rotation of a rigid transform."""
    (a, b, c), (d, e, f), (g, h, i) = matrix[:3, :3]
    # The quaternion is the eigenvector of the greatest eigenvalue, whatever the angle.
    symmetric = np.array([
        [a - e - i, d + b, g + c, h - f],
        [d + b, e - a - i, h + f, c - g],
        [g + c, h + f, i - a - e, d - b],
        [h - f, c - g, d - b, a + e + i],
    ])
    quaternion: Vector = np.linalg.eigh(symmetric)[1][:, -1]
    return quaternion


def between(first: Vector, second: Vector, share: float) -> Vector:
    """A rotation between two, about one axis at one speed."""
    cosine = float(first @ second)
    if cosine < 0.0:
        second, cosine = -second, -cosine
    angle = np.arccos(min(cosine, 1.0))
    if angle < 1e-6:
        mixed = (1.0 - share) * first + share * second
    else:
        mixed = np.sin((1.0 - share) * angle) * first + np.sin(share * angle) * second
    return mixed / np.linalg.norm(mixed)


class Track:
    """The way of one frame in another."""

    def __init__(self) -> None:
        self._poses: dict[int, tuple[Vector, Vector]] = {}
        self._times: list[int] = []

    def add(self, time_ns: int, position: Any, orientation: Any) -> None:
        place = np.array([position.x, position.y, position.z], np.float64)
        if not np.isfinite(place).all():
            raise ValueError(f"expected a finite translation, got {', '.join(map(str, place))}")
        self._poses[time_ns] = place, quaternion_of(orientation)
        self._times = []

    def add_matrix(self, time_ns: int, matrix: Matrix) -> None:
        self._poses[time_ns] = matrix[:3, 3], quaternion_from(matrix)
        self._times = []

    def at(self, time_ns: int) -> Matrix | None:
        """Interpolated; None where the time lies outside of the track."""
        times = self.times_ns()
        after = bisect_left(times, time_ns)
        if 0 < after < len(times):
            return self._between(times[after - 1], times[after], time_ns)
        nearest = times[0 if after == 0 else -1]
        return matrix_of(*self._poses[nearest]) if abs(nearest - time_ns) <= TOLERANCE_NS else None

    def times_ns(self) -> list[int]:
        """Of the poses, in order."""
        if not self._times:
            self._times = sorted(self._poses)
        return self._times

    def _between(self, first: int, second: int, time_ns: int) -> Matrix:
        share = (time_ns - first) / (second - first)
        (begin, begin_turn), (end, end_turn) = self._poses[first], self._poses[second]
        return matrix_of(begin + share * (end - begin), between(begin_turn, end_turn, share))


class FrameTree:
    """Frames and where they are in their parents."""

    def __init__(self) -> None:
        self._fixed: dict[str, tuple[str, Matrix]] = {}
        self._moving: dict[str, tuple[str, Track]] = {}
        self._refused: dict[str, str] = {}

    def add_fixed(self, parent: str, child: str, position: Any, orientation: Any) -> None:
        """Raises ValueError for numbers that are no pose."""
        track = Track()
        track.add(0, position, orientation)
        matrix = track.at(0)
        assert matrix is not None
        self._fixed[child] = parent, matrix

    def add_moving(
        self, parent: str, child: str, time_ns: int, position: Any, orientation: Any
    ) -> None:
        """Raises ValueError for numbers that are no pose, and for another parent than before."""
        known, track = self._moving.setdefault(child, (parent, Track()))
        if parent != known:
            raise ValueError(f"expected one parent, got {known!r} and {parent!r}")
        track.add(time_ns, position, orientation)

    def refuse(self, child: str, words: str) -> None:
        """Where the frame is in its parent cannot be told. Frames that do not need it still can."""
        self._refused[child] = words

    def is_empty(self) -> bool:
        """Whether there is nothing that could be a pose."""
        return not (self._fixed or self._moving or self._refused)

    def children(self) -> set[str]:
        """The frames that have a parent."""
        return {*self._fixed, *self._moving}

    def names(self) -> list[str]:
        """All frames, in alphabetical order."""
        parents = {parent for parent, _ in [*self._fixed.values(), *self._moving.values()]}
        return sorted(self.children() | parents)

    def above(self, frame: str, reference: str | None = None) -> list[str]:
        """The frame and those above it, up to the reference; each once where they form a ring."""
        names = [frame]
        while frame != reference and (frame in self._moving or frame in self._fixed):
            frame = (self._moving.get(frame) or self._fixed[frame])[0]
            if frame in names:
                break
            names.append(frame)
        return names

    def pose(self, frame: str, time_ns: int, reference: str | None = None) -> Matrix:
        """T_reference_frame, the reference being the root of the tree where it is left out.

        Raises PoseMissing where the frame has no parent, nothing above it moves, the reference is
        not above it, or a time is unknown, and ValueError where a frame on the way is refused.
        """
        names = self.above(frame, reference)
        for each in names:
            if each in self._refused and each != reference:
                raise ValueError(f"frame {each!r}: {self._refused[each]}")
        *children, top = names
        is_ring = top != reference and top in self.children()
        if is_ring:
            raise PoseMissing(f"the frames above {frame!r} form a ring: {', '.join(names)}")
        if reference not in (None, top) or not children and reference is None:
            raise PoseMissing(self._not_placed(frame, reference))
        if reference is None and not any(each in self._moving for each in children):
            raise PoseMissing(f"{frame!r} is fixed in {top!r}, and nothing says how {top!r} moves; "
                              f"there are {self._quoted_names()}")
        matrix = np.eye(4)
        for each in children:
            matrix = self._step(each, time_ns) @ matrix
        return matrix

    def _not_placed(self, frame: str, reference: str | None) -> str:
        others = sorted(each for each in self.children() if frame in self.above(each))
        if reference is None and others:
            return (f"the cloud is in {frame!r}, in which TF or odometry places "
                    f"{', '.join(map(repr, others))}: that of a map, not of the sensor; name the "
                    "sensor's odometry with odometry= to have it told from the sensor")
        name = repr(frame) if frame else "'' (its header names none)"
        where = "in any other" if reference is None else f"in {reference!r}"
        return (f"neither TF nor odometry says where the cloud's frame {name} is {where}; there "
                f"are {self._quoted_names()}; record the transform to it, too (/tf_static)")

    def _quoted_names(self) -> str:
        return ", ".join(map(repr, self.names())) or "none"

    def _step(self, child: str, time_ns: int) -> Matrix:
        """T_parent_child. Raises PoseMissing outside of the times that are known."""
        if child not in self._moving:
            return self._fixed[child][1]
        parent, track = self._moving[child]
        matrix = track.at(time_ns)
        if matrix is None:
            first, last = track.times_ns()[0], track.times_ns()[-1]
            raise PoseMissing(f"its time is {'before' if time_ns < first else 'behind'} the poses "
                              f"of {child!r} in {parent!r}, which are from {first * 1e-9:.3f} to "
                              f"{last * 1e-9:.3f} s")
        return matrix
