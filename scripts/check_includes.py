#!/usr/bin/env python3
"""Reports includes that violate the table of rooms (src/rooms.json), expose third-party headers or use private ones.

usage: check_includes.py [TREE]
"""

import re
import sys

import rooms

# Headers of others that a public header may bring in, by the header that may.
GUESTS = {"core/result.h": ["tl/expected.hpp"], "c/c_system.h": ["stddef.h"]}

# Headers that the build makes.
GENERATED = {"version.h"}

# Rooms of hardware in which servos are driven: a period takes no lock. Files that only prepare a device may.
LOCKS = {"mutex", "shared_mutex", "condition_variable", "semaphore", "future", "thread", "latch",
         "barrier", "pthread.h", "semaphore.h"}
WITHOUT_LOCKS = {"lines", "protocols", "buses", "device_files", "devices"}
MAY_LOCK = {"src/hardware/lines/sound_source.cc"}

# Folders of headers that other projects keep to themselves: the next version may not have them.
PRIVATE = {"impl", "detail", "details", "internal", "priv", "private"}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def includes(path):
    """The (line, bracket, header) of every include of a file."""
    text = path.read_text(encoding="utf-8")
    return [(text.count("\n", 0, m.start(2)) + 1, m[1], m[2]) for m in INCLUDE.finditer(text)]


def breaks_table(table, place, header):
    other = table.place_of_header(header)
    if other is None or table.may_use(place, other):
        return None
    same_wing = place[0] == other[0]
    seen, from_here = ("/".join(other), "/".join(place)) if same_wing else (other[0], place[0])
    return f"'{from_here}' may not include '{seen}' ({header})"


def has_no_place(table, bracket, header):
    """Quoted headers are those of rooms, or generated."""
    if bracket != '"' or header in GENERATED or table.place_of_header(header) is not None:
        return None
    return f"'{header}' is not the path of a header of a room"


def breaks_public_rule(public_name, bracket, header):
    is_standard = bracket == "<" and re.fullmatch(r"[a-z0-9_]+", header)
    is_ours = bracket == '"' and header.startswith("somato/")
    if is_standard or is_ours or header in GUESTS.get(public_name, []):
        return None
    return f"a public header may not bring in {header}"


def is_private(bracket, header):
    if bracket != "<" or PRIVATE.isdisjoint(header.split("/")[:-1]):
        return None
    return f"{header} is a private header of another project"


def may_lock(place, where, header):
    if header not in LOCKS or place[0] != "hardware" or place[1] not in WITHOUT_LOCKS or where.as_posix() in MAY_LOCK:
        return None
    return f"'{'/'.join(place)}' takes no locks ({header})"


def not_reached(public):
    """The public headers that no entrance includes, directly or through others; sorted."""
    missing = {path.relative_to(public).as_posix() for path in public.rglob("*.h")}
    waiting = [name for name in rooms.ENTRANCES if name in missing]
    while waiting:
        name = waiting.pop()
        if name not in missing:
            continue
        missing.remove(name)
        waiting += [header.removeprefix("somato/") for _, _, header in includes(public / name)]
    return sorted(missing)


def sources(tree):
    """Every file below include/somato, src and program."""
    for base in (tree / "include/somato", tree / "src", tree / "program"):
        yield from sorted([*base.rglob("*.h"), *base.rglob("*.cc")])


def check(tree):
    """Violations as `file:line: message`."""
    problems = []
    table = rooms.read(tree)
    public = tree / "include/somato"
    for path in sources(tree):
        where = path.relative_to(tree)
        place = table.place_of(where)
        if place is None:
            problems.append(f"{where}:1: '{where.parent}' is not a room of src/rooms.json")
            continue
        for line, bracket, header in includes(path):
            found = [has_no_place(table, bracket, header), breaks_table(table, place, header),
                     may_lock(place, where, header), is_private(bracket, header)]
            if public in path.parents:
                name = path.relative_to(public).as_posix()
                found.append(breaks_public_rule(name, bracket, header))
            problems += [f"{where}:{line}: {message}" for message in found if message]
    problems += [f"include/somato/{name}:1: no entrance header includes it; move it to src"
                 for name in not_reached(public)]
    return problems


if __name__ == "__main__":
    sys.exit(rooms.report(check))
