"""Python environments of the other programs below build/peers, created when first needed."""

import hashlib
import os
import subprocess
import sys
import tomllib
from pathlib import Path

from driven import Failure, last_line

TREE = Path(__file__).resolve().parent.parent
PEERS = TREE / "bench/peers"
ENVIRONMENTS = TREE / "build/peers"
PYTHON = "/usr/bin/python3"

# Compilation targets this machine and permits fast, inexact arithmetic: with default options,
# somoclu takes four times as long.
FLAGS = "-O3 -march=native -ffast-math"
COMPILING = {**os.environ, "CFLAGS": FLAGS, "CXXFLAGS": FLAGS}


def all_peers():
    """The settings in peers.toml, by peer."""
    return tomllib.loads((PEERS / "peers.toml").read_text(encoding="utf-8"))


def call(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True,
                          stdin=subprocess.DEVNULL, env=COMPILING, check=False)
    if done.returncode != 0:
        raise Failure("cannot be installed: " + last_line(done.stderr + done.stdout))


def requirements_of(peer, settings):
    return PEERS / f"requirements-{settings.get('requirements', peer)}.txt"


def stamp_of(requirements):
    """Identifies the installed requirements, including the files that they include."""
    text = requirements.read_text(encoding="utf-8")
    for line in text.splitlines():
        if line.startswith("-r "):
            text += stamp_of(requirements.parent / line[3:])
    return hashlib.sha256((FLAGS + text).encode()).hexdigest()


def install(pip, requirements, settings):
    if settings.get("build_isolation", True):
        return call(pip, "install", "-q", "-r", requirements)
    # Its set-up requires its dependencies, so they are installed first.
    *before, last = requirements.read_text(encoding="utf-8").split()
    call(pip, "install", "-q", *before)
    return call(pip, "install", "-q", "--no-build-isolation", "--no-deps", last)


def python_of(peer, settings, say):
    """The Python interpreter with this peer, installed if necessary; raises Failure."""
    name = settings.get("environment", peer)
    folder = ENVIRONMENTS / name
    requirements = requirements_of(peer, settings)
    stamp = folder / f"installed-{requirements.stem}"
    python = folder / "bin/python"
    if not stamp.exists() or stamp.read_text(encoding="utf-8") != stamp_of(requirements):
        say(f"installing {peer}")
        if not python.exists():
            call(PYTHON if Path(PYTHON).exists() else sys.executable, "-m", "venv", folder)
        install(folder / "bin/pip", requirements, settings)
        stamp.write_text(stamp_of(requirements), encoding="utf-8")
    return python


def command_of(peer, settings, say):
    """The command that starts the peer, without the case; raises Failure with the reason."""
    if "left_out" in settings:
        raise Failure(settings["left_out"])
    if settings.get("command") == "Rscript":
        call("Rscript", "-e", f"library({peer})")
        return ["Rscript", PEERS / f"{peer}.R", peer]
    return [python_of(peer, settings, say), PEERS / "serve.py", peer]
