#!/usr/bin/env python3
"""Runs clang-tidy 19 over the library, the program and the fuzzers, in parallel.

A file that passed is not looked at again until it, a header of ours that it reaches, its compile
command or the rules change.

usage: run_clang_tidy.py [--fix]
"""

import hashlib
import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from check_includes import includes

TREE = Path(__file__).resolve().parent.parent
BUILD = TREE / "build/dev"
STAMPS = TREE / "build/lint"
CHECKED = ("src", "program", "fuzz")
TIDY = "clang-tidy-19"


def entries():
    """The compile commands of the files to check, by file."""
    commands = json.loads((BUILD / "compile_commands.json").read_text(encoding="utf-8"))
    found = {Path(entry["file"]): entry["command"] for entry in commands}
    return {file: command for file, command in found.items()
            if file.is_relative_to(TREE) and file.relative_to(TREE).parts[0] in CHECKED}


def reached(path, known):
    """`path` and the headers of ours that it includes, directly or not."""
    if path in known:
        return
    known.add(path)
    for _, bracket, header in includes(path):
        for base in (TREE / "include", TREE / "src", path.parent):
            if bracket == '"' and (base / header).is_file():
                reached((base / header).resolve(), known)


def key_of(file, command):
    known = set()
    reached(file, known)
    digest = hashlib.sha256(command.encode())
    for path in [TREE / ".clang-tidy", *sorted(known)]:
        digest.update(path.read_bytes())
    return digest.hexdigest()


def check(file, command, fix):
    """Whether `file` passes."""
    stamp = STAMPS / ("_".join(file.relative_to(TREE).parts) + ".ok")
    key = key_of(file, command)
    if stamp.is_file() and stamp.read_text(encoding="utf-8") == key:
        return True
    options = ["--fix", "--fix-errors"] if fix else []
    done = subprocess.run([TIDY, "-p", str(BUILD), "--quiet", *options, str(file)],
                          capture_output=True, text=True)
    if done.returncode != 0:
        print(done.stdout, done.stderr, sep="", end="", file=sys.stderr)
        return False
    stamp.write_text(key, encoding="utf-8")
    return True


def main():
    fix = sys.argv[1:] == ["--fix"]
    STAMPS.mkdir(parents=True, exist_ok=True)
    files = entries()
    # Two at once would write the same header's fixes twice.
    with ThreadPoolExecutor(1 if fix else os.cpu_count()) as pool:
        passed = list(pool.map(lambda item: check(*item, fix), sorted(files.items())))
    return 0 if all(passed) else 1


if __name__ == "__main__":
    sys.exit(main())
