"""Chooses the tests that a change can reach, for ./dev test --changed.

A changed source reaches the tests of its room and those of every room with a file that includes its header,
directly or through other headers. A room is WING/ROOM, or WING for public headers, and its test WING.ROOM. The nearest come first; what exceeds LIMIT is left out, and named. What
tests reach by running the program is not followed.
"""

import re
from dataclasses import dataclass, field
from pathlib import PurePosixPath

import changed_files
import rooms
from check_mirrors import declared_in

LIMIT = 130  # processor seconds of tests beyond those of the changed rooms: 65 s on two cores
UNKNOWN = 10  # processor seconds of tests that have no figure

# Changes of these files can reach everything.
UNBOUNDED = re.compile(
    r"dev|CMakeLists\.txt|CMakePresets\.json|pyproject\.toml|cmake/.*|\.ci/.*|(?:src|program|web|python|fuzz)/CMakeLists\.txt"
    r"|tests/CMakeLists\.txt|tests/\w+/support/.*\.cc|scripts/(?:with_processor_time|setup|fetch_\w+)\.sh"
    r"|scripts/(?:packages|mujoco)\.txt|src/rooms\.json|program/version\.h\.in")
# What a changed file reaches beyond includes: the first pattern that matches. Rooms, or single tests.
REACHED = [
    (r"web/tests/parts/.*", ["web.unit", "web.types"]),
    (r"web/tests/(report|view)/.*", [r"web.\1", "web.types"]),
    (r"web/src/(report|view)/.*", ["web.unit", "web.types", r"web.\1"]),
    (r"web/schema/.*", ["views/report", "views/live", "web.unit", "web.types"]),
    (r"web/.*", ["web.*"]),
    (r"docs/notebooks/.*", ["python"]),
    (r"python/.*", ["python"]),
    (r"scripts/make_(synthetic_\w+)\.py", [r"examples.\1_reproducible"]),
    (r"examples/(synthetic_\w+)/.*", [r"examples.\1_reproducible", "recordings"]),
    (r"(?:scripts|bench)/.*\.(?:py|sh|in|txt)", ["house"]),
    (r"packaging/.*", ["house"]),
    (r"bench/guard.*", ["bench"]),
    (r"fuzz/(\w+)_fuzz\.cc", [r"fuzz.\1_replay"]),
    (r"fuzz/corpus/(\w+)/.*", [r"fuzz.\1_replay"]),
    (r"fuzz/.*", ["fuzz.*"]),
    (r"tests/install/.*|tests/\w+/support/.*", []),
    (rf"tests/({'|'.join([*rooms.read().wings, 'mcap'])})/(\w+)/.*", [r"\1/\2"]),
    (r"tests/(\w+)/.*", [r"\1"]),
    # Files that are compiled into the library, with the rooms that read them there.
    (r"(?:systems|studies)/.*", ["studies"]),
    (r"(?:objects|models)/.*", ["bodies"]),
    (r"devices/.*", ["hardware"]),
]


@dataclass
class Selection:
    changed: set = field(default_factory=set)  # rooms and tests of the changed files themselves
    near: dict = field(default_factory=dict)  # rooms that include them, with the number of steps
    documents: list = field(default_factory=list)
    unbounded: list = field(default_factory=list)  # files that can reach everything


def room_of(table, name):
    """The room, or the test, that a source in C++ belongs to; None if it has no test."""
    if place := table.place_of(name):
        return "/".join(filter(None, place))
    found = reached_by_name(name)
    return found[0] if found else None


def reached_by_name(name):
    for pattern, reached in REACHED:
        if match := re.fullmatch(pattern, name):
            return [match.expand(word) for word in reached]
    return []


def header_of(tree, name):
    """The header whose functions a source of the library or the program defines, as a list."""
    header = declared_in(tree / name) if (tree / name).is_file() else None
    named = [tree / folder / header for folder in ("include", "src", "program") if header]
    return [path.resolve() for path in named if path.is_file()]


def starts(tree, name):
    """The file itself and the headers of its functions."""
    return [(tree / name).resolve(), *(header_of(tree, name) if name.startswith(("src/", "program/")) and name.endswith(".cc") else [])]


def is_document(name):
    return name == "README.md" or (name.startswith("docs/") and name.endswith(".md"))


def select(tree, names):
    """What the changed files `names`, relative to `tree`, reach."""
    table = rooms.read(tree)
    chosen = Selection(unbounded=[name for name in names if UNBOUNDED.fullmatch(name)])
    chosen.documents = [name for name in names if is_document(name) and (tree / name).is_file()]
    sources = [name for name in names if name.endswith((".h", ".cc", ".inc"))]
    for name in names:
        chosen.changed.update(filter(None, [room_of(table, name)] if name in sources else reached_by_name(name)))
    includers = changed_files.includers_by_header(tree) if sources else {}
    reached = changed_files.distances([path for name in sources for path in starts(tree, name)], includers)
    for path, steps in reached.items():
        room = room_of(table, path.relative_to(tree.resolve()).as_posix())
        if room and room not in chosen.changed:
            chosen.near[room] = min(steps, chosen.near.get(room, steps))
    return chosen


def matches(item, test):
    """Whether a wing, a room or a test, `item`, includes the test of ctest."""
    name = item.replace("/", ".")
    return test.startswith(f"{name}.") or bool(re.fullmatch(re.escape(name).replace(r"\*", ".*"), test))


def within_limit(chosen, tests, seconds_of):
    """Tests to run, and tests that the change can reach but that are left out. `seconds_of` gives the processor
    seconds of a test, or None."""
    run = [test for test in tests if any(matches(item, test) for item in chosen.changed)]
    left, spent = [], 0
    nearest = sorted(chosen.near, key=lambda item: (chosen.near[item], item))
    for item in nearest:
        new = [test for test in tests if matches(item, test) and test not in run]
        cost = sum(UNKNOWN if seconds_of(test) is None else seconds_of(test) for test in new)
        fits = spent + cost <= LIMIT
        (run if fits else left).extend(new)
        spent += cost if fits else 0
    return run, left
