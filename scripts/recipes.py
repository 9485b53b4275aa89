#!/usr/bin/env python3
"""Follows the recipes of docs/recipes in a copy of the tree: applies the changes that they show, builds, and runs
the tests that they name.

usage: ./dev recipes [NAME...]      the recipes of these names, such as command; default: all
       ./dev recipes --check        only whether the changes of all recipes apply to this tree
       ./dev recipes --compile [NAME...]   apply the changes, and check the sources that they touch with the compiler,
                                    without building anything
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import check_text

TREE = Path(__file__).resolve().parent.parent
FOLDER = Path("docs/recipes")
DIFF = re.compile(r"^```diff\n(.*?)^```$", re.MULTILINE | re.DOTALL)
TESTS = re.compile(r"^Tests: `\./dev test ([^`]+)`$", re.MULTILINE)
NEW_FILE = re.compile(r"^\+\+\+ b/(.+)$", re.MULTILINE)
MOST_PLACES = 6
COMPILER = os.environ.get("CXX", "clang++-19")
CONTEXT = 1  # lines around a change that must be as shown

# Pages that are output of the program: a command, and the page.
GENERATED = {("reference",): "docs/reference/flags-and-keys.md", ("modules", "--markdown"): "docs/reference/modules.md"}


@dataclass(frozen=True)
class Recipe:
    name: str
    patch: str
    tests: tuple  # wings or rooms

    def files(self):
        return NEW_FILE.findall(self.patch)

    def places(self):
        """The places in code that it touches: a header and its source are one; the changelog is one."""
        return len({re.sub(r"\.(h|cc)$", "", file) for file in self.files() if not file.startswith("docs/")}) + 1


def read(tree):
    recipes = []
    for page in sorted((tree / FOLDER).glob("*.md")):
        if page.name == "README.md":
            continue
        text = page.read_text(encoding="utf-8")
        tests = TESTS.search(text)
        recipes.append(Recipe(page.stem, "".join(DIFF.findall(text)), tuple(tests[1].split()) if tests else ()))
    return recipes


def apply(patch, tree, *options):
    """What git prints if the patch does not apply to `tree`; empty if it does."""
    environment = os.environ | {"GIT_CEILING_DIRECTORIES": str(tree.resolve().parent)}
    done = subprocess.run(["git", "apply", f"-C{CONTEXT}", *options, "-"], cwd=tree, input=patch, text=True,
                          capture_output=True, env=environment)
    return done.stderr.strip() if done.returncode else ""


def problems_of(recipe, tree):
    where = f"{FOLDER / recipe.name}.md"
    if not recipe.patch or not recipe.tests:
        yield f"{where}: it has no ```diff block, or no line 'Tests: `./dev test ROOM...`'"
        return
    if recipe.places() > MOST_PLACES:
        yield f"{where}: it touches {recipe.places()} places; at most {MOST_PLACES}"
    if problem := apply(recipe.patch, tree, "--check"):
        yield f"{where}: its changes do not apply; write them for the present files\n{problem}"


def check(tree):
    return [problem for recipe in read(tree) for problem in problems_of(recipe, tree)]


def copy_tree(to):
    shutil.rmtree(to, ignore_errors=True)
    for name in check_text.tracked(TREE):
        (to / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(TREE / name, to / name)


def build(tree, groups):
    """Configures the copy with what this checkout has fetched and made, and builds groups of tests."""
    (tree / "build").mkdir()
    (tree / "build/mujoco").symlink_to(TREE / "build/mujoco")
    pages = TREE / "build/dev/web/pages.cc"
    options = [f"-DSOMATO_PAGES_FILE={pages}"] if pages.is_file() else ["-DSOMATO_BUILD_PAGES=OFF"]
    targets = [f"{group}_group" for group in groups]
    return all(subprocess.run(command, cwd=tree).returncode == 0 for command in (
        # Position-independent as in the build folder `dev`, whose results a compiler cache has.
        ["cmake", "--preset", "dev", "-DSOMATO_BUILD_PYTHON=OFF", "-DSOMATO_POSITION_INDEPENDENT=ON", *options],
        ["cmake", "--build", "build/dev", "--target", "somato_program", *targets]))


def is_compiled(tree, source, generated):
    """Whether the compiler accepts a source of the copy; it prints what it does not."""
    folders = [tree / "include", tree / "src", tree / "tests", tree / "program", generated]
    return subprocess.run([COMPILER, "-std=gnu++20", "-fsyntax-only", "-DFMT_SHARED",
                           *(f"-I{folder}" for folder in folders), source], cwd=tree).returncode == 0


def compile_only(recipes, tree, generated):
    """Whether the compiler accepts all sources that the recipes touch; `generated` has headers that the build makes."""
    copy_tree(tree)
    if not apply_all(recipes, tree):
        return False
    sources = [file for recipe in recipes for file in recipe.files() if file.endswith(".cc")]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        return all(list(pool.map(lambda source: is_compiled(tree, source, generated), sources)))


def apply_all(recipes, tree):
    for recipe in recipes:
        if problem := apply(recipe.patch, tree):
            print(f"{recipe.name}: its changes do not apply\n{problem}", file=sys.stderr)
            return False
    return True


def generate_pages(tree):
    subprocess.run([sys.executable, "scripts/page_metrics.py"], cwd=tree, check=True)
    for words, page in GENERATED.items():
        made = subprocess.run([tree / "build/dev/somato", *words], capture_output=True, text=True, check=True).stdout
        (tree / page).write_text(made, encoding="utf-8")


def follow(recipes, tree):
    """Whether the recipes, all in one copy, build and pass their tests."""
    copy_tree(tree)
    if not apply_all(recipes, tree):
        return False
    rooms = sorted({room for recipe in recipes for room in recipe.tests})
    if not build(tree, sorted({room.split("/")[0] for room in rooms})):
        return False
    generate_pages(tree)
    names = "|".join(rooms)
    return subprocess.run(["ctest", "--test-dir", "build/dev", "-L", f"^({names})$", "-LE", "^long$",
                           "--output-on-failure", "--no-tests=error"], cwd=tree).returncode == 0


def main():
    parser = argparse.ArgumentParser(prog="./dev recipes", usage=__doc__.split("usage: ")[1])
    parser.add_argument("names", nargs="*")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--compile", action="store_true")
    parser.add_argument("--generated", type=Path, default=TREE / "build/dev/program")
    given = parser.parse_args()
    if given.check:
        problems = check(TREE)
        print(*problems, sep="\n", end="\n" if problems else "", file=sys.stderr)
        return not problems
    known = {recipe.name: recipe for recipe in read(TREE)}
    for name in given.names:
        if name not in known:
            parser.error(f"'{name}' is not a recipe; there are: {', '.join(known)}")
    chosen = [known[name] for name in given.names] or list(known.values())
    if given.compile:
        return compile_only(chosen, TREE / "build/recipes/compiled", given.generated)
    if not follow(chosen, TREE / "build/recipes/tree"):
        return False
    for recipe in chosen:
        print(f"{recipe.name}: {recipe.places()} places, with the changelog")
    return True


if __name__ == "__main__":
    sys.exit(0 if main() else 1)
