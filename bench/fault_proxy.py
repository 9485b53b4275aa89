"""A proxy between a program and its emulated device, which logs every byte and makes faults of the lines.

Each line has a pseudo-terminal for the program, at a path that stays the same when its cable is pulled and put back.
"""

import os
import select
import threading
import time
import tty
from dataclasses import dataclass

from fault_packets import decoder_of


@dataclass(frozen=True)
class Sent:
    """A command of the program at the moment when its bytes were read."""
    moment: float
    goals: dict  # those that differ from the ones before
    torque: bool | None


class Line:
    """One of the lines; `path` is the program's port."""

    def __init__(self, emulator_port, path):
        self.path = path
        self.silent = False  # whether what the device sends is lost
        self.device = os.open(emulator_port, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
        tty.setraw(self.device)
        self.host = self.program_side = None
        self.connect()

    def connect(self):
        self.host, self.program_side = os.openpty()
        tty.setraw(self.program_side)
        os.set_blocking(self.host, False)
        temporary = f"{self.path}.new"
        os.symlink(os.ttyname(self.program_side), temporary)
        os.replace(temporary, self.path)

    def pull(self):
        os.unlink(self.path)
        for end in (self.host, self.program_side):
            os.close(end)
        self.host = self.program_side = None

    def close(self):
        for end in (self.host, self.program_side, self.device):
            if end is not None:
                os.close(end)


def read_some(descriptor):
    try:
        return os.read(descriptor, 65536)
    except (BlockingIOError, OSError):
        return b""


def write_all(descriptor, data):
    """What the other side does not accept is lost, as on a line."""
    try:
        os.write(descriptor, data)
    except (BlockingIOError, OSError):
        pass


class Proxy:
    """The lines for the servos and the sensors, between `with` and its end."""

    def __init__(self, bus, servos, frames, folder):
        self.decoder = decoder_of(bus)
        self.servos = Line(servos, f"{folder}/servos")
        self.frames = Line(frames, f"{folder}/frames")
        self.changes = None  # of the answers of a servo
        self.frame_change = None  # a function from a line of numbers to another one
        self.fault = 0.0  # the moment of the fault
        self.bytes_from_program = 0
        self.sent = []
        self.goals = {}
        self.rest_of_frame = b""
        self.lock = threading.Lock()
        self.ends = False
        self.thread = threading.Thread(target=self.run)

    def __enter__(self):
        self.thread.start()
        return self

    def __exit__(self, *_):
        self.ends = True
        self.thread.join()
        self.servos.close()
        self.frames.close()

    def run(self):
        while not self.ends:
            with self.lock:
                ends = {end: (line, end == line.device) for line in (self.servos, self.frames)
                        for end in (line.host, line.device) if end is not None}
            try:
                ready, _, _ = select.select(ends, [], [], 0.005)
            except OSError:
                continue  # a cable was pulled meanwhile
            with self.lock:
                for end in ready:
                    self.pass_on(*ends[end])

    def pass_on(self, line, from_device):
        if line.host is None:
            read_some(line.device)
        elif not from_device:
            self.pass_to_device(line, read_some(line.host))
        else:
            data = self.from_device(line, read_some(line.device))
            write_all(line.host, data)

    def pass_to_device(self, line, data):
        moment = time.monotonic()
        self.bytes_from_program += len(data)
        if line is self.servos:
            for command in self.decoder.commands(data):
                self.note(moment, command)
        write_all(line.device, data)

    def note(self, moment, command):
        new = {servo: goal for servo, goal in command.goals.items() if self.goals.get(servo) != goal}
        self.goals.update(new)
        if new or command.torque is not None:
            self.sent.append(Sent(moment, new, command.torque))

    def from_device(self, line, data):
        if line.silent:
            return b""
        if line is self.servos:
            return self.decoder.answers(data, self.changes, time.monotonic() - self.fault)
        if self.frame_change is None:
            return data
        *whole, self.rest_of_frame = (self.rest_of_frame + data).split(b"\n")
        return b"".join(self.frame_change(frame) + b"\n" for frame in whole)

    def begin_fault(self, work):
        """Does `work` between two bytes; it begins the fault."""
        with self.lock:
            self.fault = time.monotonic()
            work(self)
        return self.fault

    def moves(self, since=0.0):
        """The moments of the commands since then that change a goal."""
        with self.lock:
            return [sent.moment for sent in self.sent if sent.goals and sent.moment > since]

    def first_off(self, since):
        with self.lock:
            return next((sent.moment for sent in self.sent if sent.torque is False and sent.moment > since), None)

    def is_on(self):
        """Whether the servos were switched on, and not off again."""
        with self.lock:
            last = [sent.torque is not False for sent in self.sent if sent.torque is not None or sent.goals]
        return bool(last) and last[-1]

    def wait_for_move(self, since, patience=60.0):
        return wait_until(lambda: next(iter(self.moves(since)), None), patience)


def wait_until(found, patience=60.0):
    """The first true result of `found`; fails (TimeoutError) after `patience` seconds."""
    end = time.monotonic() + patience
    while time.monotonic() < end:
        if result := found():
            return result
        time.sleep(0.002)
    raise TimeoutError
