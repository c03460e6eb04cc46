"""The labelled sequences of datasets in SemanticKITTI layout, real or simulated."""

import dataclasses
import json
import pathlib

KITTI_SENSOR_HEIGHT_M = 1.73


class ComparisonError(Exception):
    """What the user can mend; printed without a traceback."""


@dataclasses.dataclass(frozen=True)
class Sequence:
    dataset: pathlib.Path
    name: str
    title: str  # the scene of a simulated drive, else its name
    simulated: bool
    sensor_height_m: float  # over the ground

    @property
    def scans(self):
        return sorted((self.dataset / "sequences" / self.name / "velodyne").glob("*.bin"))


def read_sequence(folder):
    dataset = folder.parent.parent
    record = folder / "truth" / "drive.json"
    if not record.exists():
        return Sequence(dataset, folder.name, folder.name, False, KITTI_SENSOR_HEIGHT_M)
    drive = json.loads(record.read_text())
    height = drive["T_base_sensor"][2][3]  # base is on the ground
    return Sequence(dataset, folder.name, drive["scene"], True, height)


def find_sequences(datasets, names):
    """Those with scans and labels; with names only these, from every dataset that has them."""
    found = []
    for dataset in datasets:
        for folder in sorted((dataset / "sequences").glob("*")):
            if names and folder.name not in names:
                continue
            if (folder / "labels").is_dir() and any((folder / "velodyne").glob("*.bin")):
                found.append(read_sequence(folder))
    if not found:
        raise ComparisonError(
            f"no sequences/NN with velodyne/*.bin and labels below {', '.join(map(str, datasets))}"
            + (f" is one of {', '.join(names)}" if names else ""))
    return found
