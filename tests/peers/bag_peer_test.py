"""Our decoding of bags against rosbags and mcap_ros2: every field of messages of many types, bit for bit, and
messages of recordings and bags of ours decoded by rosbags; arrays of ours read by numpy."""

import os
import random
import struct
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np
from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory
from rosbags.highlevel import AnyReader
from rosbags.interfaces import Nodetype
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

# Types of makers of hands and skins by their documented fields, and one with everything that a field can be.
OWN_TYPES = {
    "xela_server_ros2/msg/Taxel": "uint16 x\nuint16 y\nuint16 z",
    "xela_server_ros2/msg/Forces": "float32 x\nfloat32 y\nfloat32 z",
    "xela_server_ros2/msg/SensorFull": "uint32 message\nfloat64 time\nstring model\nuint8 sensor_pos\nTaxel[] taxels\n"
                                       "Forces[] forces",
    "xela_server_ros2/msg/SensStream": "SensorFull[] sensors",
    "tactile_msgs/msg/TactileState": "std_msgs/Header header\nsensor_msgs/ChannelFloat32[] sensors",
    "papillarray_ros_v2/msg/PillarState": "std_msgs/Header header\nint32 id\nfloat32 dX\nfloat32 dY\nfloat32 dZ\n"
                                          "float32 fX\nfloat32 fY\nfloat32 fZ\nbool in_contact\nint32 slip_state",
    "papillarray_ros_v2/msg/SensorState": "std_msgs/Header header\nint64 tus\nPillarState[] pillars\nfloat32 gfX\n"
                                          "float32 gfY\nfloat32 gfZ\nfloat32 gtX\nfloat32 gtY\nfloat32 gtZ\n"
                                          "float32 friction_est\nfloat32 target_grip_force\nbool is_sd_active\n"
                                          "bool is_ref_loaded\nbool is_contact",
    "sr_robot_msgs/msg/Biotac": "int16 pac0\nint16 pac1\nint16[] pac\nint16 pdc\nint16 tac\nint16 tdc\n"
                                "int16[] electrodes",
    "sr_robot_msgs/msg/BiotacAll": "std_msgs/Header header\nBiotac[5] tactiles",
    "sr_robot_msgs/msg/ShadowPST": "std_msgs/Header header\nint16[] pressure\nint16[] temperature",
    "sr_robot_msgs/msg/UBI0": "uint16[12] distal",
    "sr_robot_msgs/msg/UBI0All": "std_msgs/Header header\nUBI0[5] tactiles",
    "control_msgs/msg/InterfaceValue": "string[] interface_names\nfloat64[] values",
    "control_msgs/msg/DynamicJointState": "std_msgs/Header header\nstring[] joint_names\n"
                                          "InterfaceValue[] interface_values",
    "own_msgs/msg/Everything": "uint8 KIND=3\nbool a\nbyte b\nint8 c\nuint8 d\nint16 e\nuint16 f\nint32 g 5\n"
                               "uint32 h\nint64 i\nuint64 j\nfloat32 k\nfloat64 l\nstring m\nbool[] n\n"
                               "int64[3] o\nuint64[<=7] p\nstring<=9[<=4] q\nfloat32[2] r\nint8 s\nfloat64[] t\n"
                               "geometry_msgs/Point[2] u\nbuiltin_interfaces/Duration v",
}
TYPES = ["sensor_msgs/msg/JointState", "geometry_msgs/msg/WrenchStamped", "sensor_msgs/msg/Imu",
         "std_msgs/msg/Float32MultiArray", "std_msgs/msg/Float64MultiArray", "sensor_msgs/msg/MagneticField",
         "sensor_msgs/msg/FluidPressure", "geometry_msgs/msg/TwistStamped", "sensor_msgs/msg/Range",
         "xela_server_ros2/msg/SensStream", "tactile_msgs/msg/TactileState", "papillarray_ros_v2/msg/SensorState",
         "sr_robot_msgs/msg/BiotacAll", "sr_robot_msgs/msg/ShadowPST", "sr_robot_msgs/msg/UBI0All",
         "control_msgs/msg/DynamicJointState", "own_msgs/msg/Everything"]
SIZES = {"bool": 1, "byte": 1, "char": 1, "octet": 1, "float32": 4, "float64": 8}
SIZES.update({f"{sign}int{bits}": bits // 8 for sign in ("", "u") for bits in (8, 16, 32, 64)})
MESSAGES = 20


def store_of_types():
    store = get_typestore(Stores.ROS2_JAZZY)
    types = {}
    for name, text in OWN_TYPES.items():
        types.update(get_types_from_msg(text, name))
    store.register(types)
    return store


class Maker:
    """Makes messages with random values, most of them extreme."""

    def __init__(self, store):
        self.store = store
        self.random = random.Random(1)

    def scalar(self, name):
        if name == "string":
            return self.random.choice(["", "a", "touch", "\u00e4\u6307"])
        if name == "bool":
            return self.random.random() < 0.5
        if name.startswith("float"):
            return float(np.float32(self.random.choice([0.1, -0.0, 1e-40, 3e38, float("inf"), self.random.gauss(0, 1)])))
        if name in ("byte", "octet"):
            return self.random.randint(0, 127)  # rosbags takes bytes for signed.
        size = SIZES[name]
        low = -(1 << (8 * size - 1)) if name.startswith("int") else 0
        return self.random.choice([low, low + (1 << (8 * size)) - 1, self.random.randint(0, 99)])

    def value(self, field):
        kind, of = field
        if kind == Nodetype.BASE:
            return self.scalar(of[0])
        if kind == Nodetype.NAME:
            return self.message(of)
        element, length = of
        if kind == Nodetype.SEQUENCE:
            length = self.random.randint(0, min(length or 4, 4))
        values = [self.value(element) for _ in range(length)]
        is_number = element[0] == Nodetype.BASE and element[1][0] != "string"
        if not is_number:
            return values
        name = element[1][0]
        return np.array(values, dtype={"bool": np.bool_, "byte": np.uint8, "octet": np.uint8}.get(name, name))

    def message(self, name):
        fields = self.store.fielddefs[name][1]
        return self.store.types[name](**{field: self.value(kind) for field, kind in fields})


def leaves(store, name, before=""):
    """The path and primitive type of every field."""
    for field, (kind, of) in store.fielddefs[name][1]:
        path = before + field
        if kind in (Nodetype.ARRAY, Nodetype.SEQUENCE):
            path, (kind, of) = path + "[*]", of[0]
        if kind == Nodetype.NAME:
            yield from leaves(store, of, path + ".")
        else:
            yield path, of[0]


def values_at(message, path):
    """The values at a path of a message of rosbags or mcap_ros2."""
    found = [message]
    for part in path.split("."):
        found = [getattr(value, part.removesuffix("[*]")) for value in found]
        if part.endswith("[*]"):
            found = [element for values in found for element in values]
    return found


def shown(value, name):
    if name == "string":
        return "s" + value.encode().hex()
    size = SIZES[name]
    if name.startswith("float"):
        bits = struct.unpack("<I" if size == 4 else "<Q", struct.pack("<f" if size == 4 else "<d", value))[0]
    else:
        bits = int(value) & ((1 << (8 * size)) - 1)
    return f"{size}:{bits:x}"


def lines_of(store, topic, name, time, message):
    return {f"{topic} {time} {path}" + "".join(" " + shown(value, primitive) for value in values_at(message, path))
            for path, primitive in leaves(store, name)}


class Bags(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.store = store_of_types()

    def written(self, plugin, types=TYPES):
        """A bag with messages of these types."""
        maker = Maker(self.store)
        path = self.folder / plugin.name
        with Writer(path, version=9, storage_plugin=plugin) as bag:
            for name in types:
                topic = bag.add_connection("/" + name.replace("/", "_"), name, typestore=self.store)
                for i in range(MESSAGES):
                    bag.write(topic, 10**18 + i, self.store.serialize_cdr(maker.message(name), name))
        return path

    def ours(self, path):
        done = subprocess.run([os.environ["SOMATO_BAG_FIELDS"], path], capture_output=True, text=True, check=False)
        self.assertEqual(done.stderr, "")
        return set(done.stdout.splitlines())

    def test_every_field_is_that_of_rosbags(self):
        for plugin in (StoragePlugin.MCAP, StoragePlugin.SQLITE3):
            path = self.written(plugin)
            expected = set()
            with AnyReader([path]) as reader:
                for connection, time, raw in reader.messages():
                    message = reader.deserialize(raw, connection.msgtype)
                    expected |= lines_of(self.store, connection.topic, connection.msgtype, time, message)
            self.assertGreater(len(expected), 12 * MESSAGES)
            self.assertEqual(self.ours(path), expected)

    def test_every_field_is_that_of_mcap_ros2(self):
        # It refuses names with capital letters, which the maker of this sensor uses.
        path = self.written(StoragePlugin.MCAP, [name for name in TYPES if "papillarray" not in name])
        expected = set()
        with open(next(path.glob("*.mcap")), "rb") as stream:
            for schema, channel, record, message in make_reader(
                    stream, decoder_factories=[DecoderFactory()]).iter_decoded_messages():
                expected |= lines_of(self.store, channel.topic, schema.name, record.log_time, message)
        self.assertEqual(self.ours(path), expected)

    def test_rosbags_decodes_what_is_imported_from_bags(self):
        path = self.written(StoragePlugin.SQLITE3)
        recording = self.folder / "own.mcap"
        channels = "touch=/sr_robot_msgs_msg_UBI0All:tactiles[*].distal"
        subprocess.run([os.environ["SOMATO_PROGRAM"], "import", "bag", path, "-o", recording, "--channels", channels],
                       check=True, capture_output=True)
        with AnyReader([path]) as reader:
            topics = [c for c in reader.connections if c.topic == "/sr_robot_msgs_msg_UBI0All"]
            wanted = [values_at(reader.deserialize(raw, c.msgtype), "tactiles[*].distal[*]")
                      for c, _, raw in reader.messages(topics)]
        with open(recording, "rb") as stream:
            found = [list(self.store.deserialize_cdr(record.data, schema.name).data)
                     for schema, _, record in make_reader(stream).iter_messages(topics=["/touch"])]
        self.assertEqual(len(found), MESSAGES)
        self.assertEqual(found, wanted)

    def converted(self, name):
        """A recording of two explorations, and what the program converts it to."""
        source = self.folder / "source"
        source.mkdir()
        for number, label in enumerate(["Ball \u00e4", "cup"]):
            rows = "".join(f"{0.1 * frame},{frame + number},{0.1 * frame},,7\n" for frame in range(3 + number))
            (source / f"{label}.csv").write_text("t,a,b,c,d\n" + rows)
        recording, path = self.folder / "recording.mcap", self.folder / name
        for arguments in (["import", "csv", source, "-o", recording, "--files", "{object}.csv", "--time", "t",
                           "--missing", "mask", "--channels", "joints:deg=a,touch:counts=b+c+d"],
                          ["convert", recording, "-o", path]):
            subprocess.run([os.environ["SOMATO_PROGRAM"], *arguments], check=True, capture_output=True)
        return path

    def test_rosbags_reads_a_converted_bag(self):
        texts, positions, touch = [], [], []
        with AnyReader([self.converted("own_bag")]) as reader:
            for connection, time, raw in reader.messages():
                message = reader.deserialize(raw, connection.msgtype)
                if connection.msgtype == "std_msgs/msg/String":
                    texts.append((connection.topic, message.data))
                elif connection.topic == "/joints":
                    self.assertEqual(message.header.stamp.sec * 10**9 + message.header.stamp.nanosec, time)
                    self.assertEqual(message.name, ["a"])
                    positions.append(message.position[0])
                else:
                    self.assertEqual((connection.topic, [d.size for d in message.layout.dim]), ("/touch", [3]))
                    touch.append(message.data)
            self.assertEqual(reader.message_count, 6 + 7 + 7)
        event, label = "/exploration", "/labels/object"
        self.assertEqual(texts, [(label, "Ball \u00e4"), (event, "1"), (event, ""),
                                 (label, "cup"), (event, "2"), (event, "")])
        np.testing.assert_allclose(np.rad2deg(positions), [0, 1, 2, 1, 2, 3, 4], atol=1e-12)
        self.assertTrue(all(np.isnan(values[1]) and values[2] == 7 for values in touch))

    def test_numpy_reads_converted_arrays(self):
        with np.load(self.converted("own.npz")) as arrays:
            self.assertEqual(arrays["labels/object"].tolist(), ["Ball \u00e4", "cup"])
            self.assertEqual(arrays["unit/touch"].item(), "counts")
            self.assertEqual(arrays["elements/touch"].tolist(), ["b", "c", "d"])
            np.testing.assert_array_equal(arrays["rates/touch"], [0, 0])
            for index, frames in enumerate([3, 4]):
                times = [0.1 * frame for frame in range(frames)]
                np.testing.assert_allclose(arrays[f"times/touch/{index}"], times, rtol=0, atol=1e-9)
                touch = np.array([[time, np.nan, 7] for time in times], np.float32)
                np.testing.assert_array_equal(arrays[f"frames/touch/{index}"], touch)
                self.assertEqual(arrays[f"frames/joints/{index}"].dtype, np.float32)
            self.assertEqual(len(arrays.files), 2 * 2 * 2 + 1 + 2 * 3)


if __name__ == "__main__":
    unittest.main()
