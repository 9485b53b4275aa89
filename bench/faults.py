#!/usr/bin/env python3
"""Measures what a hand does in each fault, in real time, and writes the table of docs/your-hand.md.

usage: bench/faults.py [--bus BUS]... [--only TEXT] [--update] [--priority N]

The program emulates a hand at each bus; a proxy between it and the program that explores logs every byte, and makes
the faults. Results are kept in build/faults.json, so that a table can be measured in parts; --update writes the kept
table into the page. --priority N runs programs and proxy with that real-time priority, which makes a machine that
others use as good as idle; the rows beside busy processes are measured without it.

The outcome of each row has tests that do not depend on the speed of the machine: tests/house/faults_test.py checks
that they exist.
"""

import argparse
import contextlib
import json
import os
import re
import signal
import sys
import tempfile
import traceback
from dataclasses import asdict
from pathlib import Path

from fault_rig import TREE, Rig, busy_processes, use_as_proxy
from fault_rows import (MEASURING, NotMeasured, Outcome, Row, altered, drift, force, held_up, hostile_commands, no_number, pull,
                        refused, reversed_limits, second_program, shifted, signalled, silence, stick, two_viewers)

BUSES = ("ssc32", *MEASURING)
PAGE = TREE / "docs/your-hand.md"
BEGIN, END = "<!-- made by bench/faults.py -->", "<!-- end -->"
KEPT = TREE / "build/faults.json"
IDLE, BUSY = 0.05, 0.2  # s after which a stop is late
ATTEMPTS = 4

ROWS = (
    Row("the servos' cable is pulled in motion, and put back", pull("servos"),
        ("DeviceFaults.AHangUpInAMovementIsNoticedWithin100Milliseconds",
         "DeviceExplorerTest.ACableThatIsPutBackMovesNothing")),
    Row("the sensors' cable is pulled in motion, and put back", pull("frames"),
        ("DeviceFaults.SensorsThatHangUpStopTheBodyWhichHoldsAndRelaxes",
         "SerialLines.WaitsBesideALineThatHasHungUp", "ServoFaults.AStoppedHandHoldsWithOneCommandInAPeriod")),
    Row("the controller is silent for 1 s", silence("servos", 1.0),
        ("DeviceFaults.SilenceIsNoticedAfterThreeMissedPolls",
         "ServoFaultsOfScs.SilenceIsNoticedAsSoonForManyServosAsForFew",
         "DeviceFaults.NothingMovesWhileAStoppedHandHolds")),
    Row("the controller is silent for 5 s", silence("servos", 5.0),
        ("DeviceFaults.SilenceIsNoticedAfterThreeMissedPolls",)),
    Row("the sensors' frames stop, the servos answer", silence("frames", 3.0),
        ("SensorFaults.SilenceForThreePeriodsStopsTheBody", "Device.EmulatesTheTimeThatIsAskedFor")),
    Row("a servo sticks", stick, ("ServoFaults.AServoThatIsStuckStopsTheBody", "ServoWatch.AServoThatNeverMovesIsStuck"),
        MEASURING),
    Row("a servo drifts away at 176 deg/s", drift,
        ("ServoFaults.AServoThatDriftsAwayIsSwitchedOff",
         "ServoWatch.AServoThatDriftsAwayIsStoppedWithin50MillisecondsOfItsDeviation"), MEASURING),
    Row("a servo reports an overload", altered(1, overload=True),
        ("DeviceFaults.AnOverloadStopsTheBodyUntilAReboot",), MEASURING),
    Row("a servo reports 130 degrees Celsius", altered(3, temperature=130),
        ("ServoFaults.AHotServoStopsTheBody",), MEASURING),
    Row("a force above the limit", force, ("DeviceBody.HoldsAndRelaxesWhenTheForceIsTooLarge",),
        body="lucs2", frames="lines"),
    Row("a force above the limit, beside four busy processes", force,
        ("DeviceBody.HoldsAndRelaxesWhenTheForceIsTooLarge",), body="lucs2", frames="lines", busy=4),
    Row("SIGINT (Ctrl-C) in a grasp", signalled(signal.SIGINT),
        ("Device.IsSwitchedOffBySignals", "DeviceBody.IsRelaxedAtOnceWhenItIsInterrupted",
         "ServoFaults.AStartThatIsInterruptedSwitchesThemOffAtOnce")),
    Row("SIGTERM (`kill`) in a grasp", signalled(signal.SIGTERM), ("Device.IsSwitchedOffBySignals",)),
    Row("SIGHUP (a closed terminal) in a grasp", signalled(signal.SIGHUP),
        ("Device.IsSwitchedOffBySignals", "SavedSession.IsWholeAfterASignalThatAsksToEnd")),
    Row("SIGKILL (`kill -9`) in a grasp", signalled(signal.SIGKILL), ("SavedSession.IsRecoveredAfterItWasKilled",)),
    Row("the program is stopped for 3 s (Ctrl-Z) and continued", held_up,
        ("ServoFaults.AProgramThatIsHeldUpStopsTheBody",)),
    Row("a second program uses the port", second_program, ("SerialPort.BelongsToOneAtATime",)),
    Row("the calibration is that of another hand", refused(shifted),
        ("ServoFaults.ACalibrationOfAnotherHandIsRefusedAndMovesNothing",), MEASURING),
    Row("limits in the device file are reversed", refused(reversed_limits, 0),
        ("DeviceFile.RefusesMistakesWithTheirLine",)),
    Row("a limit in the device file is not a number", refused(no_number, 0), ("DeviceFile.RefusesLimitsThatAreNoNumbers",)),
    Row("two viewers press Start at once; one presses Pause", two_viewers,
        ("MotionThread.TwoViewersThatStartAtOnceMoveOneBody", "MotionThread.APauseHoldsABodyUntilACommand",
         "MotionThread.APressOfStartBeforeTheFaultIsShownPermitsNothing")),
    Row("Start without the page's token, or from another page", hostile_commands, ("Motion.AViewThatIsOpenedMovesNothing", "ServerThread.RefusesEachHostileRequestWhileAGoodOneGetsFrames")),
)


def measure(row, bus, arguments):
    priority = 0 if row.busy else arguments.priority
    with tempfile.TemporaryDirectory() as folder, contextlib.ExitStack() as around:
        if row.busy:
            around.enter_context(busy_processes(row.busy))
        rig = around.enter_context(Rig(arguments.program, folder, bus, row.body, row.frames, priority))
        outcome = row.measure(rig)
        outcome.says = outcome.says.replace(f"{folder}/", "")
    late = BUSY if row.busy else IDLE
    if outcome.last is not None and outcome.last - outcome.due > late:
        outcome.problems.append(f"the stop was {1000 * (outcome.last - outcome.due):.0f} ms late")
    return outcome


def attempt(row, bus, arguments):
    """Tried again only if the hand stops before the fault is made, or for another fault after Enter."""
    reasons = []
    for _ in range(ATTEMPTS):
        try:
            return measure(row, bus, arguments)
        except (NotMeasured, TimeoutError, IndexError) as error:
            reasons.append(str(error) or traceback.format_exc(limit=-2))
    return Outcome(problems=[f"not measured: {reasons[-1]}"])


def milliseconds(outcome):
    if outcome["last"] is None:
        return "no motion" if not outcome["problems"] else "-"
    due = f" ({1000 * outcome['due']:.0f})" if outcome["due"] > 0.0005 else ""
    return f"{1000 * outcome['last']:.0f}{due}"


def hand_then(outcome):
    if outcome["last"] is None:
        return "on, moves on" if outcome["on"] else "off or as before"
    if outcome["off"] is None:
        return "on, holds" if outcome["on"] else "off"
    held = outcome["off"] - outcome["last"]
    return "off at once" if held < 0.1 else f"holds {held:.1f} s, then off"


def each_once(texts):
    """The texts, or those of buses that differ."""
    kinds = {}
    for bus, text in texts.items():
        kinds.setdefault(re.sub(r"\d+(\.\d+)?", "0", text), (text, []))[1].append(bus)
    if len(kinds) == 1:
        return next(iter(kinds.values()))[0]
    return "; ".join(f"{', '.join(buses)}: {text}" for text, buses in kinds.values())


def row_text(row, outcomes):
    found = {bus: outcomes[bus] for bus in row.buses if bus in outcomes}
    cells = [milliseconds(found[bus]) if bus in found else "-" for bus in BUSES]
    first = found.get("sts") or next(iter(found.values()))
    said = first["says"].replace("|", "\\|")
    hand = each_once({bus: hand_then(one) for bus, one in found.items()})
    return f"| {row.fault} | {' | '.join(cells)} | {hand} | {said or 'nothing'} | {first['disk']} |"


def table(kept):
    lines = [f"| fault | {' | '.join(BUSES)} | the hand then | a person reads | on disk |",
             "|---|" + "---|" * (len(BUSES) + 3)]
    return "\n".join(lines + [row_text(row, kept["rows"][row.fault]) for row in ROWS if row.fault in kept["rows"]])


def update_page(kept):
    before, rest = PAGE.read_text(encoding="utf-8").split(BEGIN)
    text = f"{BEGIN}\n\nMeasured {kept['where']}.\n\n{table(kept)}\n\n{END}"
    PAGE.write_text(before + text + rest.split(END, 1)[1], encoding="utf-8")


def where(arguments):
    priority = f", real-time priority {arguments.priority}" if arguments.priority else ""
    return f"on {os.cpu_count()} cores with a load of {os.getloadavg()[0]:.1f} by other programs{priority}"


def parse():
    parser = argparse.ArgumentParser(prog="./dev bench --faults", description=__doc__.split("\n")[0])
    parser.add_argument("--program", default=TREE / "build/bench/somato", type=Path)
    parser.add_argument("--bus", action="append", choices=BUSES)
    parser.add_argument("--only", default="", help="rows whose fault contains this text")
    parser.add_argument("--priority", type=int, default=0)
    parser.add_argument("--update", action="store_true", help="write the kept table into docs/your-hand.md")
    return parser.parse_args()


def measure_all(arguments, kept):
    """The number of outcomes with problems; keeps each outcome when it is measured."""
    problems = 0
    for row in [row for row in ROWS if arguments.only in row.fault]:
        for bus in [bus for bus in row.buses if bus in (arguments.bus or BUSES)]:
            outcome = attempt(row, bus, arguments)
            kept["rows"].setdefault(row.fault, {})[bus] = asdict(outcome)
            problems += bool(outcome.problems)
            said = "; ".join(outcome.problems) or "as promised"
            print(f"{bus}: {row.fault}: {milliseconds(asdict(outcome))} ms; {hand_then(asdict(outcome))}; {said}", flush=True)
            KEPT.write_text(json.dumps(kept, indent=1), encoding="utf-8")
    return problems


def main():
    arguments = parse()
    arguments.program = arguments.program.resolve()
    kept = json.loads(KEPT.read_text(encoding="utf-8")) if KEPT.is_file() else {"rows": {}}
    if arguments.update and not (arguments.bus or arguments.only):
        update_page(kept)
        return 0
    kept["where"] = where(arguments)
    use_as_proxy(arguments.priority)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # the programs that it has started end as well
    problems = measure_all(arguments, kept)
    if arguments.update:
        update_page(kept)
    print(f"{problems} outcomes differ from what is promised")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
