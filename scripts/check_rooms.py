#!/usr/bin/env python3
"""Reports rooms that are too large or too small, wings with too many rooms or without a README.md, and folders that
src/rooms.json does not name; notes small units with one user.

usage: check_rooms.py [TREE]
"""

import re
import sys
from pathlib import Path

import rooms
from check_includes import includes

MOST_FILES = 26
FEWEST_FILES = 4
MOST_ROOMS = 10
LONGEST_README = 60  # lines
SMALL_UNIT = 40  # lines of a header and its source
ADVICE = "split it, or move files to a neighbour (CONTRIBUTING.md)"

# Folders of files that are not rooms, each with its reason.
ROOMS_OF_TESTS = {
    "golden": "files of earlier versions", "house": "tests of the checks", "install": "users of the installed package", "mcap": "another implementation",
    "peers": "the makers' own libraries", "python": "the Python package", "same_bits": "bits of every build",
    "web": "tests of the pages, which are in web/tests",
}
OTHER_TESTS = {"support", "hostile"}  # beside the rooms of a wing

# Folders of code that are not rooms, and those of them that may be larger, each with its reason.
OTHER_FOLDERS = ("bench", "fuzz", "python", "scripts", "tests/house", "tests/peers", "tests/python", "web/src", "web/tests")
LARGE_FOLDERS = {
    "bench": "benchmarks, one file each, with the programs that run and compare them",
    "bench/peers": "one program for each other package and task",
    "scripts": "./dev, the workflows and the documentation name each script by its path",
    "tests/house": "one file of tests for each of these scripts",
}


def files_in(folder):
    return [path for path in folder.iterdir() if path.is_file()]


def crowded(folder, name):
    count = len(files_in(folder)) if folder.is_dir() else 0
    return [f"{name}: {count} files; at most {MOST_FILES}: {ADVICE}"] if count > MOST_FILES else []


def check_sizes(tree, table):
    for wing, entry in table.wings.items():
        if len(entry["rooms"]) > MOST_ROOMS:
            yield f"{wing}: {len(entry['rooms'])} rooms; at most {MOST_ROOMS}: {ADVICE}"
        for room, about in entry["rooms"].items():
            folder = tree / table.folder(wing, room)
            yield from crowded(folder, f"{wing}/{room}")
            count = len(files_in(folder)) if folder.is_dir() else 0
            if count < FEWEST_FILES and "small" not in about:
                yield f"{wing}/{room}: {count} files; at least {FEWEST_FILES}: join it with its neighbour"


def check_folders(tree, table):
    """Folders without a row in the table, and rows without a name."""
    for wing, entry in table.wings.items():
        folder = tree / table.folder(wing)
        found = {path.name for path in folder.iterdir() if path.is_dir()} if folder.is_dir() else set()
        yield from (f"{wing}/{name}: not a room of src/rooms.json" for name in sorted(found - set(entry["rooms"])))
        yield from (f"{wing}/{room}: src/rooms.json does not say what it holds"
                    for room, about in entry["rooms"].items() if not about.get("holds"))
    known = {*table.wings} - {"program"}
    yield from (f"src/{path.name}: not a wing of src/rooms.json" for path in sorted((tree / "src").iterdir())
                if path.is_dir() and path.name not in known)


def check_readmes(tree, table):
    for wing in table.wings:
        page = tree / table.folder(wing) / "README.md"
        if not page.is_file():
            yield f"{wing}: no README.md, which says what comes in, what goes out and how to add the usual thing"
            continue
        text = page.read_text(encoding="utf-8")
        if (length := text.count("\n")) > LONGEST_README:
            yield f"{wing}/README.md: {length} lines; at most {LONGEST_README}"
        missing = [room for room in table.rooms(wing) if f"`{room}`" not in text]
        if missing:
            yield f"{wing}/README.md: does not name the rooms {', '.join(missing)}"


def check_tests(tree, table):
    for wing in sorted(path for path in (tree / "tests").iterdir() if path.is_dir()):
        if wing.name in ROOMS_OF_TESTS:
            continue
        if wing.name not in table.wings:
            yield f"tests/{wing.name}: not a wing of src/rooms.json"
            continue
        for folder in (path for path in wing.iterdir() if path.is_dir() and path.name != "__pycache__"):
            if folder.name not in {*table.rooms(wing.name), *OTHER_TESTS}:
                yield f"tests/{wing.name}/{folder.name}: not a room of src/rooms.json"
            yield from crowded(folder, f"tests/{wing.name}/{folder.name}")


def check_places_of_tests(tree, table):
    """Tests that are not in tests/WING/ROOM, where they would not be compiled."""
    for wing in table.wings:
        folder = tree / "tests" / wing
        for path in sorted(folder.rglob("*_test.cc")) if folder.is_dir() else []:
            parts = path.relative_to(folder).parts
            if len(parts) != 2:
                yield f"{path.relative_to(tree)}: a test belongs to tests/{wing}/ROOM"


def check_programs_of_tests(tree, table):
    """Wings whose tests no program runs."""
    listed = (tree / "tests/CMakeLists.txt").read_text(encoding="utf-8")
    yield from (f"tests/CMakeLists.txt: no line somato_wing_tests({wing} ...)" for wing in table.wings
                if not re.search(rf"^somato_wing_tests\({wing}\b", listed, re.MULTILINE))


def check_other_folders(tree):
    folders = (path for top in OTHER_FOLDERS for path in (tree / top, *(tree / top).rglob("*"))
               if path.is_dir() and path.name != "__pycache__")
    for folder in folders:
        name = folder.relative_to(tree).as_posix()
        problems = crowded(folder, name)
        if name not in LARGE_FOLDERS:
            yield from problems
        elif not problems:
            yield f"{name}: at most {MOST_FILES} files; remove it from LARGE_FOLDERS of check_rooms.py"


def small_units(tree):
    """Units below SMALL_UNIT lines whose header one other file includes."""
    users, lengths = {}, {}
    for base, path in ((base, path) for base in ("src", "program") for path in sorted((tree / base).rglob("*.[hc]*"))):
        if path.suffix not in (".h", ".cc"):
            continue
        name = path.relative_to(tree / base).with_suffix("").as_posix()
        lengths[name] = lengths.get(name, 0) + path.read_text(encoding="utf-8").count("\n")
        for _, _, header in includes(path):
            if header.removesuffix(".h") != name:
                users.setdefault(header, set()).add(name)
    for name, length in sorted(lengths.items()):
        if length < SMALL_UNIT and len(of_unit := users.get(f"{name}.h", set())) == 1:
            yield f"note: {name} has {length} lines and one user, {of_unit.pop()}"


def check(tree):
    table = rooms.read(tree)
    problems = [*check_sizes(tree, table), *check_folders(tree, table), *check_readmes(tree, table),
                *check_tests(tree, table), *check_places_of_tests(tree, table), *check_programs_of_tests(tree, table),
                *check_other_folders(tree)]
    shown = (tree / "ARCHITECTURE.md").read_text(encoding="utf-8")
    if rooms.markdown(table) not in shown:
        problems.append("ARCHITECTURE.md: its tables are not those of src/rooms.json; run scripts/check_rooms.py --fix")
    return problems


def fix(tree):
    page = tree / "ARCHITECTURE.md"
    text = page.read_text(encoding="utf-8")
    tables = re.compile(r"^\| wing \|.*?\n\n\| room \|.*?(?=\n\n)", re.MULTILINE | re.DOTALL)
    page.write_text(tables.sub(lambda _: rooms.markdown(rooms.read(tree)), text, count=1), encoding="utf-8")


def main():
    trees = [Path(word) for word in sys.argv[1:] if word != "--fix"]
    tree = trees[0] if trees else rooms.TREE
    if "--fix" in sys.argv[1:]:
        fix(tree)
    for note in small_units(tree):
        print(note)
    problems = check(tree)
    print(*problems, sep="\n", end="\n" if problems else "", file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
