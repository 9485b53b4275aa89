"""Packets of the four kinds of servo lines: which commands they contain, and how an answer is changed.

A decoder takes the bytes of one direction and returns what is complete. Addresses and checksums are those of
src/hardware/protocols/ssc32.h, dynamixel.h and feetech.h, whose comments name the manuals.
"""

import re
from dataclasses import dataclass, field

EVERYONE = 0xFE


@dataclass
class Command:
    """What the program commanded: goals by the servo's number on the bus; the torque (None: unchanged)."""
    goals: dict = field(default_factory=dict)
    torque: bool | None = None


@dataclass
class Changes:
    """How the answers of one servo are changed; None: not at all."""
    servo: int = 0
    position: callable = None  # from the true position, in steps, and the seconds since the fault
    overload: bool = False
    temperature: int | None = None
    taken: list = field(default_factory=list)  # the moments of the answers that were changed


class Ssc32:
    """Commands end with a carriage return; an answer says nothing about a servo."""

    MOVE = re.compile(rb"#(\d+)\s*P(\d+)")

    def __init__(self):
        self.text = b""

    def commands(self, data):
        *lines, self.text = (self.text + data).split(b"\r")
        for line in lines:
            moves = {int(channel): int(pulse) for channel, pulse in self.MOVE.findall(line)}
            if moves and not any(moves.values()):
                yield Command(torque=False)
            elif moves:
                yield Command(goals=moves)

    def answers(self, data, changes, seconds):
        del changes, seconds
        return data


def feetech_sum(body):
    return ~sum(body) & 0xFF


class Feetech:
    """Packets FF FF, id, length, instruction or error, parameters, sum."""

    STATE = {"little": 15, "big": 8}  # bytes of a state

    def __init__(self, order):
        self.order = order
        self.to_servos = b""
        self.to_host = b""

    @staticmethod
    def packets(data):
        """The whole packets of the data, without head and sum, and the rest."""
        found = []
        while (start := data.find(b"\xff\xff")) >= 0:
            data = data[start:]
            if data[2:3] == b"\xff":  # no id: a byte FF before a head
                data = data[1:]
                continue
            if len(data) < 4 or len(data) < 4 + data[3]:
                return found, data
            body, rest = data[2:3 + data[3]], data[4 + data[3]:]
            if len(body) < 3 or feetech_sum(body) != data[3 + data[3]]:
                data = data[1:]
                continue
            found.append(body)
            data = rest
        return found, data[-1:] if data.endswith(b"\xff") else b""

    def command(self, body):
        instruction, parameters = body[2], body[3:]
        if instruction == 0x83 and parameters[0] == 42:
            size = 1 + parameters[1]
            each = [parameters[i:i + size] for i in range(2, len(parameters), size)]
            return Command(goals={one[0]: int.from_bytes(one[1:3], self.order) for one in each})
        if instruction == 0x03 and parameters[0] == 40:
            return Command(torque=parameters[1] != 0)
        return None

    def commands(self, data):
        found, self.to_servos = self.packets(self.to_servos + data)
        return filter(None, map(self.command, found))

    def changed(self, body, changes, seconds):
        state = bytearray(body[3:])
        if changes is None or body[0] != changes.servo or len(state) != self.STATE[self.order]:
            return body
        if changes.position:
            place = changes.position(int.from_bytes(state[:2], self.order), seconds)
            state[:2] = int(place).to_bytes(2, self.order)
        if changes.temperature is not None:
            state[7] = changes.temperature
        changes.taken.append(seconds)
        return bytes([body[0], body[1], body[2] | (0x20 if changes.overload else 0)]) + bytes(state)

    def answers(self, data, changes, seconds):
        found, self.to_host = self.packets(self.to_host + data)
        bodies = [self.changed(body, changes, seconds) for body in found]
        return b"".join(b"\xff\xff" + body + bytes([feetech_sum(body)]) for body in bodies)


def dynamixel_crc(data):
    crc = 0
    for byte in data:
        crc ^= byte << 8
        for _ in range(8):
            crc = (crc << 1 ^ 0x8005 if crc & 0x8000 else crc << 1) & 0xFFFF
    return crc


class Dynamixel:
    """Packets FF FF FD 00, id, length, instruction, parameters, CRC; FD is doubled after FF FF FD."""

    HEAD = b"\xff\xff\xfd\x00"
    STATES = (10, 21)  # bytes of a state, without and with the temperature

    def __init__(self):
        self.to_servos = b""
        self.to_host = b""

    def packets(self, data):
        """(id, instruction and parameters) of each whole packet, and the rest."""
        found = []
        while (start := data.find(self.HEAD)) >= 0:
            data = data[start:]
            if len(data) < 7:
                return found, data
            end = 7 + int.from_bytes(data[5:7], "little")
            if len(data) < end:
                return found, data
            found.append((data[4], data[7:end - 2].replace(b"\xff\xff\xfd\xfd", b"\xff\xff\xfd")))
            data = data[end:]
        return found, data[-3:]

    def packet(self, servo, body):
        body = body.replace(b"\xff\xff\xfd", b"\xff\xff\xfd\xfd")
        packet = self.HEAD + bytes([servo]) + (len(body) + 2).to_bytes(2, "little") + body
        return packet + dynamixel_crc(packet).to_bytes(2, "little")

    @staticmethod
    def command(servo, body):
        instruction, address = body[0], int.from_bytes(body[1:3], "little")
        if instruction == 0x83 and address == 112:
            each = [body[i:i + 9] for i in range(5, len(body), 9)]
            return Command(goals={one[0]: int.from_bytes(one[5:9], "little", signed=True) for one in each})
        if instruction == 0x83 and address == 64:
            return Command(torque=body[6] != 0)
        if instruction == 0x03 and address == 64:
            return Command(torque=body[3] != 0)
        return None

    def commands(self, data):
        found, self.to_servos = self.packets(self.to_servos + data)
        return filter(None, (self.command(servo, body) for servo, body in found))

    def changed(self, servo, body, changes, seconds):
        if changes is None or servo != changes.servo or body[0] != 0x55:
            return body
        error, state = body[1], bytearray(body[2:])
        if changes.overload:
            error |= 0x80
            state = bytearray([0x20]) if len(state) == 1 else state
        if changes.position and len(state) in self.STATES:
            place = changes.position(int.from_bytes(state[6:10], "little", signed=True), seconds)
            state[6:10] = int(place).to_bytes(4, "little", signed=True)
        if changes.temperature is not None and len(state) == self.STATES[1]:
            state[20] = changes.temperature
        if changes.temperature is None or len(state) == self.STATES[1]:
            changes.taken.append(seconds)
        return bytes([0x55, error]) + bytes(state)

    def answers(self, data, changes, seconds):
        found, self.to_host = self.packets(self.to_host + data)
        return b"".join(self.packet(servo, self.changed(servo, body, changes, seconds)) for servo, body in found)


def decoder_of(bus):
    return {"ssc32": Ssc32, "dynamixel": Dynamixel, "sts": lambda: Feetech("little"),
            "scs": lambda: Feetech("big")}[bus]()
