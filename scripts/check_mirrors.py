#!/usr/bin/env python3
"""Reports headers, sources and tests that do not mirror each other (STYLE.md).

A source begins with the header that declares what it defines: the one of its own name, or, where several sources
define the functions of one header, that one. A public header has a test in a room of its wing; a test has the name
of a header that its room or its wing has, or of one and its subject.

usage: check_mirrors.py [TREE]
"""

import sys

import rooms
from check_includes import includes

TESTS_OF_SUPPORT = "support"


def declared_in(path):
    """The first header of Somato that a source includes, or None."""
    return next((header for _, bracket, header in includes(path) if bracket == '"'), None)


def private_headers(tree):
    """(wing, room, name) of every private header."""
    found = set()
    for path in (tree / "src").rglob("*.h"):
        found.add((*path.relative_to(tree / "src").parts[:2], path.stem))
    return found


def public_headers(tree, table):
    """(wing, name) of every public header, with its path."""
    public = tree / "include/somato"
    return {(table.place_of(path.relative_to(tree))[0], path.stem): path.relative_to(tree)
            for path in public.rglob("*.h") if len(path.relative_to(public).parts) > 1}


def check_sources(tree, table, private, public):
    for path in sorted((tree / "src").rglob("*.cc")):
        where = path.relative_to(tree)
        wing, room = table.place_of(where) or ("", "")
        if (wing, room, path.stem) in private or (wing, path.stem) in public:
            continue
        header = declared_in(path)
        if header is None or (table.place_of_header(header) or ("",))[0] != wing:
            yield f"{where}: no header of its name, and its first include is not a header of '{wing}'"


def tests_of(tree, wing):
    """(room, name) of every test of a wing."""
    return {(path.parent.name, path.stem.removesuffix("_test")) for path in (tree / "tests" / wing).rglob("*_test.cc")}


def names_a_header(name, headers):
    """Whether `name` is a header, or one and its subject: THING_WORD for tests of a large THING."""
    return name in headers or name.rpartition("_")[0] in headers


def check_tests(tree, wing, private, public):
    of_wing = {name for other, name in public if other == wing}
    for room, name in sorted(tests_of(tree, wing)):
        own = {header for other, place, header in private if (other, place) == (wing, room)}
        if room == TESTS_OF_SUPPORT:
            own = {path.stem for path in (tree / "tests" / wing / room).glob("*.h")}
        if not names_a_header(name, own | of_wing):
            yield f"tests/{wing}/{room}/{name}_test.cc: no header of that name"


def check(tree):
    table = rooms.read(tree)
    private, public = private_headers(tree), public_headers(tree, table)
    problems = list(check_sources(tree, table, private, public))
    sources = {(table.place_of(path.relative_to(tree)) or ("",))[0:1] + (path.stem,)
               for path in (tree / "src").rglob("*.cc")}
    for (wing, name), header in sorted(public.items()):
        if (wing, name) in sources and name not in {test for _, test in tests_of(tree, wing)}:
            problems.append(f"{header}: no tests/{wing}/ROOM/{name}_test.cc")
    for wing in table.wings:
        if wing != "program":
            problems += check_tests(tree, wing, private, public)
    return problems


if __name__ == "__main__":
    sys.exit(rooms.report(check))
