"""Our frames of magnetic skins against the libraries that read them, anyskin and reskin_sensor."""

import random
import struct
import unittest
from contextlib import redirect_stdout
from io import StringIO

import numpy as np
from anyskin import AnySkinBase
from chain import Chain
from reskin_sensor import ReSkinBase


def frame(values):
    """The bytes of one frame, as the boards of the libraries send it."""
    return struct.pack(f"<{len(values)}f", *values) + b"\r\n"


def texts(values):
    return [f"{value:.9g}" for value in values]


class Stream:
    """In place of the serial port, from which both classes are derived. They wait without a limit, and
    discard everything when more than 4000 bytes are waiting."""

    stream = b""
    requests = 0

    def flush(self):
        pass

    @property
    def in_waiting(self):
        self.requests += 1
        if self.requests > 10:
            raise EOFError("it waits for more than is sent")
        return len(self.stream)

    def reset_input_buffer(self):
        self.stream = b""

    def read(self, size=1):
        self.requests = 0
        taken, self.stream = self.stream[:size], self.stream[size:]
        return taken

    def read_until(self, end=b"\n", _size=None):
        return self.read(self.stream.find(end) + len(end))


class AnySkin(Stream, AnySkinBase):
    pass


class ReSkin(Stream, ReSkinBase):
    pass


def readers(magnetometers, stream):
    """Each library at the beginning of the stream, whose first frame they read to initialize."""
    for kind in (AnySkin, ReSkin):
        first = frame([0.0] * 4 * magnetometers)
        reader = type("Reader", (kind,), {"stream": first + stream})
        with redirect_stdout(StringIO()):
            yield reader(num_mags=magnetometers, temp_filtered=False)


class Codec(unittest.TestCase):
    """Our encoder and decoder."""

    def skin(self, magnetometers):
        skin = Chain("skin", magnetometers)
        self.addCleanup(skin.close)
        return skin

    def plausible(self, numbers, magnetometers):
        """Temperatures and fields that a magnetometer can measure, as the decoder demands."""
        return np.array([numbers.uniform(-500, 500) if i % 4 else numbers.uniform(15, 40)
                         for i in range(4 * magnetometers)], dtype=np.float32)

    def test_the_libraries_read_what_we_write(self):
        numbers = random.Random(2)
        for magnetometers in (1, 5, 15):
            skin = self.skin(magnetometers)
            sent = [self.plausible(numbers, magnetometers) for _ in range(10)]
            written = [skin.bytes("frame", *texts(values)) for values in sent]
            self.assertEqual(written, [frame(values) for values in sent])
            for reader in readers(magnetometers, b"".join(written) + b"\r"):
                for values in sent:
                    np.testing.assert_array_equal(reader.get_sample()[-1], values)

    def test_we_read_what_the_libraries_read(self):
        numbers = random.Random(3)
        for magnetometers in (1, 5, 15):
            sent = [self.plausible(numbers, magnetometers) for _ in range(10)]
            stream = b"".join(map(frame, sent))
            skin = self.skin(magnetometers)
            read = np.array(skin.ask("read", stream.hex()).split(), dtype=np.float32)
            # Nothing shows that the first frame is whole.
            np.testing.assert_array_equal(read, np.concatenate(sent[1:]))
            for reader in readers(magnetometers, stream + b"\r"):
                for values in sent:
                    np.testing.assert_array_equal(reader.get_sample()[-1], values)


class Frames(unittest.TestCase):
    """What the libraries do with a stream, on which our decoder relies."""

    def test_values(self):
        numbers = random.Random(1)
        for magnetometers in (1, 5, 15):
            sent = [np.array([numbers.uniform(-500, 500) for _ in range(4 * magnetometers)],
                             dtype=np.float32) for _ in range(10)]
            stream = b"".join(frame(values) for values in sent)
            for reader in readers(magnetometers, stream + b"\r"):  # they wait for one byte more
                for values in sent:
                    np.testing.assert_array_equal(reader.get_sample()[-1], values)

    def test_line_ends_within_values(self):
        values = np.frombuffer(b"\r\n\r\n" * 20, dtype="<f4")
        for reader in readers(5, frame(values) * 2 + b"\r"):
            np.testing.assert_array_equal(reader.get_sample()[-1], values)
            np.testing.assert_array_equal(reader.get_sample()[-1], values)

    def test_they_find_the_next_frame_after_a_lost_byte(self):
        values = np.arange(20, dtype=np.float32)
        damaged = frame(values)[1:]
        for reader in readers(5, damaged + frame(values) * 3 + b"\r"):
            np.testing.assert_array_equal(reader.get_sample()[-1], values)


if __name__ == "__main__":
    unittest.main()
