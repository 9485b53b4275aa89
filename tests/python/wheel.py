"""Builds the wheel of the package and tests it in an environment of its own.

usage: wheel.py --source DIR --work DIR
"""

import argparse
import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path


def run(*command, **options):
    print("$", *command, flush=True)
    subprocess.run([str(word) for word in command], check=True, **options)


def build(source, folder, requirements):
    """The wheel, built as pip builds it, with the pinned versions of nanobind and its helpers."""
    run(sys.executable, "-m", "pip", "wheel", source, "--no-deps", "--wheel-dir", folder,
        env=dict(os.environ, PIP_CONSTRAINT=str(requirements)))
    (wheel,) = folder.glob("*.whl")
    return wheel


def check_content(wheel):
    """The name, and that only the package is in the wheel."""
    package, version, python, abi, _ = wheel.stem.split("-")
    assert (python, abi) == ("cp310", "abi3"), wheel.name
    with zipfile.ZipFile(wheel) as file:
        names = set(file.namelist())
    described = f"{package}-{version}.dist-info/"
    ours = {name for name in names if not name.startswith(described)}
    assert all(name.startswith(f"{package}/") for name in ours), ours
    for name in ("__init__.py", "_somato.abi3.so", "_somato.pyi", "py.typed"):
        assert f"{package}/{name}" in ours, name
    for name in ("LICENSE", "NOTICE"):
        assert f"{described}licenses/{name}" in names, name


def test(wheel, folder, requirements):
    """Installs the wheel in a new environment and runs the tests there."""
    run(sys.executable, "-m", "venv", folder)
    python = folder / "bin/python"
    for words in (["-r", requirements], [wheel]):
        run(python, "-m", "pip", "install", "--quiet", "--no-deps", *words)
    run(python, "-m", "pip", "check")
    run(python, "-m", "auditwheel", "show", wheel)
    run(python, "-B", "-m", "pytest", "-q", "-p", "no:cacheprovider", requirements.parent, cwd=folder)


def main():
    parser = argparse.ArgumentParser(description="Builds the wheel of the package and tests it.")
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--work", type=Path, required=True)
    options = parser.parse_args()
    requirements = options.source.resolve() / "tests/python/requirements.txt"
    shutil.rmtree(options.work, ignore_errors=True)
    wheel = build(options.source.resolve(), options.work.resolve() / "wheels", requirements)
    check_content(wheel)
    test(wheel, options.work.resolve() / "environment", requirements)


if __name__ == "__main__":
    main()
