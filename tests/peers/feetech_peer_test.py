"""Our emulated Feetech servos, bus and encoders against the library of the maker, scservo_sdk."""

import random
import unittest

import scservo_sdk as sdk
from chain import Chain, Port

MODEL, TORQUE, GOAL, POSITION, CURRENT = 3, 40, 42, 56, 69
STS, SCS = "sts", "scs"
MODELS = {STS: 777, SCS: 1284}  # STS3215 and SCS0009
SERVOS = 3


def packets(stream):
    """The packets of a stream that contains nothing else."""
    while stream:
        size = 4 + stream[3]
        yield stream[:size]
        stream = stream[size:]


class Peer(unittest.TestCase):
    def setUp(self):
        self.random = random.Random(1)
        self.silent = Port()

    def begin(self, series):
        self.chain = Chain(series, SERVOS)
        self.addCleanup(self.chain.close)
        self.port = Port(self.chain)
        self.handler = sdk.PacketHandler(1 if series == SCS else 0)  # the order of bytes
        return self.handler

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
        servo, instruction, given = packet[2], packet[4], packet[5:-1]
        handler = self.handler
        if instruction == sdk.INST_READ:
            return self.by_library(lambda port: handler.readTx(port, servo, given[0], given[1]))
        if instruction == sdk.INST_WRITE:
            data = list(given[1:])
            return self.by_library(
                lambda port: handler.writeTxOnly(port, servo, given[0], len(data), data))
        address, size = given[:2]
        if instruction == sdk.INST_SYNC_READ:
            return self.by_library(lambda port: self.sync_read(port, address, size, given[2:]))
        self.assertEqual(instruction, sdk.INST_SYNC_WRITE)
        data = {given[at]: list(given[at + 1:at + 1 + size])
                for at in range(2, len(given), size + 1)}
        return self.by_library(lambda port: self.sync_write(port, address, size, data))

    def words(self, *values):
        return [part for value in values for part in (sdk.SCS_LOBYTE(value), sdk.SCS_HIBYTE(value))]


class Servos(Peer):
    """The library understands what the emulated servos answer."""

    def test_ping(self):
        for series in (STS, SCS):
            handler = self.begin(series)
            self.assertEqual(handler.ping(self.port, 2), (MODELS[series], sdk.COMM_SUCCESS, 0))
            self.assertEqual(handler.ping(self.port, 9)[1], sdk.COMM_RX_TIMEOUT)

    def test_write_and_read(self):
        for series in (STS, SCS):
            handler = self.begin(series)
            for _ in range(300):
                servo, value = self.random.randint(1, SERVOS), self.random.randrange(1024)
                self.assertEqual(handler.write2ByteTxRx(self.port, servo, GOAL, value),
                                 (sdk.COMM_SUCCESS, 0))
                self.assertEqual(handler.read2ByteTxRx(self.port, servo, GOAL),
                                 (value, sdk.COMM_SUCCESS, 0))

    def test_goal_and_torque(self):
        for series in (STS, SCS):
            handler = self.begin(series)
            handler.write2ByteTxRx(self.port, 2, GOAL, 700)
            self.assertEqual(self.chain.ask("driven", 1), "off")
            handler.write1ByteTxRx(self.port, 2, TORQUE, 1)
            self.assertEqual(self.chain.ask("driven", 1), "700")
            self.sync_write(self.port, GOAL, 2, {2: self.words(600), 3: self.words(77)})
            self.chain.ask("wait", 0.1)
            self.assertEqual(self.chain.ask("driven", 1), "600")
            self.assertEqual(self.chain.ask("driven", 2), "off")

    def test_states(self):
        for series in (STS, SCS):
            handler = self.begin(series)
            for _ in range(100):
                position, current = self.random.randrange(1024), self.random.randint(-300, 300)
                self.chain.ask("measure", 1, position, 6.5 * current)
                self.assertEqual(handler.read2ByteTxRx(self.port, 2, POSITION)[0], position)
                if series == STS:
                    seen = handler.read2ByteTxRx(self.port, 2, CURRENT)[0]
                    self.assertEqual(sdk.SCS_TOHOST(seen, 15), current)

    def test_sync_read(self):
        self.begin(STS)
        for servo in range(SERVOS):
            self.chain.ask("measure", servo, 1000 * servo + 255, 65)
        group, result = self.sync_read(self.port, POSITION, 15, [1, 2, 3])
        self.assertEqual(result, sdk.COMM_SUCCESS)
        self.assertEqual(group.rxPacket(), sdk.COMM_SUCCESS)
        for servo in range(SERVOS):
            self.assertEqual(group.getData(servo + 1, POSITION, 2), 1000 * servo + 255)
            self.assertEqual(group.getData(servo + 1, CURRENT, 2), 10)
        self.begin(SCS)
        group, result = self.sync_read(self.port, POSITION, 6, [1, 2, 3])
        self.assertEqual(group.rxPacket(), sdk.COMM_RX_TIMEOUT)

    def test_overload(self):
        for series in (STS, SCS):
            handler = self.begin(series)
            handler.write1ByteTxRx(self.port, 1, TORQUE, 1)
            self.chain.ask("overload", 0)
            value, result, error = handler.read1ByteTxRx(self.port, 1, TORQUE)
            self.assertEqual((value, result, error), (0, sdk.COMM_SUCCESS, 32))
            self.assertIn("Overload", handler.getRxPacketError(error))

    def test_reg_write_and_action(self):
        handler = self.begin(STS)
        self.assertEqual(handler.regWriteTxRx(self.port, 1, TORQUE, 1, [1]), (sdk.COMM_SUCCESS, 0))
        self.assertEqual(self.chain.ask("driven", 0), "off")
        handler.action(self.port, 254)
        self.assertNotEqual(self.chain.ask("driven", 0), "off")


class Requests(Peer):
    """We send what the library sends for the same request."""

    def test_random_requests(self):
        for series in (STS, SCS):
            handler = self.begin(series)
            for _ in range(200):
                servo, address = self.random.randrange(253), self.random.randrange(100)
                size = self.random.randrange(1, 30)
                data = [self.random.randrange(256) for _ in range(size)]
                ids = self.random.sample(range(253), 5)
                each = b"".join(bytes([one, *data]) for one in ids)
                cases = {
                    ("ping", servo): lambda port: handler.ping(port, servo),
                    ("action", servo): lambda port: handler.action(port, servo),
                    ("read", servo, address, size):
                        lambda port: handler.readTx(port, servo, address, size),
                    ("write", servo, address, bytes(data).hex()):
                        lambda port: handler.writeTxOnly(port, servo, address, size, data),
                    ("reg_write", servo, address, bytes(data).hex()):
                        lambda port: handler.regWriteTxOnly(port, servo, address, size, data),
                    ("sync_read", address, size, bytes(ids).hex()):
                        lambda port: self.sync_read(port, address, size, ids),
                    ("sync_write", address, size, each.hex()):
                        lambda port: self.sync_write(port, address, size,
                                                     {one: data for one in ids}),
                }
                for words, send in cases.items():
                    self.assertEqual(self.chain.bytes("encode", *words), self.by_library(send))

    def test_bus(self):
        for series in (STS, SCS):
            self.begin(series)
            start = self.chain.bytes("start")
            # Each tick requests a state: the wait for the last answer, which never comes, is over.
            ticks = b"".join(self.chain.bytes("tick", 0.06, *(self.random.uniform(0, 1023)
                                                              for _ in range(SERVOS)))
                             for _ in range(100))
            count = 0
            for packet in packets(start + ticks + self.chain.bytes("relax")):
                self.assertEqual(packet, self.repeated(packet))
                count += 1
            self.assertGreater(count, 200 + 6 * SERVOS)

    def test_a_tick_is_a_sync_write_and_a_request(self):
        self.begin(STS)
        self.chain.ask("start")  # all at 512
        goals = self.by_library(lambda port: self.sync_write(
            port, GOAL, 6, {1: self.words(545, 0, 1650), 3: self.words(512, 0, 50)}))
        states = self.by_library(lambda port: self.sync_read(port, POSITION, 15, [1, 2, 3]))
        self.assertEqual(self.chain.bytes("tick", 0.02, 545, "nan", 512), goals + states)
        handler = self.begin(SCS)
        self.chain.ask("start")
        goals = self.by_library(lambda port: self.sync_write(
            port, GOAL, 6, {1: self.words(545, 20, 0), 3: self.words(512, 20, 0)}))
        state = self.by_library(lambda port: handler.readTx(port, 1, POSITION, 8))  # to the temperature
        self.assertEqual(self.chain.bytes("tick", 0.02, 545, "nan", 512), goals + state)


if __name__ == "__main__":
    unittest.main()
