"""The files that differ from the parent branch, and what includes what in the sources."""

import subprocess
from pathlib import Path

from check_includes import includes

TREE = Path(__file__).resolve().parent.parent
FOLDERS = ("include", "src", "program", "tests", "fuzz", "bench", "python/bindings")  # of sources in C++


def git(*words):
    return subprocess.run(["git", *words], cwd=TREE, capture_output=True, text=True).stdout


def changed_files():
    """Files that differ from the merge base with the parent branch, including new files."""
    origin = next((name for name in ("origin/HEAD", "origin/main")
                   if git("rev-parse", "--verify", "--quiet", name)), "HEAD")
    base = git("merge-base", "HEAD", origin).strip() or "HEAD"
    names = git("diff", "--name-only", "-z", "--no-renames", base)
    names += git("ls-files", "-z", "--others", "--exclude-standard")
    return {TREE / name for name in names.split("\0") if name}


def included_by(path, tree=TREE):
    """The project headers that `path` includes."""
    found = set()
    for _, bracket, header in includes(path):
        for base in (tree / "include", tree / "src", path.parent, tree / "tests", tree / "program", tree):
            if bracket == '"' and (base / header).is_file():
                found.add((base / header).resolve())
                break
    return found


def sources_of(tree):
    return [path for folder in FOLDERS for ending in ("*.h", "*.cc", "*.inc") for path in (tree / folder).rglob(ending)]


def includers_by_header(tree):
    """The files that include each header directly."""
    found = {}
    for path in sources_of(tree):
        for header in included_by(path, tree):
            found.setdefault(header, set()).add(path.resolve())
    return found


def distances(start, includers):
    """The files that include one of `start`, directly or through headers, with the number of steps to it."""
    found = dict.fromkeys(start, 0)
    waiting = list(start)
    while waiting:
        path = waiting.pop(0)
        for includer in includers.get(path, ()):
            if includer not in found:
                found[includer] = found[path] + 1
                waiting.append(includer)
    return found
