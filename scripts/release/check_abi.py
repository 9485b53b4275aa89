#!/usr/bin/env python3
"""Compares the binary interface of a build with that of version 1.0, which abi/ contains: what the shared library
exports, and the layout of the types of the public headers. Fails if a program that was linked with 1.0 could fail.

usage: check_abi.py LIBRARY [--update] [--tree TREE] [--compiler COMPILER]

LIBRARY is libsomato.so of the preset `package`. --update writes abi/ instead: only for additions, at a release.
Requires abidw and abidiff (Debian's abigail-tools).
"""

import argparse
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from pathlib import Path

SYMBOLS = "abi/libsomato.abi"
LAYOUTS = "abi/layouts.txt"
INCOMPATIBLE = 8  # a bit of the exit code of abidiff
# Users of a header compile these themselves; which ones a library has depends on the compiler.
COMPILED_BY_USERS = re.compile(r"binding='(?:weak|gnu-unique)-binding'")
HEADER = "# Layout of the types of the public headers, written by scripts/release/check_abi.py --update.\n"


def run(*words, accepted=(0,)):
    done = subprocess.run([str(word) for word in words], check=False, text=True, capture_output=True)
    if done.returncode not in accepted:
        sys.exit(f"check_abi: {words[0]}: {done.stdout}{done.stderr}")
    return done


def exported(library):
    """What the library exports, in the XML of abidw, without what depends on the distribution."""
    text = run("abidw", "--no-corpus-path", "--no-comp-dir-path", library).stdout
    text = re.sub(r"  <elf-needed>.*?</elf-needed>\n", "", text, flags=re.DOTALL)
    return "".join(line + "\n" for line in text.splitlines() if not COMPILED_BY_USERS.search(line))


def described_headers(tree, compiler, folder):
    """The XML of abidw for all types of the public headers."""
    headers = sorted(path.relative_to(tree / "include") for path in (tree / "include/somato").rglob("*.h"))
    source, library = folder / "headers.cc", folder / "headers.so"
    source.write_text("".join(f'#include "{header}"\n' for header in headers) + 'extern "C" void headers() {}\n')
    run(compiler, "-std=c++20", "-g", "-fPIC", "-shared", "-fno-eliminate-unused-debug-types",
        "-I", tree / "include", source, "-o", library)
    return run("abidw", "--load-all-types", "--no-corpus-path", "--no-comp-dir-path", "--no-show-locs", library).stdout


def names_of_types(root):
    """The function that names the type with an id."""
    known = {element.get("id"): element for element in root.iter() if element.get("id")}
    marks = {"pointer-type-def": "*", "qualified-type-def": " const"}

    def name(number, depth=0):
        element = known.get(number)
        if element is None or depth > 8:
            return "?"
        if element.tag == "reference-type-def":
            return name(element.get("type-id"), depth + 1) + ("&" if element.get("kind") == "lvalue" else "&&")
        if element.tag in marks:
            return name(element.get("type-id"), depth + 1) + marks[element.tag]
        if element.tag == "array-type-def":
            lengths = "".join(f"[{part.get('length')}]" for part in element.iter("subrange"))
            return name(element.get("type-id"), depth + 1) + lengths
        return element.get("name", element.tag)

    return name


def members(element, name):
    for part in element:
        if part.tag == "base-class":
            yield f"{part.get('layout-offset-in-bits')} base {name(part.get('type-id'))}"
        for variable in part.iter("var-decl") if part.tag == "data-member" and part.get("static") != "yes" else ():
            yield f"{part.get('layout-offset-in-bits')} {variable.get('name')} {name(variable.get('type-id'))}"
        if part.tag == "member-function" and part.get("vtable-offset"):
            yield f"virtual {part.get('vtable-offset')} {part.find('function-decl').get('mangled-name')}"
    for value in element.iter("enumerator"):
        yield f"{value.get('name')} = {value.get('value')}"


def layouts(xml):
    """{qualified name: its size and members} of the types of the namespace somato, and of those of C."""
    root = ET.fromstring(xml)
    name = names_of_types(root)
    found = {}

    def visit(element, scope):
        for part in element:
            called = part.get("name")
            if part.tag == "namespace-decl":
                visit(part, [*scope, called])
            elif part.tag in ("abi-instr", "member-type"):
                visit(part, scope)
            elif part.tag in ("class-decl", "enum-decl", "union-decl") and called and part.get("is-anonymous") != "yes":
                is_ours = scope[:1] == ["somato"] or (not scope and called.startswith("somato_"))
                if is_ours and "detail" not in scope and part.get("is-declaration-only") != "yes":
                    size = f"{part.get('size-in-bits', '32')} bits"
                    found["::".join([*scope, called])] = [size, *members(part, name)]
                visit(part, [*scope, called])

    visit(root, [])
    return found


def layouts_text(types):
    return HEADER + "".join(f"\n{name}\n" + "".join(f"  {line}\n" for line in lines)
                            for name, lines in sorted(types.items()))


def layouts_in(text):
    blocks = text.removeprefix(HEADER).strip("\n").split("\n\n")
    return {name: [line.strip() for line in lines] for name, *lines in (block.split("\n") for block in blocks)}


def changed_layouts(kept, types):
    """A line for each type that users of 1.0 would see with another layout, or not at all."""
    for name, lines in kept.items():
        now = types.get(name)
        if now is None:
            yield f"{name}: the type is gone"
        elif now != lines:
            gone = [line for line in lines if line not in now]
            added = [line for line in now if line not in lines]
            yield f"{name}: '{'; '.join(gone)}' became '{'; '.join(added)}'"


def check_symbols(tree, text, folder):
    """Whether a function or variable of 1.0 is gone; prints the report of abidiff."""
    now = folder / "now.abi"
    now.write_text(text)
    done = run("abidiff", tree / SYMBOLS, now, accepted=range(16))
    print(done.stdout, end="")
    return bool(done.returncode & INCOMPATIBLE)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", 1)[0])
    parser.add_argument("library", type=Path)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--tree", type=Path, default=Path(__file__).resolve().parents[2])
    parser.add_argument("--compiler", default="g++")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        symbols = exported(given.library)
        types = layouts(described_headers(given.tree, given.compiler, folder))
        if given.update:
            (given.tree / SYMBOLS).write_text(symbols)
            (given.tree / LAYOUTS).write_text(layouts_text(types))
            return 0
        changed = list(changed_layouts(layouts_in((given.tree / LAYOUTS).read_text()), types))
        for line in changed:
            print(f"check_abi: {line}")
        if check_symbols(given.tree, symbols, folder) or changed:
            print("check_abi: programs that were linked with 1.0 may fail: keep what was removed or changed as it was, "
                  "and add beside it, or make a new major version (docs/stability.md)")
            return 1
    print(f"check_abi: {len(types)} types and the exported symbols are compatible with 1.0")
    return 0


if __name__ == "__main__":
    sys.exit(main())
