#!/usr/bin/env python3
"""Refuses headers, sources and tests that do not mirror each other (STYLE.md).

usage: check_mirrors.py [TREE]
"""

import sys
from pathlib import Path

from check_includes import DIRECT

ROOMS = [room for room in DIRECT if room != "program"]

# Files without a mirror, each with its reason.
SOURCES_WITHOUT_HEADER = {
    "core/kernels_portable.cc": "core/kernels.h for any processor",
    "core/kernels_avx2.cc": "core/kernels.h for AVX2",
    "core/kernels_avx512.cc": "core/kernels.h for AVX-512",
    "core/kernels_avx512_vnni.cc": "core/batch_kernels.h for AVX-512 with integer products",
    "graph/module_types.cc": "graph/module.h: the list of all types",
    "graph/modules/codes.cc": "graph/modules/support.h: types of modules",
    "graph/modules/features.cc": "graph/modules/support.h: types of modules",
    "graph/modules/frames.cc": "graph/modules/support.h: types of modules",
    "graph/modules/maps.cc": "graph/modules/support.h: types of modules",
    "graph/modules/memories.cc": "graph/modules/support.h: types of modules",
    "graph/modules/scaling.cc": "graph/modules/support.h: types of modules",
    "graph/modules/source.cc": "graph/modules/support.h: types of modules",
}
HEADERS_WITHOUT_TEST = {}
TESTS_WITHOUT_HEADER = {
    "core/no_malloc_test.cc": "support/no_malloc.h, which the tests of all rooms use",
}


def stems(folder, pattern, ending):
    """ROOM/name for every file of the rooms below `folder`."""
    found = set()
    for room in ROOMS:
        for path in (folder / room).rglob(pattern):
            name = path.relative_to(folder).as_posix()
            found.add(name.removesuffix(ending))
    return found


def check(tree):
    public = stems(tree / "include/somato", "*.h", ".h")
    internal = stems(tree / "src", "*.h", ".h")
    sources = stems(tree / "src", "*.cc", ".cc")
    tests = stems(tree / "tests", "*_test.cc", "_test.cc")
    problems = []
    for name in sorted(sources - public - internal):
        if f"{name}.cc" not in SOURCES_WITHOUT_HEADER:
            problems.append(f"src/{name}.cc: no include/somato/{name}.h and no src/{name}.h")
    for name in sorted((sources & public) - tests):
        if f"{name}.h" not in HEADERS_WITHOUT_TEST:
            problems.append(f"include/somato/{name}.h: no tests/{name}_test.cc")
    for name in sorted(tests - public - internal):
        thing = name.rpartition("_")[0]  # tests of a large THING: THING_WORD_test.cc for one subject
        if thing not in public | internal and f"{name}_test.cc" not in TESTS_WITHOUT_HEADER:
            problems.append(f"tests/{name}_test.cc: no header of that name")
    return problems


def main():
    tree = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent
    problems = check(tree)
    print(*problems, sep="\n", end="\n" if problems else "", file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
