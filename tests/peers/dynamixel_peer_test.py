"""Our emulated Dynamixel servos, bus and encoders against the library of the maker, dynamixel_sdk."""

import random
import unittest
from pathlib import Path

import dynamixel_easy_sdk
import dynamixel_sdk as sdk
from chain import Chain, Port

TABLES = Path(dynamixel_easy_sdk.__file__).parent / "control_table"
TORQUE, STATUS_LEVEL, ERROR, ACCELERATION, VELOCITY, GOAL, CURRENT = 64, 68, 70, 108, 112, 116, 126
SERVOS = 3


def signed(value, size):
    return value - (1 << 8 * size) if value >> (8 * size - 1) else value


def four(value):
    return list((value & 0xFFFFFFFF).to_bytes(4, "little"))


def packets(stream):
    """The packets of a stream that contains nothing else and needs no stuffing."""
    while stream:
        size = 7 + int.from_bytes(stream[5:7], "little")
        yield stream[:size]
        stream = stream[size:]


class Peer(unittest.TestCase):
    def setUp(self):
        self.chain = Chain("dynamixel", SERVOS)
        self.addCleanup(self.chain.close)
        self.port = Port(self.chain)
        self.silent = Port()
        self.handler = sdk.PacketHandler(2.0)
        self.random = random.Random(1)

    def by_library(self, send):
        """The bytes that the library sends for a request."""
        self.silent.sent.clear()
        self.silent.is_using = False
        send(self.silent)
        self.assertEqual(len(self.silent.sent), 1)
        return self.silent.sent[0]

    def sync_write(self, port, address, size, data):
        group = sdk.GroupSyncWrite(port, self.handler, address, size)
        for servo, values in data.items():
            self.assertTrue(group.addParam(servo, values))
        group.txPacket()

    def sync_read(self, port, address, size, ids):
        group = sdk.GroupSyncRead(port, self.handler, address, size)
        for servo in ids:
            self.assertTrue(group.addParam(servo))
        return group, group.txPacket()

    def repeated(self, packet):
        """The bytes of the library for the request of one of our packets."""
        servo, instruction, given = packet[4], packet[7], packet[8:-2]
        address, size = int.from_bytes(given[:2], "little"), int.from_bytes(given[2:4], "little")
        handler = self.handler
        if instruction == sdk.INST_PING:
            return self.by_library(lambda port: handler.ping(port, servo))
        if instruction == sdk.INST_READ:
            return self.by_library(lambda port: handler.readTx(port, servo, address, size))
        if instruction == sdk.INST_WRITE:
            data = list(given[2:])
            return self.by_library(
                lambda port: handler.writeTxOnly(port, servo, address, len(data), data))
        if instruction == sdk.INST_SYNC_READ:
            return self.by_library(lambda port: self.sync_read(port, address, size, given[4:]))
        self.assertEqual(instruction, sdk.INST_SYNC_WRITE)
        data = {given[at]: list(given[at + 1:at + 1 + size])
                for at in range(4, len(given), size + 1)}
        return self.by_library(lambda port: self.sync_write(port, address, size, data))


class Servos(Peer):
    """The library understands what the emulated servos answer."""

    def test_ping(self):
        for servo in range(1, SERVOS + 1):
            self.assertEqual(self.handler.ping(self.port, servo), (1240, sdk.COMM_SUCCESS, 0))
        self.assertEqual(self.handler.ping(self.port, 9)[1], sdk.COMM_RX_TIMEOUT)
        found, result = self.handler.broadcastPing(self.port)
        self.assertEqual(result, sdk.COMM_SUCCESS)
        self.assertEqual(found, {servo: [1240, 46] for servo in range(1, SERVOS + 1)})

    def test_write_and_read(self):
        for _ in range(300):
            servo, value = self.random.randint(1, SERVOS), self.random.randrange(4096)
            result = self.handler.write4ByteTxRx(self.port, servo, GOAL, value)
            self.assertEqual(result, (sdk.COMM_SUCCESS, 0))
            self.assertEqual(self.handler.read4ByteTxRx(self.port, servo, GOAL),
                             (value, sdk.COMM_SUCCESS, 0))
            self.assertEqual(self.handler.write2ByteTxRx(self.port, servo, 84, value),
                             (sdk.COMM_SUCCESS, 0))
            self.assertEqual(self.handler.read2ByteTxRx(self.port, servo, 84)[0], value)
            self.assertEqual(self.handler.write1ByteTxRx(self.port, servo, 65, value % 2),
                             (sdk.COMM_SUCCESS, 0))
            self.assertEqual(self.handler.read1ByteTxRx(self.port, servo, 65)[0], value % 2)

    def test_goal_and_torque(self):
        self.handler.write4ByteTxRx(self.port, 2, GOAL, 3000)
        self.assertEqual(self.chain.ask("driven", 1), "off")
        self.handler.write1ByteTxRx(self.port, 2, TORQUE, 1)
        self.assertEqual(self.chain.ask("driven", 1), "3000")
        self.sync_write(self.port, GOAL, 4, {2: four(1234), 3: four(77)})
        self.chain.ask("wait", 0.1)
        self.assertEqual(self.chain.ask("driven", 1), "1234")
        self.assertEqual(self.chain.ask("driven", 2), "off")

    def test_sync_read_of_states_that_need_stuffing(self):
        cases = [(-131073, -1), (-3, 0xFD - 256), (2048, -3), (0x00FDFFFF, 0), (0xFDFF, -1)]
        cases += [(self.random.randint(-200000, 200000), self.random.randint(-2000, 2000))
                  for _ in range(100)]
        for position, current in cases:
            for servo in range(SERVOS):
                self.chain.ask("measure", servo, position + servo, current)
            group, result = self.sync_read(self.port, CURRENT, 10, range(1, SERVOS + 1))
            self.assertEqual(result, sdk.COMM_SUCCESS)
            self.assertEqual(group.rxPacket(), sdk.COMM_SUCCESS)
            for servo in range(SERVOS):
                seen = signed(group.getData(servo + 1, 132, 4), 4)
                self.assertEqual(seen, position + servo)
                self.assertEqual(signed(group.getData(servo + 1, CURRENT, 2), 2), current)

    def test_errors(self):
        for address, value, number in ((132, 1, 7), (TORQUE, 2, 4), (GOAL, 5000, 6)):
            write = (self.handler.write4ByteTxRx if address != TORQUE
                     else self.handler.write1ByteTxRx)
            self.assertEqual(write(self.port, 1, address, value), (sdk.COMM_SUCCESS, number))
        self.chain.ask("overload", 0)
        value, result, error = self.handler.read1ByteTxRx(self.port, 1, ERROR)
        self.assertEqual((value, result), (0x20, sdk.COMM_SUCCESS))
        self.assertIn("Hardware error", self.handler.getRxPacketError(error))
        self.assertEqual(self.handler.reboot(self.port, 1)[0], sdk.COMM_SUCCESS)
        self.chain.ask("wait", 1)
        self.assertEqual(self.handler.read1ByteTxRx(self.port, 1, ERROR), (0, sdk.COMM_SUCCESS, 0))

    def test_reg_write_and_action(self):
        result = self.handler.regWriteTxRx(self.port, 1, TORQUE, 1, [1])
        self.assertEqual(result, (sdk.COMM_SUCCESS, 0))
        self.assertEqual(self.chain.ask("driven", 0), "off")
        self.assertEqual(self.handler.action(self.port, 1), sdk.COMM_SUCCESS)
        self.assertNotEqual(self.chain.ask("driven", 0), "off")


class Requests(Peer):
    """We send what the library sends for the same request."""

    def test_random_requests(self):
        handler = self.handler
        for _ in range(300):
            servo, address = self.random.randrange(253), self.random.randrange(256)
            size = self.random.randrange(1, 30)
            data = [self.random.randrange(0xFD) for _ in range(size)]
            ids = self.random.sample(range(253), 5)
            cases = {
                ("ping", servo): lambda port: handler.ping(port, servo),
                ("reboot", servo): lambda port: handler.reboot(port, servo),
                ("action", servo): lambda port: handler.action(port, servo),
                ("read", servo, address, size):
                    lambda port: handler.readTx(port, servo, address, size),
                ("write", servo, address, bytes(data).hex()):
                    lambda port: handler.writeTxOnly(port, servo, address, size, data),
                ("reg_write", servo, address, bytes(data).hex()):
                    lambda port: handler.regWriteTxOnly(port, servo, address, size, data),
                ("sync_read", address, size, bytes(ids).hex()):
                    lambda port: self.sync_read(port, address, size, ids),
                ("sync_write", address, size, b"".join(bytes([one, *data]) for one in ids).hex()):
                    lambda port: self.sync_write(port, address, size, {one: data for one in ids}),
            }
            for words, send in cases.items():
                self.assertEqual(self.chain.bytes("encode", *words), self.by_library(send), words)

    def test_stuffing(self):
        """The library has the rule of stuffing, though it does not send its result (see below)."""
        for _ in range(300):
            size = self.random.randrange(1, 40)
            data = self.random.choices([0xFF, 0xFF, 0xFD, 0x00], k=size)
            packet = [0xFF, 0xFF, 0xFD, 0, 1, size + 5, 0, 3, GOAL, 0, *data, 0, 0]
            stuffed = self.handler.addStuffing(packet)
            crc = self.handler.updateCRC(0, stuffed, len(stuffed) - 2)
            stuffed[-2:] = [crc & 0xFF, crc >> 8]
            self.assertEqual(self.chain.bytes("encode", "write", 1, GOAL, bytes(data).hex()),
                             bytes(stuffed))

    def test_library_sends_no_stuffing(self):
        """dynamixel_sdk 4.1.0 discards the stuffed packet. If this fails, it was repaired."""
        data = [0xFF, 0xFF, 0xFD, 0x00]
        sent = self.by_library(lambda port: self.handler.writeTxOnly(port, 1, GOAL, 4, data))
        self.assertEqual(sent[10:-2], bytes(data))

    def test_bus(self):
        start = self.chain.bytes("start")
        ticks = b"".join(self.chain.bytes("tick", 0.02, *(self.random.uniform(0, 4095)
                                                          for _ in range(SERVOS)))
                         for _ in range(100))
        count = 0
        for packet in packets(start + ticks + self.chain.bytes("relax")):
            self.assertEqual(packet, self.repeated(packet))
            count += 1
        self.assertGreater(count, 200 + 9 * SERVOS)

    def test_a_tick_is_a_sync_write_and_a_sync_read(self):
        self.chain.ask("start")  # all at 2048
        tick = self.chain.bytes("tick", 0.02, 2148, "nan", 2048)
        # 100 steps in 0.02 s are 5000 * 60 / 4096 = 73.24 rev/min, or 319.8 units of 0.229.
        goals = self.by_library(lambda port: self.sync_write(
            port, VELOCITY, 8, {1: four(320) + four(2148), 3: four(1) + four(2048)}))
        states = self.by_library(lambda port: self.sync_read(port, CURRENT, 10, [1, 2, 3]))
        self.assertEqual(tick, goals + states)


class Tables(Peer):
    """Models and addresses are those that the maker delivers with the library."""

    def test_models(self):
        lines = (TABLES / "dynamixel.model").read_text(encoding="utf-8").splitlines()[1:]
        numbers = {name.removesuffix(".model"): int(number)
                   for number, name in (line.split("\t") for line in lines if line)}
        known = self.chain.ask("models").split()
        self.assertGreater(len(known), 3 * 15)
        for name, number, unit in zip(known[::3], known[1::3], known[2::3]):
            file = name.lower().replace("-", "_")
            self.assertEqual(numbers[file], int(number), name)
            table = self.table(file)
            measured = "Present Load" if unit == "nan" else "Present Current"
            self.assertEqual(table[measured], (CURRENT, 2), name)
            expected = {"Model Number": (0, 2), "Return Delay Time": (9, 1), "Drive Mode": (10, 1),
                        "Operating Mode": (11, 1), "Velocity Limit": (44, 4),
                        "Max Position Limit": (48, 4), "Min Position Limit": (52, 4),
                        "Shutdown": (63, 1), "Torque Enable": (TORQUE, 1),
                        "Status Return Level": (STATUS_LEVEL, 1),
                        "Hardware Error Status": (ERROR, 1),
                        "Profile Acceleration": (ACCELERATION, 4),
                        "Profile Velocity": (VELOCITY, 4), "Goal Position": (GOAL, 4),
                        "Present Velocity": (128, 4), "Present Position": (132, 4)}
            for item, place in expected.items():
                self.assertEqual(table[item], place, f"{name}: {item}")

    @staticmethod
    def table(model):
        found = {}
        for line in (TABLES / f"{model}.model").read_text(encoding="utf-8").splitlines():
            parts = line.split("\t")
            if len(parts) == 3 and parts[0].isdigit() and parts[1].isdigit():
                found[parts[2]] = (int(parts[0]), int(parts[1]))
        return found


if __name__ == "__main__":
    unittest.main()
