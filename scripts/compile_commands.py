"""Compile commands of the sources of a build."""

import json
import re
from pathlib import Path

TREE = Path(__file__).resolve().parent.parent
INCLUDED = re.compile(r'^#include "([^"]+)"', re.MULTILINE)


def by_file(build):
    """For each source of the folder `build`: the command that compiles it, and the file that the command
    names, which is another one where sources are compiled together."""
    found = {}
    for entry in json.loads((build / "compile_commands.json").read_text(encoding="utf-8")):
        compiled = Path(entry["file"])
        sources = [compiled]
        if compiled.parent.parent.name == "together":  # cmake/SomatoUnity.cmake
            sources = (TREE / name for name in INCLUDED.findall(compiled.read_text(encoding="utf-8")))
        found.update((source, (entry["command"], compiled)) for source in sources)
    return found
