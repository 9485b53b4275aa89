"""Builds the wheel of the package from its source distribution and tests it in an environment of its own.

usage: wheel.py --source DIR --work DIR --base ENVIRONMENT [--pages FILE]
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

# Of the source tree, but not of the source distribution.
LEFT_OUT = ("docs/pictures/", ".ci/")
REQUIREMENTS = "tests/python/requirements.txt"


def run(*command, **options):
    print("$", *command, flush=True)
    return subprocess.run([str(word) for word in command], check=True, **options)


def environment(folder, base, source):
    """A new environment that finds the pinned packages in that of the build; its interpreter."""
    run("cmake", f"-DPYTHON={base / 'bin/python'}", f"-DBASE={base}", f"-DTO={folder}",
        "-P", source / "cmake/python_environment.cmake")
    return folder / "bin/python"


def source_distribution(python, source, folder):
    """The source distribution, which contains every file of the source tree."""
    folder.mkdir()
    run(python, "-c", "import scikit_build_core.build as b, sys; b.build_sdist(sys.argv[1])", folder,
        cwd=source)
    (archive,) = folder.glob("*.tar.gz")
    with tarfile.open(archive) as file:
        names = {name.partition("/")[2] for name in file.getnames()}
    tracked = run("git", "ls-files", cwd=source, stdout=subprocess.PIPE, text=True).stdout.split("\n")
    missing = {name for name in tracked if (source / name).is_file() and name not in names}
    assert {name for name in missing if not name.startswith(LEFT_OUT)} == set(), missing
    return archive


def build(archive, folder, source, pages):
    """The wheel, built as pip builds it, with the pinned versions of nanobind and its helpers.

    It takes the pages of the build. It is where g++ compiles the program, so that its warnings are errors.
    The build's folder and the compiler's name are those of the preset gcc: the compiler's cache serves both.
    """
    defined = {"SOMATO_WARNINGS_AS_ERRORS": "ON"}
    if pages:
        defined["SOMATO_PAGES_FILE"] = pages
    settings = ["--config-settings=build-dir=build/gcc",
                *[f"--config-settings=cmake.define.{name}={value}" for name, value in defined.items()]]
    run(sys.executable, "-m", "pip", "wheel", archive, "--no-deps", "--wheel-dir", folder, *settings,
        env=dict(os.environ, CXX="g++", PIP_CONSTRAINT=str(source / REQUIREMENTS)))
    (wheel,) = folder.glob("*.whl")
    return wheel


def check_content(wheel, source):
    """The name, and that only the package, its program and the pinned engine are in the wheel."""
    package, version, python, abi, _ = wheel.stem.split("-")
    assert (python, abi) == ("cp310", "abi3"), wheel.name
    with zipfile.ZipFile(wheel) as file:
        names = set(file.namelist())
    described = f"{package}-{version}"
    ours = {name for name in names if not name.startswith(f"{described}.dist-info/")}
    engine = re.search(r"^mujoco==(\S+)", (source / "scripts/mujoco.txt").read_text(), re.MULTILINE)[1]
    command = f"{described}.data/scripts/somato"
    assert all(name.startswith(f"{package}/") for name in ours - {command}), ours
    for name in ("__init__.py", "_somato.abi3.so", "_somato.pyi", "py.typed", "bin/somato",
                 f"lib/libmujoco.so.{engine}", "doc/mujoco/LICENSE"):
        assert f"{package}/{name}" in ours, name
    assert command in ours
    for name in ("LICENSE", "NOTICE"):
        assert f"{described}.dist-info/licenses/{name}" in names, name
    print(f"{wheel.name}: {wheel.stat().st_size / 1e6:.1f} MB")


def repaired(python, wheel, folder):
    """The wheel with the libraries of the distribution that it needs, for other distributions."""
    run(python, "-m", "auditwheel", "show", wheel)
    run(python, "-m", "auditwheel", "repair", wheel, "--wheel-dir", folder,
        env=dict(os.environ, PATH=f"{python.parent}:{os.environ['PATH']}"))
    (better,) = folder.glob("*.whl")
    assert "manylinux" in better.name, better.name
    return better


def check_program(python, work):
    """The command explores like the program of the build, and contains the pages."""
    flags = ["explore", "--body", "hardness", "--explorations", "2", "-o"]
    recordings = [work / "by_wheel.mcap", work / "by_build.mcap"]
    for program, path in zip((python.with_name("somato"), os.environ["SOMATO_PROGRAM"]), recordings):
        run(program, *flags, path)
    assert recordings[0].read_bytes() == recordings[1].read_bytes()
    for words in (["run", "hardness", "--data", recordings[0], "--seeds", "1", "--out", work / "study"],
                  ["report", work / "study/results.json", "-o", work / "report.html"]):
        run(python.with_name("somato"), *words)


def version_of(interpreter):
    """(3, minor) of an interpreter, or nothing if it cannot be used."""
    done = subprocess.run([interpreter, "-c", "import ensurepip, sys; print(*sys.version_info[:2])"],
                          check=False, capture_output=True, text=True)
    return tuple(map(int, done.stdout.split())) if done.returncode == 0 else None


def other_interpreters():
    """The oldest and the newest other interpreter at hand that the wheel supports."""
    named = [shutil.which(f"python3.{minor}") for minor in range(10, 20)]
    versions = Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv")) / "versions"
    found = {version_of(path): path for path in [*filter(None, named), *versions.glob("3.*/bin/python3")]}
    usable = sorted(version for version in found
                    if version and version >= (3, 10) and version != sys.version_info[:2])
    return [found[version] for version in dict.fromkeys(usable[:1] + usable[-1:])]


def check_pickles(python, wheel, work, source):
    """Other versions of Python read the pickles of this one, and predict the same."""
    script = source / "tests/python/pickles.py"
    run(python, script, "--write", work / "som.pickle")
    for number, interpreter in enumerate(other_interpreters()):
        folder = work / f"other_{number}"
        run(interpreter, "-m", "venv", folder)
        run(folder / "bin/python", "-m", "pip", "install", "--quiet", "--no-compile", "--only-binary", ":all:", wheel)
        run(folder / "bin/python", script, "--read", work / "som.pickle")


def main():
    parser = argparse.ArgumentParser(description="Builds the wheel of the package and tests it.")
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--work", type=Path, required=True)
    parser.add_argument("--base", type=Path, required=True, help="environment with the pinned packages")
    parser.add_argument("--pages", type=Path, help="pages.cc of another build")
    options = parser.parse_args()
    source, work, base = options.source.resolve(), options.work.resolve(), options.base.resolve()
    shutil.rmtree(work, ignore_errors=True)
    python = environment(work / "environment", base, source)
    archive = source_distribution(python, source, work / "source")
    wheel = build(archive, work / "wheels", source, options.pages)
    check_content(wheel, source)
    wheel = repaired(base / "bin/python", wheel, work / "repaired")
    run(python, "-m", "pip", "install", "--quiet", "--no-deps", wheel)
    run(python, "-m", "pip", "check")
    check_program(python, work)
    check_pickles(python, wheel, work, source)
    run(python, "-m", "pytest", "-q", "-p", "no:cacheprovider", source / "tests/python", cwd=work,
        env=dict(os.environ, SOMATO_LONG_TESTS="1"))


if __name__ == "__main__":
    main()
