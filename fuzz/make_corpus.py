#!/usr/bin/env python3
"""Writes the fuzzers' first inputs into fuzz/corpus, always the same ones."""

import json
import pathlib
import struct
import zlib

CORPUS = pathlib.Path(__file__).parent / "corpus"


def write(parser, name, content):
    folder = CORPUS / parser
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())


def crc32c(content):
    remainder = 0xFFFFFFFF
    for byte in content:
        remainder ^= byte
        for _ in range(8):
            remainder = (remainder >> 1) ^ (0x82F63B78 if remainder & 1 else 0)
    return remainder ^ 0xFFFFFFFF


def padded(content):
    return content + bytes(-len(content) % 8)


def entry(kind, name, shape, content):
    head = struct.pack("<HHI", kind, len(shape), len(name))
    return head + padded(name) + struct.pack(f"<{len(shape)}Q", *shape) + padded(content)


def archive(kind, entries):
    body = padded(kind) + b"".join(entries)
    magic = b"\x8fSOMATO\r\n\x1a\n\0"
    head = struct.pack("<IQII", 1, 32 + len(body) + 4, len(entries), len(kind))
    whole = magic + head + body
    return whole + struct.pack("<I", crc32c(whole))


def archives():
    text = entry(1, b"settings", [9], b"rows = 2\n")
    floats = entry(2, b"weights", [2, 3], struct.pack("<6f", *range(6)))
    doubles = entry(3, b"norms", [1, 1, 2], struct.pack("<2d", 0.5, -1.0))
    integers = entry(4, b"counts", [3], struct.pack("<3q", -1, 0, 2**62))
    write("archive", "empty", archive(b"som", []))
    write("archive", "one_text", archive(b"som", [text]))
    write("archive", "every_type", archive(b"tmpsom", [text, floats, doubles, integers]))
    write("archive", "twice", archive(b"som", [floats, floats]))
    write("archive", "overflow", archive(b"som", [entry(2, b"a", [2**32, 2**32], b"1234")]))
    write("archive", "past_the_end", archive(b"som", [entry(2, b"a", [3], b"1234")]))
    write("archive", "unknown_type", archive(b"som", [entry(9, b"a", [1], b"1234")]))
    write("archive", "name_no_text", archive(b"som", [entry(1, b"\xc3\x28", [1], b"x")]))
    write("archive", "text_no_text", archive(b"som", [entry(1, b"a", [1], b"\xff")]))


def npy(header, content, version=1):
    length = "<H" if version == 1 else "<I"
    before = 8 + struct.calcsize(length)
    text = header.encode() + b" " * (-(before + len(header) + 1) % 64) + b"\n"
    return b"\x93NUMPY" + bytes([version, 0]) + struct.pack(length, len(text)) + text + content


def header(kind, shape, fortran_order=False):
    return f"{{'descr': '{kind}', 'fortran_order': {fortran_order}, 'shape': {shape}, }}"


def npys():
    six = struct.pack("<6f", *range(6))
    write("npy", "two_by_three", npy(header("<f4", "(2, 3)"), six))
    write("npy", "fortran", npy(header("<f4", "(2, 3)", True), six))
    write("npy", "version_2", npy(header("<f4", "(6,)"), six, 2))
    write("npy", "version_3", npy(header("<f4", "(6,)"), six, 3))
    write("npy", "big_doubles", npy(header(">f8", "(2,)"), struct.pack(">2d", 0.5, 1e300)))
    write("npy", "booleans", npy(header("|b1", "(3,)"), b"\1\0\1"))
    write("npy", "bytes", npy(header("|i1", "(3,)"), b"\x80\x00\x7f"))
    write("npy", "long", npy(header("<u8", "(1L,)"), b"\xff" * 8))
    write("npy", "scalar", npy(header("<f4", "()"), six[:4]))
    write("npy", "absurd", npy(header("<f4", "(4294967296, 4294967296)"), six))
    write("npy", "structured", npy(header("", "(1,)").replace("''", "[('a', '<f4')]"), six[:4]))


def csvs():
    write("csv", "plain", "1,2\n3,4\n")
    write("csv", "header", "a,b,kind\n1,2,cup\n3,4,ball\n")
    write("csv", "label_first", "kind;x\ncup;1.5\nball;-2e3\n")
    write("csv", "blanks", "  1   2\n3 4\n")
    write("csv", "tabs", "a\tb\r\n1\t2\r\n")
    write("csv", "quoted", '"a ""b""","c, d"\n1,"2"\n"3" , 4\n')
    write("csv", "two_lines", '"two\nlines",1\n"x",2\n')
    write("csv", "comments", "\ufeff# numbers\n\n1,2\n# more\n3,4")
    write("csv", "ragged", "1,2\n3\n")
    write("csv", "missing", "a,b\n1,nan\n2,\n3,NA\n")
    write("csv", "extremes", "1e39,1e-60,-0,+1,.5,5.,1e999,1e-999\n")
    write("csv", "open_quote", '1,2\n"3,4\n')


def tomls():
    write("toml", "values", "a = true\nb = -15\nc = 0.5\nd = 'x'\ne = [1, 2.5]\nf = [[1], []]\n")
    write("toml", "tables", "[a.b]\nc = 1\n[[d]]\ne = 'x'\n[[d]]\ne = 'y'\n[d.f]\ng = 2\n")
    write("toml", "inline", "a = { b = 1, c = { d = [ 'x', \"y\\u00e9\" ] } }\nh.i.j = 3\n")
    write("toml", "strings", "a = '''\n'x\n'''''\nb = \"\"\"\n\\\"\"\"x\\\n  y\"\"\"\"\n'c d'.e = ''\n")
    write("toml", "extremes", "a = inf\nb = -nan\nc = 0xFFFF\nd = 1e-400\ne = -9223372036854775808\n")
    write("toml", "dates", "a = 2020-01-01T00:00:00Z\n")
    write("toml", "mixed", "a = [1, 'x', { b = 2 }]\n")
    write("toml", "deep", "a = " + "[" * 40 + "]" * 40 + "\n")
    write("toml", "long_key", ".".join("a" * 40) + " = 1\n")
    write("toml", "letters", 'a.\u00e4 = 1\nb = """\\\n \u0499"""\n')
    write("toml", "letter_in_date", "a = 2020-01-01T00:00:00\u00e4Z\n")
    write("toml", "letter_in_number", 'a = 1."\u00e4"\n')
    write("toml", "not_assigned", 'a = "\\U000C00E4\U000C00E4"\n')
    write("toml", "no_name", "[=]\n")
    write("toml", "wrong", "a = \n[b\n")


def mcap_text(text):
    return struct.pack("<I", len(text)) + text


def mcap_record(opcode, content):
    return struct.pack("<BQ", opcode, len(content)) + content


def mcap_channel(number, schema, topic, encoding, metadata=b""):
    fields = struct.pack("<HH", number, schema) + mcap_text(topic) + mcap_text(encoding)
    return mcap_record(4, fields + mcap_text(metadata))


def mcap_message(channel, time, data):
    return mcap_record(5, struct.pack("<HIQQ", channel, 0, time, time) + data)


def mcap_chunk(records, compression=b"", packed=None):
    packed = records if packed is None else packed
    head = struct.pack("<QQQI", 0, 9, len(records), zlib.crc32(records)) + mcap_text(compression)
    return mcap_record(6, head + struct.pack("<Q", len(packed)) + packed)


def mcap(profile, data):
    magic = b"\x89MCAP0\r\n"
    before = magic + mcap_record(1, mcap_text(profile) + mcap_text(b"")) + data
    return before + mcap_record(15, bytes(4)) + mcap_record(2, bytes(20)) + magic


def schema(number, name):
    fields = struct.pack("<H", number) + mcap_text(name) + mcap_text(b"ros2msg") + mcap_text(b"x")
    return mcap_record(3, fields)


def recordings():
    cdr = b"\0\1\0\0"
    floats = cdr + struct.pack("<IIII2f", 0, 0, 2, 0, 0.5, float("nan"))[:8] + struct.pack(
        "<I2f", 2, 0.5, float("nan"))
    joints = cdr + struct.pack("<iII", 1, 2, 1) + bytes(4) + struct.pack("<I", 1) + struct.pack(
        "<I", 2) + b"a\0\0\0" + struct.pack("<I", 1) + bytes(4) + struct.pack("<dII", 1.5, 0, 0)
    announced = (schema(1, b"somato.Exploration") + schema(2, b"std_msgs/msg/Float32MultiArray") +
                 schema(3, b"sensor_msgs/msg/JointState") +
                 mcap_channel(1, 1, b"/exploration", b"json") +
                 mcap_channel(2, 2, b"/touch", b"cdr", mcap_text(b"shape") + mcap_text(b"[1,2]")) +
                 mcap_channel(3, 3, b"/joints", b"cdr", mcap_text(b"unit") + mcap_text(b"deg")))
    begin = (b'{"event":"begin","index":0,"labels":[{"name":"object","value":"cup"}],"source":"",'
             b'"channels":["touch","joints"],"zero":"0"}')
    frames = mcap_message(2, 5, floats) + mcap_message(3, 6, joints)
    own = (announced + mcap_message(1, 0, begin) + frames +
           mcap_message(1, 9, b'{"event":"end","index":0}'))
    stored = struct.pack("<I", len(own) | 0x80000000) + own + bytes(4)
    write("recording", "own", mcap(b"somato", mcap_chunk(own)))
    write("recording", "lz4", mcap(b"somato", mcap_chunk(own, b"lz4", b"\x04\x22\x4d\x18\x60\x70\x73" + stored)))
    write("recording", "cut", mcap(b"somato", mcap_chunk(own))[:-150])
    write("recording", "gap", mcap(b"somato", mcap_chunk(own[:-40], b"zstd") + mcap_chunk(own)))
    write("recording", "foreign", mcap(b"ros2", announced + frames + frames))
    write("recording", "skipped", mcap(b"", mcap_record(9, b"x" * 40) + mcap_record(0x90, b"")))


def of_protocol(values, runs):
    return {"protocol": "train_is_test", "label": "object", "samples": 2,
            "metrics": {"accuracy": {"mean": 1, "sd": None, "values": values}}, "runs": runs}


def results():
    run = {"seed": 1, "winners": [0, 3], "labels": ["a", "</script>"], "predictions": ["a", "b"],
           "other_predictions": {"shape": ["x", "\u2028"]}}
    text = """[study]
name = "s"
only = ["a"]
[module.in]
type = "channel"
channel = "touch"
shape = [2, 3]
[module.last]
type = "last"
input = "in"
[module.map]
type = "som"
input = "last"
rows = 2
columns = 2
radius_start = 2.0
iterations = 10
"""
    parameters = {"study": {"name": '"s"'}, "module.map": {"type": '"som"', "rows": "2", "radius_start": "2.0"}}
    part = {"question": "", "system": "s", "variation": "", "study": text, "parameters": parameters,
            "model": {"path": "system.somato", "hash": "fnv1a64:0", "seed": 1}, "recordings": [0],
            "test_recordings": [1], "pairs": [[0, 1]], "protocols": [of_protocol([0.5], [run])]}
    more = [{**part, "variation": str(i), "model": None,
             "parameters": {**parameters, "explore": {"noise": f"{i}.0"}}} for i in range(3)]
    claim = {"text": "t", "paper": "p", "question": "", "system": "s", "variation": "",
             "metric": "accuracy", "protocol": "train_is_test", "group": "", "published": None,
             "at_least": 1, "at_most": None, "share": 0, "mean": 0.5, "sd": 0, "by_chance": None,
             "chance_share": None, "values": [0.5], "verdict": "cannot be decided here",
             "reason": "1 pair; 20 are needed"}
    recording = {"name": "r", "source": "given", "seed": 0, "hash": "h", "explorations": 2}
    study = {"version": 4, "recordings": [recording, {**recording, "name": "t"}], "parts": [part], "claims": [],
             "not_applicable": []}
    write("results", "study", json.dumps(study))
    write("results", "reproduction", json.dumps({**study, "parts": [part, *more], "claims": [claim]}))
    write("results", "cut", json.dumps(study)[:200])
    write("results", "far_winner", json.dumps(study).replace("[0, 3]", "[0, 4]"))
    write("results", "loop", json.dumps(study).replace('input = \\"in\\"', 'input = \\"map\\"'))
    write("results", "without_shape", json.dumps(study).replace("shape = [2, 3]", ""))
    write("results", "other_keys", json.dumps(study).replace("module.map", "module.map]\\n[x"))
    write("results", "nan", json.dumps(study).replace("0.5", "NaN"))
    write("results", "older", '{"version":3,"study":"s","systems":[]}')
    write("results", "deep", '{"version":4,"parts":' + "[" * 500 + "]" * 500 + "}")


def view_requests():
    head = "Host: localhost:1\r\nOrigin: http://localhost:1\r\nContent-Type: application/json\r\n"
    write("view_request", "neuron",
          "GET /api/neuron?map=m%20a&neuron=3&token=00 HTTP/1.1\r\nHost: 127.0.0.1:1\r\nX-Somato-Token: a\r\n\r\n")
    write("view_request", "command", f"POST /api/command HTTP/1.1\r\n{head}Content-Length: 18\r\n\r\n")
    write("view_request", "short", "GET / HTTP/1.0\r\n\r\n")
    write("view_request", "refused",
          "GET /%zz HTTP/1.1\r\nHost: a\r\nHost: b\r\nTransfer-Encoding: chunked\r\n\r\n")
    write("view_request", "seek", '{"command":"seek","exploration":1,"frame":2}')
    write("view_request", "placement", '{"command":"placement","x":1,"y":-2.5,"turn":90}')
    write("view_request", "speed", '{"command":"speed","speed":1e309}')


def stuffed(body):
    """The body without zeros: blocks after their lengths plus 1."""
    blocks = body.split(b"\0")
    return b"\0" + b"".join(bytes([len(block) + 1]) + block for block in blocks) + b"\0"


def sensor_frame(kind, sequence, values):
    body = struct.pack(f"<BHI3{kind}", 1 if kind == "h" else 2, sequence, 20000, *values)
    return stuffed(body + struct.pack("<I", zlib.crc32(body)))


def wire_decoders():
    frames = sensor_frame("h", 0, (1, 0, -32768)) + sensor_frame("f", 1, (0.5, -1e30, 0))
    write("wire_decoders", "sensor_frames", b"\0" + frames)
    write("wire_decoders", "not_finite", b"\0" + sensor_frame("f", 1, (0.5, float("inf"), 0)))
    write("wire_decoders", "cut_frame", b"\0" + frames[:9] + frames)
    skin = struct.pack("<4f", 24.5, 100, -2.5, 0) + b"\r\n"
    write("wire_decoders", "anyskin", b"\1" + 3 * skin + skin[1:] + skin)
    overlapping = b"A\r\n" + 13 * b"A" + b"\r\n"
    write("wire_decoders", "anyskin_overlap", b"\1\r\n" + 3 * overlapping)
    lines = b"\n1,2,3\r\n -1e-3,\t.5 ,1e38\n\n1,2\n1,nan,2\n0,0,0\n"
    write("wire_decoders", "number_lines", b"\2" + lines)
    write("wire_decoders", "version", b"\3SSC32-V2.50\rQ\xff")
    commands = b"GOBOOT", b"R4=1", b"#1P1500S5#2P600T20", b"VA VB", b"#1P0 PO-5"
    for index, line in enumerate(commands):
        write("wire_decoders", f"line_{index}", b"\4" + line)
    moves = b"#0P1500#1 p900\r#0P9999S1T40\rQ\rQP 0\r#0PO100\r\x1bVER\r#1L\rSTOP0\r"
    write("wire_decoders", "board", b"\5" + moves)


SKIN = """std_msgs/Header header
Sensor[<=3] sensors
uint8 KIND=3
wstring note
float64[2] place 0.5
===
MSG: a/Sensor
string<=9 model
Taxel[] taxels
Nothing[2] nothing
===
MSG: a/Taxel
int16 x
uint64 y
bool z
===
MSG: a/Nothing
# no fields
===
MSG: std_msgs/Header
time stamp
string frame_id
"""


def ros_definitions():
    write("ros_definition", "skin", SKIN)
    write("ros_definition", "loop", "B b\n===\nMSG: a/B\nTop[] t\n")
    write("ros_definition", "array", "B[4294967295] b\n===\nMSG: a/B\nfloat64[4294967295] x\n")
    write("ros_definition", "missing", "uint8 A=1\r\nother/Type t # there is none\r\n")
    levels = "".join(f"===\nMSG: a/T{i}\nT{i + 1} a\nT{i + 1} b\n" for i in range(1, 30))
    write("ros_definition", "levels", f"T1 a\nT1 b\n{levels}===\nMSG: a/T30\nint8 x\n")


def ros_text(value):
    return struct.pack("<I", len(value) + 1) + value + b"\0"


def ros_messages():
    """A definition and a path as in FieldReader, each followed by a zero, and a message."""
    little = b"\0\1\0\0"
    taxel = struct.pack("<h6xQ?", -2, 1 << 63, True)
    head = struct.pack("<iI", 1, 2) + ros_text(b"map")
    sensors = struct.pack("<I", 1) + ros_text(b"tip") + struct.pack("<I", 1) + taxel + bytes(2)
    skin = little + head + sensors + bytes(5) + struct.pack("<2d", 0.5, 1.5)
    definition = SKIN.encode() + b"\0"
    for name, path in ("all", b"sensors"), ("one", b"sensors[0].taxels[*].y"), ("last", b"place"):
        write("ros_message", name, definition + path + b"\0" + skin)
    write("ros_message", "cut", definition + b"sensors\0" + skin[:40])
    write("ros_message", "big_endian", b"float32[] x\0x\0\0\0\0\0\0\0\0\2" + bytes(8))
    write("ros_message", "long", b"float64[] x\0x\0" + little + b"\xff" * 4 + bytes(8))
    write("ros_message", "bytes", b"uint8[4294967295] x\nint8 y\0y\0" + little + bytes(8))
    write("ros_message", "nothing", b"N[] n\nint8 x\n===\nMSG: a/N\n\0x\0" + little + b"\3" + bytes(8))
    write("ros_message", "parameters", b"int8 x\0x\0\0\3\0\0" + bytes(8))


def proto(*fields):
    """A message in protobuf: a pair of number and value for each field, which is an integer or bytes."""
    message = b""
    for number, value in fields:
        if isinstance(value, int):
            message += bytes([number << 3, value])
        else:
            message += bytes([number << 3 | 2]) + varint(len(value)) + value
    return message


def varint(value):
    return bytes([value]) if value < 128 else bytes([value & 127 | 128]) + varint(value >> 7)


def protobuf_messages():
    """The name of a message type, its descriptors, each after its length in two bytes, and a message."""
    double, integer, text, message, binary, optional, repeated = 1, 5, 9, 11, 12, 1, 3

    def field(name, number, kind, label=optional, of=b""):
        content = proto((1, name), (3, number), (4, label), (5, kind))
        return 2, content + (proto((6, of)) if of else b"")

    entry = proto((1, b"E"), field(b"key", 1, text), field(b"value", 2, double), (7, proto((7, 1))))
    taxel = (4, proto((1, b"T"), field(b"x", 1, integer), field(b"raw", 2, binary)))
    hand = (4, proto((1, b"H"), field(b"name", 1, text, repeated), field(b"t", 2, message, repeated, b".T"),
                     field(b"tip", 3, message, optional, b".T"), field(b"m", 4, message, repeated, b".H.E"),
                     (3, entry)))
    own = (4, proto((1, b"R"), field(b"r", 1, message, optional, b".R")))
    content = proto((1, b"a"), (1, b"b"), (2, proto((1, 3), (2, b"\1\2"))),
                    (4, proto((1, b"k"), (2, struct.pack("<Q", 0)))))

    def case(name, type_name, *files, message=content):
        descriptors = proto(*((1, file) for file in files))
        head = b"".join(struct.pack("<H", len(part)) + part for part in (type_name, descriptors))
        write("protobuf_message", name, head + message)

    proto3 = (12, b"proto3")
    file = proto((1, b"f"), taxel, hand, own, proto3)
    case("all", b"H", file)
    case("proto2", b"H", proto((1, b"f"), taxel, hand))
    case("nothing", b"H", file, message=b"")
    case("cut", b"H", file, message=content[:-3])
    case("text_no_text", b"H", file, message=proto((1, b"\xff")))
    case("itself", b"R", file)
    case("unknown", b"N", file)
    case("import", b"H", proto((1, b"f"), (3, b"g"), hand, proto3), proto((1, b"g"), taxel, proto3))
    case("circle", b"H", proto((1, b"f"), (3, b"g"), hand, proto3), proto((1, b"g"), (3, b"f"), taxel))
    case("missing_import", b"H", proto((1, b"f"), (3, b"g"), hand, proto3))


archives()
npys()
csvs()
tomls()
recordings()
results()
view_requests()
wire_decoders()
ros_definitions()
ros_messages()
protobuf_messages()
