"""Prints width, height and the bytes (in hexadecimal) of an RGB PNG file, by the format's
specification and zlib only: an independent reader for png_test.cc."""

import struct
import sys
import zlib


def chunks(data):
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at = 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        assert zlib.crc32(kind + body) == struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0]
        yield kind, body
        at += 12 + length


def nearest(left, above, corner):
    """The Paeth predictor."""
    guess = left + above - corner
    return min((left, above, corner), key=lambda value: abs(guess - value))


def predicted(method, left, above, corner):
    return (0, left, above, (left + above) // 2, nearest(left, above, corner))[method]


def main():
    with open(sys.argv[1], "rb") as file:
        found = list(chunks(file.read()))
    assert found[0][0] == b"IHDR" and found[-1][0] == b"IEND"
    width, height, depth, colours, _, _, interlaced = struct.unpack(">IIBBBBB", found[0][1])
    assert (depth, colours, interlaced) == (8, 2, 0)
    raw = zlib.decompress(b"".join(body for kind, body in found if kind == b"IDAT"))
    above = bytearray(3 * width)
    pixels = bytearray()
    for row in range(height):
        line = raw[row * (3 * width + 1):(row + 1) * (3 * width + 1)]
        now = bytearray()
        for at, value in enumerate(line[1:]):
            left, corner = (now[at - 3], above[at - 3]) if at >= 3 else (0, 0)
            now.append((value + predicted(line[0], left, above[at], corner)) % 256)
        pixels += now
        above = now
    print(width, height, pixels.hex())


main()
