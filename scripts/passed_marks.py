"""Marks of files that clang-tidy has passed, in the user's cache, so that all checkouts share them.

A mark is an empty file, named by a hash of everything that clang-tidy reads, without the path of the
checkout. Marks that were not used for a month are removed.
"""

import hashlib
import os
import time
from pathlib import Path

LONGEST_UNUSED = 30 * 24 * 3600  # seconds


def folder():
    base = os.environ.get("XDG_CACHE_HOME", "")
    # The specification of these folders ignores a relative path.
    return (Path(base) if os.path.isabs(base) else Path.home() / ".cache") / "somato/clang-tidy"


def key_of(tree, words, files):
    """A hash of `words` and of the names and contents of `files`, the same for a copy of `tree` elsewhere."""
    digest = hashlib.sha256()
    root = os.fsencode(tree)
    for part in [*(word.encode() for word in words),
                 *(os.fsencode(path) + b"\0" + path.read_bytes() for path in files)]:
        digest.update(hashlib.sha256(part.replace(root, b"TREE")).digest())
    return digest.hexdigest()


def has(key):
    """Whether there is a mark; it then counts as used now."""
    try:
        os.utime(folder() / key)
    except FileNotFoundError:
        return False
    return True


def add(key):
    folder().mkdir(parents=True, exist_ok=True)
    (folder() / key).touch()


def prune():
    oldest = time.time() - LONGEST_UNUSED
    for mark in folder().glob("*"):
        try:
            if mark.stat().st_mtime < oldest:
                mark.unlink()
        except FileNotFoundError:
            pass  # another checkout has removed it
