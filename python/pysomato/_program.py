"""The program ``somato`` that the package contains."""

import re
import subprocess
from pathlib import Path

from . import _somato
from .errors import Error, UsageError

_USAGE = 2  # the exit code of wrong arguments and files


def run_program(*words, folder=None) -> None:
    """Runs the program in a folder, or in the current one, without its output. Ctrl-C ends it.

    Raises:
        UsageError: An argument or a key of a file is wrong.
        Error: The program failed for another reason.
    """
    program = Path(_somato.__file__).with_name("bin") / "somato"
    done = subprocess.run([program, *map(str, words)], check=False, cwd=folder,
                          stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, text=True)
    if done.returncode == 0:
        return
    message = _with_arguments(done.stderr.strip().removeprefix("somato: "))
    raise (UsageError if done.returncode == _USAGE else Error)(message, f"somato {words[0]}")


def _with_arguments(message):
    """A message of the program with the names of arguments instead of its flags, which differ in hyphens."""
    return re.sub(r"(?<![\w-])--([a-z][a-z-]*)", lambda flag: flag[1].replace("-", "_"), message)
