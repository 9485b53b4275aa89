"""How a build compiles each source."""

import json
from pathlib import Path


def entries(build):
    return json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))


def by_file(build):
    """The command that compiles each source of the folder `build`."""
    return {Path(entry["file"]): entry["command"] for entry in entries(build)}
