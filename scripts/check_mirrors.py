#!/usr/bin/env python3
"""Reports headers, sources and tests that do not mirror each other (STYLE.md).

usage: check_mirrors.py [TREE]
"""

import sys
from pathlib import Path

from check_includes import DIRECT

ROOMS = [room for room in DIRECT if room != "program"]

# Files without a mirror, each with its reason.
SOURCES_WITHOUT_HEADER = {
    "kernels/kernels_portable.cc": "kernels/kernels.h for any processor",
    "kernels/kernels_avx2.cc": "kernels/kernels.h for AVX2",
    "kernels/kernels_avx512.cc": "kernels/kernels.h for AVX-512",
    "kernels/kernels_avx512_vnni.cc": "kernels/batch_kernels.h for AVX-512 with integer products",
    "bodies/explore_by_closing.cc": "bodies/explore_by.h: one way to explore",
    "bodies/explore_by_grasping.cc": "bodies/explore_by.h: one way to explore",
    "bodies/explore_by_holding.cc": "bodies/explore_by.h: one way to explore",
    "bodies/explore_by_pressing.cc": "bodies/explore_by.h: one way to explore",
    "bodies/explore_by_stroking.cc": "bodies/explore_by.h: one way to explore",
    "codes/spectrum_parameters.cc": "codes/spectrum.h: its parameters",
    "devices/body_check.cc": "devices/device_file.h: checking it against a body",
    "devices/device_file_settings.cc": "devices/device_file.h: its parameters",
    "devices/make_bus.cc": "devices/device_io.h: the kinds of servos",
    "graph/module_types.cc": "graph/module.h: the list of all types",
    "graph/modules/codes.cc": "graph/modules/support.h: types of modules",
    "graph/modules/association.cc": "graph/modules/support.h: types of modules",
    "graph/modules/drift.cc": "graph/modules/support.h: types of modules",
    "graph/modules/features.cc": "graph/modules/support.h: types of modules",
    "graph/modules/frames.cc": "graph/modules/support.h: types of modules",
    "graph/modules/memories.cc": "graph/modules/support.h: types of modules",
    "graph/modules/scaling.cc": "graph/modules/support.h: types of modules",
    "graph/modules/source.cc": "graph/modules/support.h: types of modules",
    "graph/modules/t_mpsom.cc": "graph/modules/support.h: types of modules",
    "graph/modules/winner.cc": "graph/modules/support.h: types of modules",
    "maps/som_elements.cc": "maps/som.h: which elements a map stores",
    "maps/t_mpsom_parameters.cc": "maps/t_mpsom.h: its parameters",
    "recording/csv_import_trials.cc": "recording/csv_import.h: reading the files",
    "recording/recording_reader.cc": "recording/recording_file.h: reading",
    "simulation/texture_probe_parameters.cc": "simulation/texture_probe.h: its parameters",
    "studies/reproduction_plan.cc": "studies/reproduction.h: what is to be run",
    "suggestion/suggestion_text.cc": "suggestion/suggestion.h: the text of the file",
}
HEADERS_WITHOUT_TEST = {}
TESTS_WITHOUT_HEADER = {
    "core/no_malloc_test.cc": "support/no_malloc.h, which the tests of all rooms use",
    "report/json_schema_test.cc": "support/json_schema.h, which the tests of report and live use",
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
