"""Recordings that the test writes, with fields laid out in odd ways."""


import numpy as np
import pytest
from rosbags.highlevel import AnyReader
from rosbags.rosbag1 import Writer as Writer1
from rosbags.rosbag2 import StoragePlugin
from rosbags.rosbag2 import Writer as Writer2
from rosbags.typesys import Stores, get_typestore, get_types_from_msg

import groundgrid
from groundgrid.datasets import BagDataset
from groundgrid.datasets.cloud_messages import definitions

STORE = get_typestore(Stores.ROS2_HUMBLE)
STORE1 = get_typestore(Stores.ROS1_NOETIC)
for each in (STORE, STORE1):
    for name, text in definitions().items():
        each.register(get_types_from_msg(text, name))
CLOUD = "sensor_msgs/msg/PointCloud2"
TYPES = {"i1": 1, "u1": 2, "i2": 3, "u2": 4, "i4": 5, "u4": 6, "f4": 7, "f8": 8}

# Fields with their types and offsets, bytes a point, rows and points a row, bytes behind a row,
# byte order.
LAYOUTS = {
    "plain": ([("x", "f4", 0), ("y", "f4", 4), ("z", "f4", 8), ("intensity", "f4", 12)],
              16, 1, 6, 0, "<"),
    "velodyne": ([("x", "f4", 0), ("y", "f4", 4), ("z", "f4", 8), ("intensity", "f4", 16),
                  ("ring", "u2", 20), ("time", "f4", 24)], 32, 1, 6, 0, "<"),
    "float64 behind a ring of uint8": ([("ring", "u1", 0), ("z", "f8", 1), ("y", "f8", 9),
                                        ("x", "f8", 17)], 26, 1, 6, 0, "<"),
    "organised with padded rows": ([("x", "f4", 0), ("y", "f4", 4), ("z", "f4", 8),
                                    ("intensity", "u2", 12)], 14, 2, 3, 5, "<"),
    "big-endian": ([("x", "f4", 0), ("y", "f4", 4), ("z", "f4", 8), ("t", "u4", 12)],
                   16, 1, 6, 0, ">"),
    "big-endian, organised, padded": ([("x", "f8", 0), ("y", "f8", 8), ("z", "f8", 16),
                                       ("intensity", "u1", 24)], 27, 3, 2, 4, ">"),
}


def values(name, scan):
    """What the points of a scan are, exact in every type."""
    start = {"x": 1, "y": 20, "z": -3, "intensity": 60, "ring": 5, "time": 8, "t": 70000}[name]
    return start + scan + np.arange(6)


def header(store, time_s, frame):
    kind = store.types["std_msgs/msg/Header"]
    stamp = store.types["builtin_interfaces/msg/Time"](int(time_s), int(round(time_s % 1 * 1e9)))
    extra = {"seq": 0} if store is STORE1 else {}
    return kind(**extra, stamp=stamp, frame_id=frame)


def cloud(store, layout, scan, time_s=0.0, frame="lidar"):
    fields, step, height, width, padding, order = LAYOUTS[layout]
    row = step * width + padding
    data = np.full(height * row, 0xEE, np.uint8)
    for name, kind, offset in fields:
        numbers = values(name, scan).astype(order + kind)
        for i in range(len(numbers)):
            begin = i // width * row + i % width * step + offset
            data[begin : begin + numbers.itemsize] = numbers[i : i + 1].view(np.uint8)
    field = store.types["sensor_msgs/msg/PointField"]
    return store.types[CLOUD](
        header=header(store, time_s, frame),
        height=height,
        width=width,
        fields=[field(name, offset, TYPES[kind], 1) for name, kind, offset in fields],
        is_bigendian=order == ">",
        point_step=step,
        row_step=row,
        data=data,
        is_dense=True,
    )


def write(path, messages, storage):
    """messages: (topic, message, recorded at, seconds)."""
    store = STORE1 if storage == "ros1" else STORE
    if storage == "ros1":
        path = path.with_suffix(".bag")
        writer = Writer1(path)
    else:
        writer = Writer2(path, version=9, storage_plugin=getattr(StoragePlugin, storage))
    with writer:
        connections = {}
        for topic, message, time_s in messages:
            kind = message.__msgtype__
            if topic not in connections:
                connections[topic] = writer.add_connection(topic, kind, typestore=store)
            serialize = store.serialize_ros1 if storage == "ros1" else store.serialize_cdr
            writer.write(connections[topic], int(time_s * 1e9), serialize(message, kind))
    return path


def store_of(storage):
    return STORE1 if storage == "ros1" else STORE


@pytest.mark.parametrize("storage", ["ros1", "SQLITE3", "MCAP"])
@pytest.mark.parametrize("layout", LAYOUTS)
def test_any_layout_comes_back_right_and_in_order(tmp_path, layout, storage):
    messages = [("/points", cloud(store_of(storage), layout, scan, scan), scan) for scan in range(3)]
    dataset = groundgrid.datasets.open(write(tmp_path / "drive", messages, storage))
    assert len(dataset) == 3 and dataset.topic == "/points"
    names = [name for name, _, _ in LAYOUTS[layout][0]]
    for number, scan in enumerate(dataset):
        assert scan.name == f"00000{number}" and scan.time_s == number and scan.pose is None
        assert list(scan.fields) == names
        for name, kind, _ in LAYOUTS[layout][0]:
            np.testing.assert_array_equal(scan.fields[name], values(name, number))
            assert scan.fields[name].dtype == np.dtype(kind)
        for column, name in enumerate(("x", "y", "z", "intensity")):
            expected = values(name, number) if name in names else np.zeros(6)
            np.testing.assert_array_equal(scan.points[:, column], expected)
        assert scan.points.dtype == np.float32 and scan.points.flags.c_contiguous
        groundgrid.GroundGrid(sensor_height_m=1.0).process(scan.points)


def test_a_lone_mcap_file_will_do(tmp_path):
    folder = write(tmp_path / "drive", [("/points", cloud(STORE, "plain", 0), 0)], "MCAP")
    (file,) = folder.glob("*.mcap")
    moved = file.rename(tmp_path / "alone.mcap")
    assert len(list(groundgrid.datasets.open(moved))) == 1


def vector(x, y, z):
    return STORE.types["geometry_msgs/msg/Vector3"](x, y, z)


def turn(degrees):
    half = np.radians(degrees) / 2
    return STORE.types["geometry_msgs/msg/Quaternion"](0.0, 0.0, np.sin(half), np.cos(half))


def tf(time_s, parent, child, place, degrees=0.0):
    types = STORE.types
    transform = types["geometry_msgs/msg/Transform"](vector(*place), turn(degrees))
    stamped = types["geometry_msgs/msg/TransformStamped"](
        header(STORE, time_s, parent), child, transform
    )
    return types["tf2_msgs/msg/TFMessage"]([stamped])


def odometry(time_s, x, child="base", parent="odom", w=1.0):
    types = STORE.types
    point = types["geometry_msgs/msg/Point"](x, 0.0, 0.0)
    quaternion = types["geometry_msgs/msg/Quaternion"](0.0, 0.0, 0.0, w)
    pose = types["geometry_msgs/msg/PoseWithCovariance"](
        types["geometry_msgs/msg/Pose"](point, quaternion), np.zeros(36)
    )
    twist = types["geometry_msgs/msg/TwistWithCovariance"](
        types["geometry_msgs/msg/Twist"](vector(0.0, 0.0, 0.0), vector(0.0, 0.0, 0.0)), np.zeros(36)
    )
    return types["nav_msgs/msg/Odometry"](header(STORE, time_s, parent), child, pose, twist)


@pytest.fixture
def moving(tmp_path):
    """Base turns to the left by 90 degrees and moves 4 m in a second; odometry has 8 m."""
    return write(
        tmp_path / "moving",
        [
            ("/tf_static", tf(0, "base", "lidar", (1.0, 0.0, 2.0)), 0.0),
            ("/tf", tf(10.0, "map", "base", (0.0, 0.0, 0.0)), 0.1),
            ("/odom", odometry(10.0, 0.0), 0.1),
            ("/points", cloud(STORE, "plain", 0, 10.5), 0.2),
            ("/tf", tf(11.0, "map", "base", (4.0, 0.0, 0.0), 90.0), 0.3),
            ("/odom", odometry(11.0, 8.0), 0.3),
            ("/points", cloud(STORE, "plain", 1, 11.05), 0.4),
            ("/points", cloud(STORE, "plain", 2, 12.0), 0.5),
        ],
        "MCAP",
    )


def test_poses_come_from_tf_between_its_times(moving):
    first, second, third = BagDataset(moving)
    root = np.sqrt(0.5)
    expected = [[root, -root, 0, 2 + root], [root, root, 0, root], [0, 0, 1, 2], [0, 0, 0, 1]]
    np.testing.assert_allclose(first.pose, expected, atol=1e-9)
    np.testing.assert_allclose(second.pose[:3, 3], [4, 1, 2], atol=1e-9)
    assert third.pose is None  # a second after the last transform
    assert first.time_s == 10.5


def test_poses_may_be_in_any_frame_above(moving):
    np.testing.assert_allclose(next(iter(BagDataset(moving, frame="base"))).pose[:3, 3], [1, 0, 2])
    assert next(iter(BagDataset(moving, frame="/map"))).pose is not None
    words = "moving: expected a frame above 'lidar', got 'moon'; there are 'base', 'lidar', 'map'"
    with pytest.raises(ValueError, match=words):
        BagDataset(moving, frame="moon")


def test_poses_come_from_odometry_where_it_is_named(moving):
    first = next(iter(BagDataset(moving, odometry="/odom")))
    np.testing.assert_allclose(first.pose[:3, 3], [5, 0, 2], atol=1e-9)
    with pytest.raises(ValueError, match="expected odometry on /wheels, got none"):
        BagDataset(moving, odometry="/wheels")


def test_poses_come_from_odometry_where_there_is_no_tf(tmp_path):
    messages = [
        ("/odom", odometry(1.0, 3.0, child="lidar"), 0.0),
        ("/points", cloud(STORE, "plain", 0, 1.0), 0.1),
    ]
    (scan,) = BagDataset(write(tmp_path / "drive", messages, "SQLITE3"))
    np.testing.assert_allclose(scan.pose[:3, 3], [3, 0, 0])


def places(path, **options):
    return [None if each.pose is None else list(each.pose[:3, 3])
            for each in BagDataset(path, **options)]


def reasons(path, **options):
    return [scan.pose_missing for scan in BagDataset(path, **options)]


def test_scans_outside_of_the_times_of_tf_say_so(moving):
    words = "its time is behind the poses of 'base' in 'map', which are from 10.000 to 11.000 s"
    assert reasons(moving) == [None, None, words]


@pytest.mark.parametrize(
    ("frame", "others", "words"),
    [
        ("lidar", [tf(1.0, "odom", "base", (0.0, 0.0, 0.0))],
         "neither TF nor odometry says where the cloud's frame 'lidar' is in any other; there are "
         "'base', 'odom'; record the transform to it, too (/tf_static)"),
        ("lidar", [odometry(1.0, 0.0)], "says where the cloud's frame 'lidar' is in any other"),
        ("", [odometry(1.0, 0.0)], "frame '' (its header names none) is in any other"),
        ("lidar", [tf(1.0, "lidar", "base", (0.0, 0.0, 0.0)),
                   tf(1.0, "base", "lidar", (0.0, 0.0, 0.0))], "form a ring: lidar, base"),
        ("lidar", [tf(7.0, "odom", "lidar", (0.0, 0.0, 0.0))], "before the poses of 'lidar'"),
    ],
)
def test_a_pose_that_is_missing_has_a_reason(tmp_path, frame, others, words):
    topics = ["/odom" if each.__msgtype__.endswith("Odometry") else "/tf" for each in others]
    messages = [(topic, each, 1.0) for topic, each in zip(topics, others)]
    messages.append(("/points", cloud(STORE, "plain", 0, 1.0, frame), 1.0))
    path = write(tmp_path / "drive", messages, "MCAP")
    assert places(path) == [None]
    assert words in reasons(path)[0]


def test_fixed_transforms_alone_are_no_way_of_the_sensor(tmp_path):
    messages = [("/tf_static", tf(0, "base", "lidar", (1.0, 0.0, 2.0)), 0.0),
                ("/points", cloud(STORE, "plain", 0, 1.0), 1.0)]
    path = write(tmp_path / "drive", messages, "MCAP")
    assert reasons(path) == ["'lidar' is fixed in 'base', and nothing says how 'base' moves; there "
                             "are 'base', 'lidar'"]


def test_headers_without_a_time_have_no_pose(tmp_path):
    messages = [("/tf", tf(time_s, "map", "lidar", (2.0, 0.0, 0.0)), time_s)
                for time_s in (0.0, 1.0)]
    messages += [("/points", cloud(STORE, "plain", number, 0.0), number) for number in range(2)]
    path = write(tmp_path / "drive", messages, "MCAP")
    # Simulated time begins with 0.
    assert places(path) == [[2, 0, 0], None]
    assert reasons(path)[0] is None and "its header has the time 0" in reasons(path)[1]


def test_recordings_without_any_pose_have_no_reason(tmp_path):
    path = write(tmp_path / "drive", [("/points", cloud(STORE, "plain", 0), 0)], "MCAP")
    assert places(path) == [None] and reasons(path) == [None]


def test_poses_from_a_file_stand_for_those_of_the_recording(moving, tmp_path):
    (tmp_path / "poses.txt").write_text("10 0 0 0 0 0 0 1\n12 20 0 0 0 0 0 1\n")
    found = places(moving, poses=tmp_path / "poses.txt")
    np.testing.assert_allclose(found, [[5, 0, 0], [10.5, 0, 0], [20, 0, 0]])
    assert reasons(moving, poses=tmp_path / "poses.txt") == [None] * 3
    with pytest.raises(ValueError, match="poses: expected without frame and odometry"):
        BagDataset(moving, poses=tmp_path / "poses.txt", odometry="/odom")


def test_two_odometries_of_one_frame_are_not_mixed(tmp_path):
    points = ("/points", cloud(STORE, "plain", 0, 1.0), 1.0)
    wheel = ("/wheel", odometry(1.0, 3.0, "lidar"), 1.0)
    for parent in ("map", "odom"):
        gps = ("/gps", odometry(1.05, 5e5, "lidar", parent), 1.0)
        path = write(tmp_path / parent, [wheel, gps, points], "MCAP")
        words = "frame 'lidar': expected one topic of odometry, got /gps, /wheel; choose one with"
        with pytest.raises(ValueError, match=f"{parent}: {words} odometry="):
            BagDataset(path)
        assert places(path, odometry="/wheel") == [[3, 0, 0]]
        assert places(path, odometry="/gps") == [[5e5, 0, 0]]
    camera = [(topic, odometry(1.0, 9.0, "camera", topic), 1.0) for topic in ("/left", "/right")]
    path = write(tmp_path / "others", [wheel, *camera, points], "MCAP")
    assert places(path) == [[3, 0, 0]]


def test_two_parents_of_one_frame_are_not_mixed(tmp_path):
    def edge(parent, child="lidar"):
        return ("/tf", tf(1.0, parent, child, (2.0, 0.0, 0.0)), 1.0)

    points = ("/points", cloud(STORE, "plain", 0, 1.0), 1.0)
    wheel = ("/wheel", odometry(1.0, 3.0, "lidar"), 1.0)
    again = [edge("map"), edge("map"), edge("left", "tag"), edge("right", "tag"), wheel, points]
    assert places(write(tmp_path / "again", again, "MCAP")) == [[2, 0, 0]]
    path = write(tmp_path / "two", [edge("map"), edge("odom"), wheel, points], "MCAP")
    with pytest.raises(ValueError, match="two: frame 'lidar': expected one parent, got 'map' and "
                                         "'odom' on /tf; .* odometry="):
        BagDataset(path)
    assert places(path, odometry="/wheel") == [[3, 0, 0]]


def test_odometry_that_leads_to_no_pose_is_refused(tmp_path):
    points = ("/points", cloud(STORE, "plain", 0, 1.0), 1.0)
    path = write(tmp_path / "drive", [("/odom", odometry(1.0, 3.0, ""), 1.0), points], "MCAP")
    assert places(path) == [None]
    with pytest.raises(ValueError, match="drive: expected odometry of 'lidar' or a frame above it, "
                                         "got '' on /odom; there are '', 'odom'"):
        BagDataset(path, odometry="/odom")


def test_odometry_is_read_once_however_many_transforms_there_are(tmp_path, monkeypatch):
    messages = [("/tf", tf(1.0 + n, "map", "lidar", (0.0, 0.0, 0.0)), 1.0 + n) for n in range(20)]
    messages += [("/odom", odometry(1.0, 3.0, "lidar"), 1.0),
                 ("/points", cloud(STORE, "plain", 0, 1.0), 1.0)]
    path = write(tmp_path / "drive", messages, "MCAP")
    calls, read = [], AnyReader.messages
    monkeypatch.setattr(AnyReader, "messages",
                        lambda *given, **more: calls.append(1) or read(*given, **more))
    BagDataset(path, odometry="/odom")
    assert len(calls) <= 3


@pytest.mark.parametrize(
    ("topic", "message", "words"),
    [
        ("/tf", tf(1.0, "map", "lidar", (np.nan, 0.0, 0.0)), "finite translation, got nan, 0.0"),
        ("/tf_static", tf(1.0, "map", "lidar", (np.inf, 0.0, 0.0)), "finite translation, got inf"),
        ("/odom", odometry(1.0, np.nan, "lidar"), "finite translation, got nan"),
        ("/odom", odometry(1.0, 0.0, "lidar", w=0.0), "length 1, got one of length 0.0"),
        ("/odom", odometry(1.0, 0.0, "lidar", w=np.nan), "length 1, got one of length nan"),
    ],
)
def test_poses_that_are_no_numbers_are_refused(tmp_path, topic, message, words):
    points = ("/points", cloud(STORE, "plain", 0, 1.0), 1.0)
    path = write(tmp_path / "drive", [(topic, message, 1.0), points], "MCAP")
    with pytest.raises(ValueError, match=f"drive: frame 'lidar': expected .*{words}.* on {topic};"):
        BagDataset(path)


def test_one_of_several_topics_is_to_be_named(tmp_path):
    messages = [(topic, cloud(STORE, "plain", 0), 0) for topic in ("/front", "/rear")]
    path = write(tmp_path / "drive", messages, "MCAP")
    with pytest.raises(ValueError, match="expected one topic of clouds, got /front, /rear; choose"):
        BagDataset(path)
    there = r"clouds on /top, got a recording of /front \(sensor_msgs/msg/PointCloud2\), /rear"
    with pytest.raises(ValueError, match=there):
        BagDataset(path, topic="/top")
    assert len(list(BagDataset(path, topic="/rear"))) == 1


def test_a_recording_without_clouds_says_what_is_in_it_and_what_clouds_are(tmp_path):
    path = write(tmp_path / "drive", [("/odom", odometry(1.0, 3.0), 1.0)], "MCAP")
    words = (r"drive: expected a topic of clouds, got a recording of /odom \(nav_msgs/msg/"
             r"Odometry\); clouds are sensor_msgs/msg/PointCloud2, livox_ros_driver/msg/CustomMsg, ")
    with pytest.raises(ValueError, match=words):
        BagDataset(path)


def livox(store, package, scan, time_s=0.0):
    point, kind = (store.types[f"{package}/msg/{name}"] for name in ("CustomPoint", "CustomMsg"))
    points = [point(1000 * k, 1.5 + k, 20.25 + scan, -3.0, 60 + k, 16, k % 4) for k in range(6)]
    return kind(header(store, time_s, "lidar"), int(time_s * 1e9), len(points), 0,
                np.zeros(3, np.uint8), points)


@pytest.mark.parametrize("storage", ["ros1", "SQLITE3", "MCAP"])
@pytest.mark.parametrize("package", ["livox_ros_driver", "livox_ros_driver2", "livox_interfaces"])
def test_livox_messages_are_clouds_with_times(tmp_path, package, storage):
    store = store_of(storage)
    messages = [("/livox/lidar", livox(store, package, scan, scan), scan) for scan in range(2)]
    dataset = groundgrid.datasets.open(write(tmp_path / "drive", messages, storage))
    assert dataset.topic == "/livox/lidar" and len(dataset) == 2
    for number, scan in enumerate(dataset):
        expected = [[1.5 + k, 20.25 + number, -3.0, 60 + k] for k in range(6)]
        np.testing.assert_array_equal(scan.points, expected)
        assert scan.fields["t"].tolist() == [0, 1000, 2000, 3000, 4000, 5000]
        assert scan.fields["tag"].tolist() == [16] * 6
        assert scan.fields["line"].tolist() == [0, 1, 2, 3, 0, 1] and scan.time_s == number


def test_livox_messages_that_count_other_points_are_refused(tmp_path):
    message = livox(STORE, "livox_ros_driver2", 0)
    object.__setattr__(message, "point_num", 7)
    path = write(tmp_path / "drive", [("/livox/lidar", message, 0)], "MCAP")
    with pytest.raises(ValueError, match="message 0 of /livox/lidar: .* it counts, 7, got 6"):
        list(BagDataset(path))


def test_other_files_are_refused(tmp_path):
    with pytest.raises(FileNotFoundError, match="nothing.bag"):
        BagDataset(tmp_path / "nothing.bag")
    for name in ("drive.bag", "drive.mcap", "drive.db3"):
        (tmp_path / name).write_bytes(b"no recording")
        with pytest.raises(ValueError, match=name):
            BagDataset(tmp_path / name)


@pytest.mark.parametrize("storage", ["ros1", "SQLITE3", "MCAP"])
def test_damaged_recordings_are_refused_by_name(tmp_path, storage):
    messages = [("/points", cloud(store_of(storage), "plain", scan), scan) for scan in range(2)]
    path = write(tmp_path / "drive", messages, storage)
    if path.is_dir():
        (path,) = (each for each in path.iterdir() if each.suffix in (".mcap", ".db3"))
    whole, refused = path.read_bytes(), 0
    for begin in range(0, len(whole), len(whole) // 25):
        for damaged in (whole[:begin], whole[:begin] + b"\xff" * 8 + whole[begin + 8 :]):
            alone = tmp_path / f"{begin}{path.suffix}"
            alone.write_bytes(damaged)
            try:
                list(BagDataset(alone))
            except ValueError as error:
                assert str(error).startswith(f"{alone}: ") and "\n" not in str(error)
                refused += 1
    assert refused >= 25


def test_errors_of_those_who_read_stay_their_own(moving):
    with pytest.raises(KeyError), BagDataset(moving).reader():
        raise KeyError("mine")


def test_endings_in_capitals_are_told_to_be_renamed(tmp_path):
    path = write(tmp_path / "drive", [("/points", cloud(STORE1, "plain", 0), 0)], "ros1")
    moved = path.rename(tmp_path / "DRIVE.BAG")
    with pytest.raises(ValueError, match="DRIVE.BAG: expected the ending .bag, .* rename the file"):
        groundgrid.datasets.open(moved)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"data": np.zeros(50, np.uint8)}, r"cut short: 1 x 6 points of 16 bytes \(height, width, "
         r"point_step\) take 96 bytes, and it has 50"),
        ({"point_step": 14}, "field 'intensity' reaches beyond a point of 14 bytes"),
        ({"height": 2, "width": 2, "row_step": 16}, "rows begin is not clear: 2 rows of 2 points "
         "take 64 bytes, the cloud has 96 bytes, and its row_step of 16 goes with neither"),
        ({"height": 2, "width": 2, "row_step": 0}, "row_step of 0 goes with neither"),
        ({"height": 2, "width": 2, "row_step": 96}, "row_step of 96 goes with neither"),
        ({"width": 2**31}, "take 34359738368 bytes"),
        ({"height": 2**16, "width": 2**16}, "take 68719476736 bytes"),
        ({"fields": []}, "got none named x, y, z"),
    ],
)
def test_messages_that_contradict_themselves_are_refused(tmp_path, change, words):
    message = cloud(STORE, "plain", 0)
    for name, value in change.items():
        object.__setattr__(message, name, value)
    path = write(tmp_path / "drive", [("/points", message, 0)], "MCAP")
    with pytest.raises(ValueError, match=f"message 0 of /points: .*{words}"):
        list(BagDataset(path))


@pytest.mark.parametrize("row_step", [0, 7, 48, 96, 2**31])
def test_clouds_without_padding_need_no_row_step(tmp_path, row_step):
    message = cloud(STORE, "plain", 0)
    for name, value in {"height": 2, "width": 3, "row_step": row_step}.items():
        object.__setattr__(message, name, value)
    (scan,) = BagDataset(write(tmp_path / "drive", [("/points", message, 0)], "MCAP"))
    for column, name in enumerate(("x", "y", "z", "intensity")):
        np.testing.assert_array_equal(scan.points[:, column], values(name, 0))


def test_empty_clouds_are_scans_of_no_points(tmp_path):
    message = cloud(STORE, "plain", 0)
    object.__setattr__(message, "width", 0)
    object.__setattr__(message, "data", np.zeros(0, np.uint8))
    (scan,) = BagDataset(write(tmp_path / "drive", [("/points", message, 0)], "MCAP"))
    assert scan.points.shape == (0, 4)
