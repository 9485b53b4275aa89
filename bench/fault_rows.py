"""The faults of docs/your-hand.md: how each is made, when its stop is due, and the tests of its outcome.

A row is a function of a rig; it returns an Outcome. Times are seconds after the fault.
"""

import json
import re
import signal
import time
import urllib.error
import urllib.request
from dataclasses import dataclass, field
from threading import Thread

from fault_packets import Changes
from fault_proxy import wait_until
from fault_rig import with_key

MEASURING = ("dynamixel", "sts", "scs")  # buses whose servos report their positions
PERIODS = 0.06  # s: `missed` periods
SILENCE = {"ssc32": 0.2, "scs": 0.1}  # s without an answer, where it is more
DEVIATION, UNMOVED = 0.1, 0.5  # the defaults of [safety]
DRIFT = 176.0  # deg/s
CLOSING_STEP = 0.1  # s; a pause ends with the step of the exploration
FINGER = "index_proximal"


@dataclass
class Outcome:
    last: float | None = None  # the last command that changes a goal; None: no motion was to be stopped
    due: float = 0.0
    off: float | None = None  # when the servos were switched off
    on: bool = False  # whether they are on at the end
    says: str = ""
    disk: str = ""
    problems: list = field(default_factory=list)


@dataclass(frozen=True)
class Row:
    fault: str
    measure: callable
    tests: tuple  # of its outcome, without real time: names of GoogleTest, or of a file of Python
    buses: tuple = ("ssc32", *MEASURING)
    body: str = "lucs3"
    frames: str = "frames"
    busy: int = 0  # processes beside it


class NotMeasured(Exception):
    """The hand has stopped for another reason, such as a machine that is too busy for the emulation."""


def expect_move(rig, program):
    since = time.monotonic()
    try:
        wait_until(lambda: rig.proxy.moves(since) or message_of(program), 20.0)
    except TimeoutError:
        pass
    if not rig.proxy.moves(since):
        raise NotMeasured(program.text()[-400:])
    return rig.proxy.moves(since)[0]


def begin(rig):
    """A program whose first exploration is saved."""
    program = rig.explore()
    try:
        program.wait_for(r"exploring: +[1-9]\d* %|The device has stopped")
    except TimeoutError:
        pass
    if message_of(program):
        raise NotMeasured(message_of(program))
    return program


def in_motion(rig):
    """A program in the motion of the second exploration."""
    program = begin(rig)
    expect_move(rig, program)
    time.sleep(0.5)
    if message_of(program):
        raise NotMeasured(message_of(program))
    return program


def watch(rig, fault, seconds=3.0):
    """The outcome of a fault as far as the line shows it, and a second more."""
    end = time.monotonic() + seconds
    while rig.proxy.first_off(fault) is None and time.monotonic() < end:
        time.sleep(0.01)
    time.sleep(1.0)
    moves, off = rig.proxy.moves(fault), rig.proxy.first_off(fault)
    outcome = Outcome(moves[-1] - fault if moves else 0.0, off=off and off - fault, on=rig.proxy.is_on())
    if off and moves and moves[-1] > off:
        outcome.problems.append("a motion command after the servos were switched off")
    return outcome


def message_of(program):
    """The message of the fault at which it waits for Enter."""
    found = re.findall(r"somato: (.*)\n+The device has stopped", program.text())
    return found[-1] if found else ""


def disk_of(rig):
    """The files of the session. The number of explorations that are whole differs by the moment of the fault."""
    count, names = rig.explorations_on_disk()
    shown = ", ".join(f"`{name}`" for name in names)
    whole = "the explorations before it" if count else "no exploration"
    return f"{shown}: {whole}" if "hand.mcap" in names else f"{shown}, from which `recover` gives {whole}"


def stay_until_enter(rig, program, outcome):
    """Nothing moves before Enter is pressed; then the hand does, if the cause is removed."""
    before = len(rig.proxy.moves())
    time.sleep(1.0)
    if len(rig.proxy.moves()) != before:
        outcome.problems.append("it moved before Enter was pressed")
    program.press(b"\n")
    since = time.monotonic()
    try:
        rig.proxy.wait_for_move(since, 20.0)
    except TimeoutError:
        raise NotMeasured(f"it did not move after Enter: {program.text()[-400:]}") from None


def stop(rig, make, due=0.0, end=None):
    """A fault in motion: `make` makes it, and `end` removes its cause before Enter is pressed."""
    program = in_motion(rig)
    fault = rig.proxy.begin_fault(make)
    outcome = watch(rig, fault)
    outcome.due = due() if callable(due) else due
    outcome.says = message_of(program)
    if not outcome.says:
        outcome.problems.append(f"no message: {program.text()[-300:]}")
    if end:
        rig.proxy.begin_fault(end)
        stay_until_enter(rig, program, outcome)
    program.end()
    outcome.disk = disk_of(rig)
    return outcome


def pull(name):
    def make(proxy):
        getattr(proxy, name).pull()

    def end(proxy):
        getattr(proxy, name).connect()

    return lambda rig: stop(rig, make, end=end)


def silence(line, seconds):
    def measure(rig):
        def make(proxy):
            getattr(proxy, line).silent = True

        def end(proxy):
            time.sleep(max(0.0, proxy.fault + seconds - time.monotonic()))
            getattr(proxy, line).silent = False

        due = SILENCE.get(rig.bus, PERIODS) if line == "servos" else PERIODS
        return stop(rig, make, due, end)
    return measure


def drift(rig):
    """Its stop is due with the second report that shows it, because a single one may be damaged."""
    servo, scale, span = rig.servo(FINGER)
    begun = []

    def position(true, seconds):
        begun.append(true)
        return begun[0] - scale * DRIFT * seconds

    def make(proxy):
        proxy.changes = Changes(servo, position)

    def due():
        return [seconds for seconds in rig.proxy.changes.taken if DRIFT * seconds > DEVIATION * span][1]

    return stop(rig, make, due, lambda proxy: setattr(proxy, "changes", None))


def stick(rig):
    """A finger that does not leave its resting position; the fault begins with the motion."""
    servo, scale, span = rig.servo(FINGER)
    program = begin(rig)
    rests = rig.proxy.goals[servo]
    rig.proxy.begin_fault(lambda proxy: setattr(proxy, "changes", Changes(servo, lambda true, seconds: rests)))
    fault = expect_move(rig, program)
    outcome = watch(rig, fault)
    far = [sent.moment for sent in rig.proxy.sent
           if sent.moment >= fault and abs(sent.goals.get(servo, rests) - rests) > DEVIATION * span * abs(scale)]
    outcome.due = (far[0] if far else fault) - fault + UNMOVED
    outcome.says = message_of(program)
    program.end()
    outcome.disk = disk_of(rig)
    return outcome


def altered(reports, **changes):
    """A servo that reports a fault; its stop is due with so many reports."""
    def measure(rig):
        made = Changes(rig.servo(FINGER)[0], **changes)
        return stop(rig, lambda proxy: setattr(proxy, "changes", made), lambda: made.taken[reports - 1],
                    lambda proxy: setattr(proxy, "changes", None))
    return measure


def force(rig):
    """The first value of each frame is 100 N, above the limit of 60 N; the first such frame is the fault."""
    passed = []

    def change(frame):
        passed.append(time.monotonic())
        return b"10000" + frame[frame.find(b","):]

    return stop(rig, lambda proxy: setattr(proxy, "frame_change", change), lambda: passed[0] - rig.proxy.fault,
                lambda proxy: setattr(proxy, "frame_change", None))


def signalled(number):
    def measure(rig):
        program = in_motion(rig)
        fault = time.monotonic()
        program.end(number)
        outcome = watch(rig, fault, 1.0)
        saved = re.search(r"(\d+ explorations? saved in [\w.]+)", program.text())
        outcome.says = saved[1] if saved else ""
        outcome.disk = disk_of(rig)
        return outcome
    return measure


def held_up(rig):
    """Stopped for 3 s and continued, which is the fault."""
    program = in_motion(rig)
    program.send(signal.SIGSTOP)
    stopped = time.monotonic()
    time.sleep(3.0)
    moved = [moment for moment in rig.proxy.moves(stopped) if moment > stopped + 0.1]
    fault = rig.proxy.begin_fault(lambda proxy: program.send(signal.SIGCONT))
    outcome = watch(rig, fault)
    if moved:
        outcome.problems.append("it moved while it was stopped")
    outcome.says = message_of(program)
    stay_until_enter(rig, program, outcome)
    program.end()
    outcome.disk = disk_of(rig)
    return outcome


def second_program(rig):
    program = in_motion(rig)
    code, said = rig.run("explore", "--device", "hand.toml", "-o", "other.mcap")
    since = time.monotonic()
    outcome = Outcome(says=said.split("\n")[0].removeprefix("somato: "), on=True)
    try:
        rig.proxy.wait_for_move(since, 20.0)
    except TimeoutError:
        outcome.problems.append("the first program was stopped")
    if code != 1:
        outcome.problems.append(f"the second program ended with {code}")
    program.end()
    outcome.disk = disk_of(rig)
    return outcome


def moved_servos(rig):
    """Servos with several goals: the first one is where it stands."""
    goals = [servo for sent in rig.proxy.sent for servo in sent.goals]
    return {servo for servo in goals if goals.count(servo) > 1}


def refused(key_values, most_bytes=None):
    """A device file with other values of the finger, which is refused before a servo moves."""
    def measure(rig):
        text = (rig.folder / "hand.toml").read_text(encoding="utf-8")
        rig.write("hand.toml", key_values(rig, text))
        code, said = rig.run("explore", "--device", "hand.toml", "-o", "hand.mcap")
        names = sorted(path.name for path in rig.folder.glob("hand.mcap*"))
        outcome = Outcome(says=said.split("\n")[0].removeprefix("somato: "), on=rig.proxy.is_on(),
                          disk=", ".join(f"`{name}`" for name in names) or "nothing")
        if code not in (1, 2):
            outcome.problems.append(f"ended with {code}")
        if moved_servos(rig):
            outcome.problems.append("servos moved")
        if most_bytes is not None and rig.proxy.bytes_from_program > most_bytes:
            outcome.problems.append("the port was used")
        return outcome
    return measure


class Page:
    """A page of a view that is opened with its start address."""

    def __init__(self, rig):
        self.view = rig.terminal("view", "--device", "hand.toml", "-o", "hand.mcap")
        found = self.view.wait_for(r"(http://[^/\s]+)/\?token=(\w+)\s")
        self.address, self.token = found[1], found[2]
        self.view.wait_for("Press Ctrl-C")

    def command(self, command, token=None, origin=None):
        """The status of the answer."""
        headers = {"Origin": origin or self.address, "Content-Type": "application/json"}
        token = self.token if token is None else token
        request = urllib.request.Request(f"{self.address}/api/command?token={token}",
                                         json.dumps({"command": command}).encode(), headers)
        try:
            return urllib.request.urlopen(request, timeout=60).status
        except urllib.error.HTTPError as error:
            return error.code


def hostile_commands(rig):
    page = Page(rig)
    statuses = {page.command("explore", token=""), page.command("explore", token="0123456789abcdef"),
                page.command("explore", origin="http://example.org")}
    time.sleep(1.0)
    outcome = Outcome(says=f"the status {', '.join(map(str, sorted(statuses)))}", disk="nothing")
    if rig.proxy.bytes_from_program or statuses != {403}:
        outcome.problems.append("it was accepted")
    page.view.end()
    return outcome


def two_viewers(rig):
    """Both press Start at the same time; when it moves, one presses Pause, which is the event."""
    page = Page(rig)
    presses = [Thread(target=page.command, args=("explore",)) for _ in range(2)]
    for press in presses:
        press.start()
    for press in presses:
        press.join()
    rig.proxy.wait_for_move(time.monotonic())
    time.sleep(4.0 if rig.bus == "ssc32" else 1.0)  # an SSC-32 first switches its servos on
    fault = time.monotonic()
    status = page.command("pause")
    time.sleep(2.0)
    moves = rig.proxy.moves(fault)
    outcome = Outcome(moves[-1] - fault if moves else 0.0, CLOSING_STEP, on=rig.proxy.is_on(), says="the page shows a pause",
                      disk="nothing of the exploration that is ended")
    if status != 200:
        outcome.problems.append(f"Pause was answered by {status}")
    page.view.end()
    return outcome


def with_finger(text, **values):
    for key, value in values.items():
        text = with_key(text, f"servo.{FINGER}", key, value)
    return text


def shifted(rig, text):
    """As if the horn of another hand's finger were half its range away."""
    servo = rig.device["servo"][FINGER]
    return with_finger(text, zero=str(servo["zero"] + servo["scale"] * 0.5 * (servo["most"] - servo["least"])))


def reversed_limits(rig, text):
    least, most = (rig.device["servo"][FINGER][key] for key in ("least", "most"))
    return with_finger(text, least=str(most), most=str(least))


def no_number(rig, text):
    del rig
    return with_finger(text, most="nan")
