#!/usr/bin/env python3
"""Reports calls whose bits differ between machines, checks of tests that only clang accepts, machine-specific paths,
wording, links of pages to files that are gone, and long files.

usage: check_text.py [TREE]
"""

import re
import subprocess
import sys
from pathlib import Path

# In the library: functions of the C and C++ libraries that are free to round, or to draw, differently.
BANNED_CALLS = re.compile(
    r"\bstd::(?:exp|exp2|expm1|log|log2|log10|log1p|pow|sin|cos|tan|sinh|cosh|tanh|hypot|cbrt"
    r"|rand|srand|shuffle|random_shuffle|sample|mt19937\w*|random_device|\w+_distribution"
    r"|default_random_engine)\b"
    r"|(?<![\w:.>])(?:s?rand|drand48|expf?|powf?|logf?|sinf?|cosf?)\s*\("
)
BANNED_FLAGS = re.compile(r"-ffast-math|-Ofast|-funsafe-math-optimizations")
MACHINE_PLACES = re.compile(r"(?<![\w.\-/$}])/(?:tmp|work|root|home/\w+)/")
# Words that STYLE.md excludes: they read as translated, or as metaphors.
WORDING = re.compile(
    r"(?<![A-Za-z`])(?:whoever|so-and-so|told|tells|tell apart|asked|alone|heard|lessons?|narrators?|by luck"
    r"|what came of it|looks? on|lookers-on|goes on|of one's own|nobody)(?![A-Za-z`])", re.IGNORECASE)
# Comments begin with their subject or a verb, not with a fragment such as "What the map learns."
FRAGMENT = re.compile(r"""(?://[/!]?<?|#|/\*\*?|^\s*\*|"{3})\s+((?:What|Whatever|Who|Whose|Of) [a-z`][^?]*)$""")
LINK = re.compile(r"\]\((?!\w+:)([^)#\s]+)")
CODE_BLOCK = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)
PRINTS = re.compile(r"\bstd::(?:cout|cerr|clog|printf|puts|fprintf|fputs)\b|\bfmt::print\b")

# The checks of googletest are statements with an `else`; g++ refuses them after a condition without braces, clang does
# not.
BARE_CHECK = re.compile(r"^\s*(?:\} )?(?:else )?if \(.*\)\s+(?:EXPECT|ASSERT)_")

# In what users of the library and of the Python package read, too: they have no flags.
FLAGS = re.compile(r'"(?:\\.|[^"\\])*(?<![\w-])--[a-z][\w-]*')
WITHOUT_FLAGS = re.compile(r"src/(?:base|maps|recordings/(?!bags/)|bodies|systems|studies)/")

# Exceptions, each with its reason.
MAY_PRINT = {"src/base/core/check.cc": "a violated invariant ends the program with a message"}
MAY_NAME_FLAGS = {"src/studies/results/next_steps.cc": "it proposes commands of the program"}
MAY_ROUND = {
    "src/bodies/hands/ray_picture.cc": "the bits of a picture are not guaranteed",
    "src/bodies/physics/object_mjcf.cc": "text for the physics engine, whose bits are not guaranteed",
    "src/bodies/hands/object_motion.cc": "poses for the physics engine, whose bits are not guaranteed",
}
KNOWS_THE_PATTERNS = {"scripts/check_text.py", "tests/house/check_text_test.py", "STYLE.md", "LICENSE"}
COMMENTED = (".h", ".cc", ".ts", ".cmake", ".css")

LONG_FILE = 400


def tracked(tree):
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard"],
        cwd=tree, check=True, capture_output=True, text=True)
    return [name for name in listed.stdout.splitlines() if (tree / name).is_file()]


def without_comments(line):
    return re.sub(r'"(?:\\.|[^"\\])*"', '""', line).split("//")[0]


def problems_of_line(name, line):
    """Problems of a line of the file `name`."""
    is_cpp = name.endswith((".h", ".cc"))
    in_library = name.startswith(("src/", "include/")) and is_cpp
    code = without_comments(line) if is_cpp else line
    if in_library and name not in MAY_ROUND and (found := BANNED_CALLS.search(code)):
        yield f"'{found[0].strip('( ')}' differs between machines; see STYLE.md"
    if in_library and name not in MAY_PRINT and (found := PRINTS.search(code)):
        yield f"'{found[0]}': the library never prints"
    without_flags = WITHOUT_FLAGS.match(name) and name not in MAY_NAME_FLAGS
    if is_cpp and without_flags and FLAGS.search(line.split("//")[0]):
        yield "a message names a flag of the program; use flag_hint()"
    if is_cpp and BARE_CHECK.match(code):
        yield "a check under a condition needs braces; g++ refuses it"
    if name.endswith((".txt", ".cmake", ".json", ".in")) and (found := BANNED_FLAGS.search(line)):
        yield f"'{found[0]}' changes bits"
    if name.endswith(COMMENTED) and (found := FRAGMENT.search(line)):
        yield f"'{found[1][:20]}...': begin a comment with its subject or a verb; see STYLE.md"
    if found := WORDING.search(line):
        yield f"'{found[0]}': use plain technical terms; see STYLE.md"
    if found := MACHINE_PLACES.search(line):
        yield f"'{found[0]}' is a machine-specific path"


def broken_links(tree, name):
    """The relative links of a Markdown page that lead to no file or folder."""
    text = CODE_BLOCK.sub("", (tree / name).read_text(encoding="utf-8"))
    for link in LINK.findall(text):
        if not (tree / name).parent.joinpath(link).exists():
            yield f"{name}: the link '{link}' leads to no file"


def check(tree, names):
    problems = [found for name in names if name.endswith(".md") for found in broken_links(tree, name)]
    for name in names:
        if name in KNOWS_THE_PATTERNS:
            continue
        try:
            lines = (tree / name).read_text(encoding="utf-8").splitlines()
        except UnicodeDecodeError:
            continue  # a picture or other binary file
        for number, line in enumerate(lines, 1):
            problems += [f"{name}:{number}: {found}" for found in problems_of_line(name, line)]
    return problems


def long_files(tree, names):
    for name in names:
        if name.endswith((".h", ".cc", ".py", ".sh")):
            length = len((tree / name).read_text(encoding="utf-8").splitlines())
            if length > LONG_FILE:
                yield f"note: {name} has {length} lines; the recommended maximum is {LONG_FILE}"


def main():
    tree = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent
    names = tracked(tree)
    for note in long_files(tree, names):
        print(note)
    problems = check(tree, names)
    print(*problems, sep="\n", end="\n" if problems else "", file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
