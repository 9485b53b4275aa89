import re
import sys
import unittest
from pathlib import Path

TREE = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TREE / "bench"))

import fault_packets
import faults
from fault_packets import Changes
from fault_rig import with_key

# Feetech's manual of the SCS protocol and ROBOTIS' e-Manual of protocol 2 give these packets.
FEETECH_READ_ANSWER = bytes.fromhex("ffff0104001805dd")
FEETECH_SYNC_WRITE = bytes.fromhex(
    "ffff fe 20 83 2a 06 0100080000e803 0200080000e803 0300080000e803 0400080000e803 58")
DYNAMIXEL_READ_ANSWER = bytes.fromhex("fffffd0001080055 00 a6000000 8cc0")


def one(commands):
    found = list(commands)
    assert len(found) == 1, found
    return found[0]


class Tests(unittest.TestCase):
    def test_each_row_names_tests_that_exist(self):
        found = set()
        for path in (TREE / "tests").rglob("*_test.cc"):
            named = re.findall(r"^TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\)", path.read_text(encoding="utf-8"), re.MULTILINE)
            found |= {f"{suite}.{name}" for suite, name in named}
        for row in faults.ROWS:
            self.assertTrue(row.tests, row.fault)
            self.assertEqual([test for test in row.tests if test not in found], [], row.fault)

    def test_the_page_has_each_row(self):
        page = faults.PAGE.read_text(encoding="utf-8")
        table = page[page.index(faults.BEGIN):page.index(faults.END)]
        for row in faults.ROWS:
            self.assertIn(f"| {row.fault} |", table)


class Packets(unittest.TestCase):
    def test_goals_and_torque_of_an_ssc32(self):
        board = fault_packets.Ssc32()
        self.assertEqual(list(board.commands(b"\x1b\r#0P1500#11P9")), [])
        self.assertEqual(one(board.commands(b"00T20\rQP3\r")).goals, {0: 1500, 11: 900})
        self.assertIs(one(board.commands(b"#5P0\r")).torque, False)

    def test_goals_and_torque_of_feetech_servos(self):
        servos = fault_packets.Feetech("little")
        self.assertEqual(list(servos.commands(b"\x00\xff" + FEETECH_SYNC_WRITE[:9])), [])
        self.assertEqual(one(servos.commands(FEETECH_SYNC_WRITE[9:])).goals, dict.fromkeys(range(1, 5), 0x0800))
        off = bytes([0xFE, 4, 3, 40, 0])
        packet = b"\xff\xff" + off + bytes([fault_packets.feetech_sum(off)])
        self.assertIs(one(servos.commands(packet)).torque, False)

    def test_answers_of_other_servos_stay_as_they_are(self):
        servos = fault_packets.Feetech("little")
        self.assertEqual(servos.answers(FEETECH_READ_ANSWER, Changes(1, overload=True), 0.0), FEETECH_READ_ANSWER)
        chain = fault_packets.Dynamixel()
        self.assertEqual(chain.answers(DYNAMIXEL_READ_ANSWER, Changes(2, overload=True), 0.0), DYNAMIXEL_READ_ANSWER)

    def test_states_are_changed_and_have_their_sums(self):
        body = bytes([1, 17, 0]) + bytes(15)
        state = b"\xff\xff" + body + bytes([fault_packets.feetech_sum(body)])
        changed = fault_packets.Feetech("little").answers(
            state, Changes(1, lambda true, seconds: true + 1000 * seconds, True, 130), 0.5)
        self.assertEqual((changed[4], changed[5:7], changed[12]), (0x20, b"\xf4\x01", 130))
        self.assertEqual(sum(changed[2:]) & 0xFF, 0xFF)

    def test_dynamixel_answers_have_the_crc_of_the_manual(self):
        chain = fault_packets.Dynamixel()
        changed = chain.answers(DYNAMIXEL_READ_ANSWER, Changes(1, overload=True), 0.0)
        self.assertEqual(changed[8], 0x80)
        self.assertEqual(chain.packet(1, bytes.fromhex("5500a6000000")), DYNAMIXEL_READ_ANSWER)

    def test_a_device_file_gets_another_value_in_one_table(self):
        text = "port = \"a\"\n[servos]\nport = \"b\"  # c\n[frames]\nport = \"d\"\n"
        self.assertEqual(with_key(text, "frames", "port", '"e"'), text.replace('"d"', '"e"'))
        self.assertEqual(with_key(text, "servos", "port", '"e"'), text.replace('"b"  # c', '"e"'))
        with self.assertRaises(ValueError):
            with_key(text, "frames", "baud", "1")
