#!/usr/bin/env python3
"""Reports equal names in the anonymous namespaces of the sources of one wing, or of its tests.

The sources of a wing are compiled together in groups (cmake/SomatoUnity.cmake), which shift with the number of files:
two files with the same name compile until they come into one group.

usage: check_names.py [TREE]
"""

import re
import sys
from pathlib import Path

import rooms

# Strings and characters become empty, comments and directives disappear.
LEFT_OUT = re.compile(r'R"(\w*)\(.*?\)\1"|"(?:[^"\\\n]|\\.)*"|(?<!\w)\'(?:[^\'\\\n]|\\.)*\'|//[^\n]*|/\*.*?\*/'
                      r"|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.DOTALL | re.MULTILINE)
NAMESPACE = re.compile(r"(?:inline )?namespace ?([\w:]*)$")
TEST = re.compile(r"(?:TYPED_)?TEST(?:_F|_P)?\((\w+), ?(\w+)\)$")
TYPE = re.compile(r"(?:struct|class|enum(?: class)?) (\w+)")
ALIAS = re.compile(r"using (\w+) = ")
VALUE = re.compile(r"[\w:][^()=]*[ &*>](\w+)(?:\[[^=]*\])*(?: ?=.*)?$")
FUNCTION = re.compile(r"[\w:][^()=]*[ &*>]([a-z]\w*) ?\((.*)\)(?: const| noexcept|\W*->.*)*$")
OPENING, CLOSING = "<([{", ">)]}"


def plain(text):
    """The text without what is not code."""
    return LEFT_OUT.sub(lambda found: ('""' if found[0][0] in "R\"'" else "") + "\n" * found[0].count("\n"), text)


def parts(text):
    """The parts of a list with commas."""
    depth, found = 0, [""]
    for letter in text:
        depth += (letter in OPENING) - (letter in CLOSING)
        if letter == "," and depth == 0:
            found.append("")
        else:
            found[-1] += letter
    return found


def type_of(parameter):
    """The type of a parameter: `const Text& text = {}` gives `const Text&`."""
    declared = parameter.split("=")[0].strip()
    return re.sub(r"(?<=[ &*>])\w+$", "", declared).strip() if " " in declared else declared


def after_template(statement):
    """The statement without `template <...>`."""
    if not statement.startswith("template <"):
        return statement
    depth = 0
    for place, letter in enumerate(statement):
        depth += (letter == "<") - (letter == ">")
        if depth == 0 and letter == ">":
            return after_template(statement[place + 1:].strip())
    return statement


def declared_by(statement):
    """What a statement declares, so that two equal ones are refused by the compiler; None for anything else."""
    statement = after_template(statement)
    if found := TEST.match(statement):
        return f"{found[1]}.{found[2]}"
    if found := TYPE.match(statement):
        return found[1]
    if found := FUNCTION.match(statement):
        return f"{found[1]}({', '.join(type_of(part) for part in parts(found[2]) if part.strip())})"
    found = ALIAS.match(statement) or VALUE.match(statement)
    return found[1] if found and not statement.startswith(("namespace ", "using namespace ")) else None


def statements(text):
    """(namespaces, line, text) of each statement of the namespaces of a file, up to its body."""
    inside, statement, line, begin, skipped, round_brackets = [], "", 1, 1, 0, 0
    for letter in plain(text):
        line += letter == "\n"
        if skipped:
            skipped += (letter == "{") - (letter == "}")
            continue
        round_brackets += (letter == "(") - (letter == ")")
        if round_brackets or letter not in "{};":
            begin = begin if statement.strip() else line
            statement += letter
            continue
        words = " ".join(statement.split())
        statement = ""
        if letter == "}":
            inside.pop()
        elif letter == "{" and (opened := NAMESPACE.match(words)):
            inside.append(opened[1])
        else:
            skipped = letter == "{"
            if words:
                yield "::".join(inside), begin, words


def names_of(path):
    """What a file declares in anonymous namespaces: (namespaces, name), with the line and the text of the first."""
    found = {}
    for inside, line, words in statements(path.read_text(encoding="utf-8")):
        name = declared_by(words)
        if name and "" in inside.split("::"):
            found.setdefault((inside, name), (line, words))
    return found


def check_folder(tree, folder):
    first = {}
    for path in sorted((tree / folder).rglob("*.cc")):
        where = path.relative_to(tree)
        for key, (line, words) in names_of(path).items():
            other, same = first.setdefault(key, (where, words))
            if other != where and not (words == same and ALIAS.match(words)):
                yield (f"{where}:{line}: '{key[1]}' is also in the anonymous namespace of {other}; give it another name, "
                       "or a header that both include: the sources of a wing are compiled together")


def check(tree):
    table = rooms.read(tree)
    folders = [folder for wing in table.wings for folder in (table.folder(wing), Path("tests") / wing)]
    return [problem for folder in folders for problem in check_folder(tree, folder)]


if __name__ == "__main__":
    sys.exit(rooms.report(check))
