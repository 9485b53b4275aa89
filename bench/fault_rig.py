"""An emulated hand behind a proxy, and the programs that use it, in a folder of their own."""

import contextlib
import os
import re
import signal
import subprocess
import sys
import termios
import threading
import time
import tomllib
from pathlib import Path

from fault_proxy import Proxy, wait_until

TREE = Path(__file__).resolve().parent.parent
PATIENCE = 60.0  # seconds for a step of a program
SETTINGS = "[plan]\nheights = [115]\nwrist_angles = [0]\ngrasps = 1\n"  # of Hand II: one grasp


def with_key(text, table, key, value):
    """The text of a device file in which a key of a table has another value, as TOML."""
    head = re.escape(f"[{table}]") if table else ""
    pattern = re.compile(rf"({head}(?:(?!^\[).)*?^){key} = [^\n]*", re.MULTILINE | re.DOTALL)
    changed, count = pattern.subn(lambda found: f"{found[1]}{key} = {value}", text, count=1)
    if count == 0:
        raise ValueError(f"no key {key} in {table}")
    return changed


class Terminal:
    """A process at a terminal: what it prints, and the keys that a person presses."""

    def __init__(self, words, folder, prepare):
        self.ours, theirs = os.openpty()
        settings = termios.tcgetattr(theirs)
        settings[3] &= ~termios.ECHO
        termios.tcsetattr(theirs, termios.TCSANOW, settings)
        self.process = subprocess.Popen(words, cwd=folder, stdin=theirs, stdout=theirs, stderr=theirs,
                                        start_new_session=True, preexec_fn=prepare)
        os.close(theirs)
        self.printed = ""
        self.thread = threading.Thread(target=self.read, daemon=True)
        self.thread.start()

    def read(self):
        with contextlib.suppress(OSError):
            while data := os.read(self.ours, 4096):
                self.printed += data.decode(errors="replace")

    def text(self):
        return re.sub(r"\033\[[^A-Za-z]*[A-Za-z]", "", self.printed).replace("\r", "\n")

    def press(self, keys):
        os.write(self.ours, keys)

    def wait_for(self, pattern):
        return wait_until(lambda: re.search(pattern, self.text()), PATIENCE)

    def send(self, number):
        self.process.send_signal(number)

    def end(self, number=signal.SIGINT):
        """Sends the signal and returns the exit code, negative for a signal that ended it."""
        if self.process.poll() is None:
            self.send(number)
        try:
            code = self.process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            self.process.kill()
            raise
        self.thread.join(1.0)
        return code

    def close(self):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()
        self.thread.join(1.0)
        os.close(self.ours)


class Rig(contextlib.ExitStack):
    """The hand `body` at the bus, `format` of its sensor frames."""

    def __init__(self, program, folder, bus, body="lucs3", frames="frames", priority=0):
        super().__init__()
        self.somato, self.folder, self.bus, self.body, self.frames = program, Path(folder), bus, body, frames
        self.priority = priority

    def __enter__(self):
        super().__enter__()
        text = (TREE / f"devices/{self.body}.toml").read_text(encoding="utf-8")
        text = with_key(with_key(text, "frames", "baud", "921600"), "frames", "format", f'"{self.frames}"')
        self.write("own.toml", text)
        self.write("settings.toml", SETTINGS)
        self.emulator = self.terminal("emulate", "--body", self.body, "--bus", self.bus, "--device", "own.toml",
                                      "-o", "emulated.toml")
        self.emulator.wait_for("Press Ctrl-C")
        text = (self.folder / "emulated.toml").read_text(encoding="utf-8")
        ports = tomllib.loads(text)
        self.proxy = self.enter_context(
            Proxy(self.bus, ports["servos"]["port"], ports["frames"]["port"], self.folder))
        for table in ("servos", "frames"):
            text = with_key(text, table, "port", f'"{self.folder / table}"')
        self.write("hand.toml", text)
        self.device = tomllib.loads(text)
        return self

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")

    def prepare(self):
        if self.priority:
            os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(self.priority))

    def terminal(self, *words):
        started = Terminal([self.somato, *words], self.folder, self.prepare)
        self.callback(started.close)
        return started

    def run(self, *words):
        """The exit code of a command without a terminal, and what it reports."""
        done = subprocess.run([self.somato, *words], cwd=self.folder, capture_output=True, text=True,
                              stdin=subprocess.DEVNULL, timeout=PATIENCE, preexec_fn=self.prepare, check=False)
        return done.returncode, done.stderr.strip() or done.stdout.strip()

    def explore(self):
        words = ["explore", "--device", "hand.toml", "--explorations", "5", "-o", "hand.mcap"]
        if self.body == "lucs2":
            words += ["--settings", "settings.toml"]
        return self.terminal(*words)

    def servo(self, name):
        """The number of a servo on the bus, its calibration and its range in degrees."""
        servo = self.device["servo"][name]
        return servo["channel"], servo["scale"], servo["most"] - servo["least"]

    def explorations_on_disk(self):
        """The number of explorations in the recording, and the files of the session."""
        names = sorted(path.name for path in self.folder.glob("hand.mcap*"))
        if "hand.mcap" not in names:
            self.run("recover", "hand.mcap.partial", "-o", "found.mcap")
        source = "hand.mcap" if "hand.mcap" in names else "found.mcap"
        found = re.search(r"^explorations: (\d+)", self.run("inspect", source)[1], re.MULTILINE)
        return int(found[1]) if found else 0, names


def use_as_proxy(priority):
    """Python waits at most a millisecond for the thread of the proxy."""
    sys.setswitchinterval(0.001)
    if priority:
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(priority))


@contextlib.contextmanager
def busy_processes(count):
    started = [subprocess.Popen([sys.executable, "-c", "while True: pass"],
                                preexec_fn=lambda: os.sched_setscheduler(0, os.SCHED_OTHER, os.sched_param(0)))
               for _ in range(count)]
    try:
        time.sleep(0.5)
        yield
    finally:
        for process in started:
            process.kill()
            process.wait()
