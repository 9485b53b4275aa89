#!/usr/bin/env python3
"""Reports includes that violate the table of rooms (ARCHITECTURE.md) or expose third-party headers.

usage: check_includes.py [TREE]
"""

import re
import sys
from pathlib import Path

# Which rooms a room may look at, itself and what those may use included.
DIRECT = {
    "kernels": [],
    "core": ["kernels"],
    "files": ["core"],
    "codes": ["files"],
    "maps": ["files"],
    "ros": ["files"],
    "recording": ["ros"],
    "bags": ["recording"],
    "exports": ["bodies"],
    "drawing": ["maps"],
    "graph": ["codes", "maps", "recording"],
    "bodies": ["recording"],
    "simulation": ["bodies"],
    "wire": ["core"],
    "devices": ["bodies", "wire"],
    "emulation": ["devices"],
    "topics": ["bodies"],
    "mpi": ["core"],
    "studies": ["graph", "drawing"],
    "suggestion": ["studies"],
    "report": ["studies"],
    "live": ["graph", "bodies"],
    "program": ["bags", "exports", "suggestion", "report", "live", "simulation", "devices", "emulation", "topics", "mpi"],
}

# The entrance headers, by the room whose table applies to them. A header that they do not include, directly or
# through others, is not public.
ENTRANCES = {"som.h": "drawing", "recording.h": "recording", "system.h": "graph", "study.h": "studies",
             "explore.h": "simulation"}

# Headers of others that a public header may bring in, by the header that may.
GUESTS = {"core/result.h": ["tl/expected.hpp"]}

# Rooms in which servos are driven: a period takes no lock. Files that only prepare a device may.
LOCKS = {"mutex", "shared_mutex", "condition_variable", "semaphore", "future", "thread", "latch",
         "barrier", "pthread.h", "semaphore.h"}
WITHOUT_LOCKS = {"wire": {"src/wire/sound_source.cc"}, "devices": set()}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def rooms_seen_from(room):
    seen = {room}
    for other in DIRECT[room]:
        seen |= rooms_seen_from(other)
    return seen


def includes(path):
    """The (line, bracket, header) of every include of a file."""
    text = path.read_text(encoding="utf-8")
    return [(text.count("\n", 0, m.start(2)) + 1, m[1], m[2]) for m in INCLUDE.finditer(text)]


def room_of_header(header):
    """The room of a header, or None if it is not part of Somato."""
    parts = header.removeprefix("somato/").split("/")
    return parts[0] if len(parts) > 1 and parts[0] in DIRECT else None


def breaks_table(room, header):
    other = room_of_header(header)
    if other is None or other in rooms_seen_from(room):
        return None
    return f"'{room}' may not look at '{other}' ({header})"


def breaks_public_rule(public_name, bracket, header):
    is_standard = bracket == "<" and re.fullmatch(r"[a-z0-9_]+", header)
    is_ours = bracket == '"' and header.startswith("somato/")
    if is_standard or is_ours or header in GUESTS.get(public_name, []):
        return None
    return f"a public header may not bring in {header}"


def may_lock(room, where, header):
    if header not in LOCKS or where.as_posix() in WITHOUT_LOCKS.get(room, {where.as_posix()}):
        return None
    return f"'{room}' takes no locks ({header})"


def not_reached(public):
    """The public headers that no entrance includes, directly or through others; sorted."""
    missing = {path.relative_to(public).as_posix() for path in public.rglob("*.h")}
    waiting = [name for name in ENTRANCES if name in missing]
    while waiting:
        name = waiting.pop()
        if name not in missing:
            continue
        missing.remove(name)
        waiting += [header.removeprefix("somato/") for _, _, header in includes(public / name)]
    return sorted(missing)


def files_of_rooms(tree):
    """Every (room, file) below include/somato, src and program."""
    for base in (tree / "include/somato", tree / "src", tree / "program"):
        for path in sorted([*base.rglob("*.h"), *base.rglob("*.cc")]):
            parts = path.relative_to(base).parts
            room = "program" if base.name == "program" else ENTRANCES.get(parts[0], parts[0])
            yield room, path


def check(tree):
    """Violations as `file:line: message`."""
    problems = []
    public = tree / "include/somato"
    for room, path in files_of_rooms(tree):
        where = path.relative_to(tree)
        if room not in DIRECT:
            problems.append(f"{where}:1: '{room}' is not a room of the table")
            continue
        for line, bracket, header in includes(path):
            found = [breaks_table(room, header), may_lock(room, where, header)]
            if public in path.parents:
                name = path.relative_to(public).as_posix()
                found.append(breaks_public_rule(name, bracket, header))
            problems += [f"{where}:{line}: {message}" for message in found if message]
    problems += [f"include/somato/{name}:1: no entrance header includes it; move it to src"
                 for name in not_reached(public)]
    return problems


def main():
    tree = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent
    problems = check(tree)
    print(*problems, sep="\n", end="\n" if problems else "", file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
