#!/usr/bin/env python3
"""Builds docs/ as a site with the interfaces of C++ and Python, and checks it.

Warnings are errors. The site needs no network: 'index.html' opens in a browser, and its search works.

usage: ./dev docs [--build FOLDER] [--to FOLDER]
"""

import argparse
import os
import subprocess
import sys
from pathlib import Path

import check_site

TREE = Path(__file__).resolve().parent.parent
SITE = TREE / "docs/site"


def run(*command, **environment):
    subprocess.run([str(word) for word in command], check=True, cwd=TREE,
                   env=os.environ | {name: str(value) for name, value in environment.items()})


def build_package(build):
    """Compiles the extension module of the Python package in a build folder of that name."""
    run("cmake", "--preset", build.name)
    run("cmake", "--build", build, "--target", "somato_python")


def make_environment(folder, build):
    """An environment with the packages of the site, in addition to those of the build's environment."""
    base = build / "python/environment"
    run("cmake", f"-DPYTHON={base / 'bin/python'}", f"-DREQUIREMENTS={SITE / 'requirements.txt'}",
        f"-DBASE={base}", f"-DTO={folder}", "-P", TREE / "cmake/python_environment.cmake")


def read_headers(folder):
    """Doxygen's XML of the public headers of the rooms."""
    headers = TREE / "include"
    folders = sorted(path for path in (headers / "somato").iterdir() if path.is_dir())
    folder.mkdir(parents=True, exist_ok=True)
    settings = (SITE / "Doxyfile").read_text(encoding="utf-8") + f"""
INPUT = {' '.join(f'"{path}"' for path in folders)}
STRIP_FROM_PATH = "{headers}"
STRIP_FROM_INC_PATH = "{headers}"
OUTPUT_DIRECTORY = "{folder}"
"""
    subprocess.run(["doxygen", "-"], input=settings, text=True, check=True)
    return folder / "xml"


def generate(environment, build, doxygen, folder):
    python = environment / "bin/python"
    of_package = {"PYTHONPATH": build / "python", "PYTHONPYCACHEPREFIX": build / "python/bytecode"}
    # Python compiles what the notebooks' kernels import once, not in each kernel while it has to start.
    run(python, "-c", "import ipykernel.kernelapp, pysomato", **of_package)
    run(python, "-m", "sphinx", "--fresh-env", "--fail-on-warning", "--keep-going", "--quiet",
        "--jobs", "auto", "--conf-dir", SITE, "--doctree-dir", folder.parent / "doctrees", TREE, folder,
        SOMATO_DOXYGEN=doxygen, **of_package)


def main():
    parser = argparse.ArgumentParser(prog="./dev docs", description="Builds the documentation as a site.")
    parser.add_argument("--build", type=Path, help="build folder with the Python package, which is then not "
                        "compiled; default: that of the preset dev if there is one, otherwise python")
    parser.add_argument("--to", type=Path, default=TREE / "build/docs", help="default: build/docs")
    options = parser.parse_args()
    build = options.build or TREE / "build" / ("dev" if (TREE / "build/dev/python").is_dir() else "python")
    if not options.build:
        build_package(build)
    work = options.to.resolve()
    make_environment(work / "environment", build.resolve())
    site = work / "site"
    generate(work / "environment", build.resolve(), read_headers(work / "doxygen"), site)
    problems = check_site.problems_of(site)
    print(*problems, sep="\n", end="\n" if problems else "", file=sys.stderr)
    print(f"The site: {site / 'index.html'}" if not problems else f"{len(problems)} problems of links")
    return 1 if problems else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except subprocess.CalledProcessError as error:
        sys.exit(f"./dev docs: '{error.cmd[0]}' failed with exit code {error.returncode}")
    except FileNotFoundError as error:
        sys.exit(f"./dev docs: {error.filename} is missing; './dev setup build python docs' installs what the site requires")
