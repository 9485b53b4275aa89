"""The program as a client of the topics of Foxglove's own server, and of one that misbehaves."""

import asyncio
import json
import os
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path

import foxglove
import websockets
from mcap.reader import make_reader

PROGRAM = os.environ["SOMATO_PROGRAM"]
ELEMENTS = 1089  # of the skin of an ORCA Touch hand
RATE = 1000.0
SECONDS = int(os.environ.get("SOMATO_TOPIC_SECONDS", "2"))


def payload(number):
    """A Touch message in CDR whose values are `number`."""
    return (b"\0\1\0\0" + struct.pack("<I", ELEMENTS) +
            struct.pack("<f", number) * ELEMENTS)


class Robot:
    """A server of the Foxglove SDK that counts its messages upwards from 0, from the first subscription.

    Its time is that of its messages, which a slow machine sends more slowly.
    """

    def __init__(self, topic="/touch", port=0, damaged=None, clock=0):
        """`damaged` is the number of a message that is cut, `clock` the time of the first in seconds."""
        self.damaged = damaged
        self.clock = clock
        self.server = self.serve(port)
        schema = foxglove.Schema(name="test_msgs/msg/Touch", encoding="ros2msg",
                                 data=b"float32[] forces\n")
        self.context = foxglove.Context()
        self.channel = foxglove.Channel(topic, schema=schema, message_encoding="cdr")
        self.sent = 0
        self.stopping = threading.Event()
        self.thread = threading.Thread(target=self.publish)
        self.thread.start()

    @staticmethod
    def serve(port):
        """A port that was just given back may be in use for a while.

        The server keeps what a busy machine delays; by default it drops messages after a second.
        """
        deadline = time.monotonic() + 30
        while True:
            try:
                return foxglove.start_server(host="127.0.0.1", port=port,
                                             message_backlog_size=60_000)
            except RuntimeError:
                if time.monotonic() > deadline:
                    raise
                time.sleep(0.05)

    @property
    def address(self):
        return f"ws://127.0.0.1:{self.server.port}"

    def publish(self):
        while not self.channel.has_sinks() and not self.stopping.is_set():
            time.sleep(1 / RATE)
        while not self.stopping.is_set():
            message = payload(float(self.sent))
            if self.sent == self.damaged:
                message = message[:100]
            self.channel.log(message, log_time=int(self.clock * 1e9 + self.sent * 1e9 / RATE))
            self.sent += 1
            time.sleep(1 / RATE)

    def wait_until_sent(self, count):
        while self.sent < count:
            time.sleep(1 / RATE)

    def stop(self):
        self.stopping.set()
        self.thread.join()
        self.channel.close()
        self.server.stop()


def somato(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=120,
                          stdin=subprocess.DEVNULL)


def frames(path):
    """The values of the first element of every frame, and whether all elements are the same."""
    first, alike = [], True
    with open(path, "rb") as file:
        for _, channel, message in make_reader(file).iter_messages():
            if channel.topic != "/touch":
                continue
            values = struct.unpack(f"<{ELEMENTS}f", message.data[-4 * ELEMENTS:])
            first.append(values[0])
            alike = alike and len(set(values)) == 1
    return first, alike


class Topics(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.recording = str(Path(folder.name) / "touch.mcap")

    def explore(self, address, *flags):
        return somato("explore", "--topics", address, "--channels", "touch:N=/touch:forces",
                      "--explorations", "1", "-o", self.recording, *flags)

    def test_records_every_message_of_the_foxglove_sdk(self):
        robot = Robot()
        self.addCleanup(robot.stop)
        done = self.explore(robot.address, "--duration", str(SECONDS))
        self.assertEqual(done.returncode, 0, done.stderr)
        values, alike = frames(self.recording)
        self.assertTrue(alike)
        self.assertEqual(len(values), SECONDS * RATE + 1)
        self.assertEqual(values, [values[0] + i for i in range(len(values))])
        self.assertNotIn("dropped", done.stderr)

    def test_a_program_that_is_slowed_loses_nothing(self):
        robot = Robot()
        self.addCleanup(robot.stop)
        running = subprocess.Popen(
            [PROGRAM, "explore", "--topics", robot.address, "--channels", "touch:N=/touch:forces",
             "--explorations", "1", "--duration", "2", "-o", self.recording],
            stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        robot.wait_until_sent(700)
        running.send_signal(signal.SIGSTOP)
        robot.wait_until_sent(1400)
        running.send_signal(signal.SIGCONT)
        _, errors = running.communicate(timeout=120)
        self.assertEqual(running.returncode, 0, errors)
        values, _ = frames(self.recording)
        self.assertEqual(values, [values[0] + i for i in range(int(2 * RATE) + 1)])

    def test_a_robot_that_starts_again_is_explored_again(self):
        # The clock goes back, however long the new connection takes.
        robots = [Robot(clock=1000)]
        port = robots[0].server.port

        def start_again():
            robots[0].wait_until_sent(700)
            robots.pop().stop()
            robots.append(Robot(port=port))

        restart = threading.Thread(target=start_again)
        restart.start()
        done = somato("explore", "--topics", f"ws://127.0.0.1:{port}", "--channels",
                      "touch:N=/touch:forces", "--explorations", "3", "--duration", "1", "-o",
                      self.recording)
        restart.join()
        robots[0].stop()
        values, _ = frames(self.recording)
        explorations, rest = divmod(len(values), int(RATE) + 1)
        self.assertEqual(rest, 0)
        self.assertGreaterEqual(explorations, 2, done.stderr)

    def test_a_damaged_message_is_named(self):
        robot = Robot(damaged=1500)
        self.addCleanup(robot.stop)
        done = self.explore(robot.address, "--duration", "10")
        self.assertEqual(done.returncode, 1)
        self.assertIn("/touch", done.stderr)
        self.assertIn("forces", done.stderr)

    def test_names_the_topics_that_there_are(self):
        robot = Robot("/skin")
        self.addCleanup(robot.stop)
        done = self.explore(robot.address)
        self.assertEqual(done.returncode, 1)
        self.assertIn("/skin", done.stderr)
        self.assertFalse(Path(self.recording).exists())

    def test_a_robot_that_stops_ends_the_exploration(self):
        robot = Robot()

        def stop():
            robot.wait_until_sent(1000)
            robot.stop()

        end = threading.Thread(target=stop)
        end.start()
        done = self.explore(robot.address, "--duration", "60")
        end.join()
        self.assertEqual(done.returncode, 1)
        self.assertIn("the connection is lost", done.stderr)

    def test_another_server_is_named_as_such(self):
        async def serve(connection):
            await connection.send(json.dumps({"op": "advertise", "channels": [7]}))
            await connection.send("[" * 100000)
            await connection.send(b"\1")
            await connection.wait_closed()

        async def run():
            async with websockets.serve(serve, "127.0.0.1", 0,
                                        subprotocols=["foxglove.websocket.v1"]) as server:
                port = server.sockets[0].getsockname()[1]
                return await asyncio.to_thread(self.explore, f"ws://127.0.0.1:{port}")

        done = asyncio.run(run())
        self.assertEqual(done.returncode, 1)
        self.assertIn("the robot has no topic '/touch'", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v"])
