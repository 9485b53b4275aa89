"""The table of rooms, src/rooms.json: wings in their order, each with its rooms in theirs.

A wing may use the wings that it names. A room may use the rooms of its wing that come before it, and all rooms
of those wings. A public header belongs to its wing, not to a room: every room of the wing may include it.
"""

import json
import sys
from dataclasses import dataclass
from pathlib import Path

TREE = Path(__file__).resolve().parent.parent

# Files of the program that are in no room.
BESIDE_ROOMS = ("program/main.cc", "program/version.h")

# The entrance headers, by the folder of public headers that opens everything they include.
ENTRANCES = {"som.h": "drawing", "recording.h": "recording", "system.h": "graph", "study.h": "studies",
             "explore.h": "simulation", "c/c_system.h": "c"}


@dataclass(frozen=True)
class Table:
    wings: dict  # name to the entry of rooms.json

    def rooms(self, wing):
        return list(self.wings[wing]["rooms"])

    @staticmethod
    def folder(wing, room=""):
        """The folder of a wing, or of one of its rooms, relative to the tree."""
        return Path("program" if wing == "program" else f"src/{wing}") / room

    def place_of(self, path):
        """(wing, room) of a file of include/somato, src or program, by its path relative to the tree. The room of a
        public header and of program/main.cc is "". None for other files, and for folders that are not rooms."""
        parts = Path(path).parts
        if parts[:2] == ("include", "somato"):
            return self.place_of_public("/".join(parts[2:]))
        if str(path) in BESIDE_ROOMS:
            return "program", ""
        parts = parts[1:] if parts[0] == "src" else parts
        is_room = len(parts) == 3 and parts[1] in self.wings.get(parts[0], {"rooms": {}})["rooms"]
        return parts[:2] if is_room else None

    def place_of_public(self, name):
        """(wing, "") of a public header by its path below include/somato; None if no wing has its folder."""
        folder = ENTRANCES.get(name, name.split("/")[0])
        return next(((wing, "") for wing, entry in self.wings.items() if folder in entry["public"]), None)

    def place_of_header(self, header):
        """(wing, room) of a header as it is included, None for a header that is not part of Somato."""
        if header.startswith("somato/"):
            return self.place_of_public(header.removeprefix("somato/"))
        return self.place_of(f"{'program' if header.count('/') == 1 else 'src'}/{header}")

    def may_use(self, place, other):
        """Whether a file of `place` may include a header of `other`."""
        (wing, room), (of_wing, of_room) = place, other
        if wing != of_wing:
            return of_wing in self.wings[wing]["uses"]
        if not room or not of_room:
            return True
        order = self.rooms(wing)
        return of_room in order[:order.index(room) + 1]


def read(tree=TREE):
    return Table(json.loads((tree / "src/rooms.json").read_text(encoding="utf-8")))


def report(check):
    """Prints the problems that `check` finds in the tree of the first argument, or in this one; the exit code."""
    problems = check(Path(sys.argv[1]) if len(sys.argv) > 1 else TREE)
    print(*problems, sep="\n", end="\n" if problems else "", file=sys.stderr)
    return 1 if problems else 0


def markdown(table):
    """The tables of wings and of rooms as ARCHITECTURE.md shows them."""
    lines = ["| wing | holds | may use | rooms, in their order |", "|---|---|---|---|"]
    for name, wing in table.wings.items():
        uses = "all" if len(wing["uses"]) == len(table.wings) - 1 else ", ".join(wing["uses"]) or "–"
        page = f"{table.folder(name).as_posix()}/README.md"
        lines.append(f"| [`{name}`]({page}) | {wing['holds']} | {uses} | {', '.join(wing['rooms'])} |")
    lines += ["", "| room | holds |", "|---|---|"]
    for name, wing in table.wings.items():
        lines += [f"| `{name}/{room}` | {entry['holds']} |" for room, entry in wing["rooms"].items()]
    return "\n".join(lines)
