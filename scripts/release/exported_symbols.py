#!/usr/bin/env python3
"""Prints the version script of the shared library: it exports what the public headers declare, and hides the rest.

usage: exported_symbols.py HEADERS LIBRARY VERSION [--nm NM]

HEADERS is include/somato, LIBRARY the static library with the same objects, VERSION the name of the version of the
symbols, such as SOMATO_1. docs/decisions/0050-packages.md says why there is no macro in the headers.
"""

import argparse
import re
import subprocess
from pathlib import Path

IGNORED = re.compile(r'//[^\n]*|/\*.*?\*/|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)\'',
                     re.MULTILINE | re.DOTALL)
TOKEN = re.compile(r"\w+|::|\[\[|\]\]|\S")
KINDS = ("class", "struct", "enum", "union")
# What the compiler makes for a type or a function besides its code.
MADE_FOR = re.compile(r"^(?:vtable for|VTT for|typeinfo for|typeinfo name for|guard variable for"
                      r"|(?:non-)?virtual thunk to|covariant return thunk to|TLS (?:init|wrapper) function for) ")


def without(tokens, opening, closing):
    """`tokens` without the parts from `opening` to `closing`, and without these."""
    kept, depth = [], 0
    for token in tokens:
        depth += token == opening
        if depth == 0:
            kept.append(token)
        depth -= token == closing and depth > 0
    return kept


def declared_by(tokens):
    """The name that a declaration up to its `;` or `{` declares, or None."""
    tokens = without(without(tokens, "[[", "]]"), "<", ">")
    tokens = [token for token in tokens if token not in ("template", "inline", "constexpr", "extern", "static", "final")]
    if not tokens or tokens[0] in ("using", "friend", "static_assert", "typedef", "concept"):
        return None
    if tokens[0] in KINDS:  # with its content; a type that is only mentioned may be internal
        if tokens[-1] != "{":
            return None
        names = [token for token in tokens[1:3] if token not in ("class", "struct")]
        return names[0] if names else None
    if "operator" in tokens:
        return "operator"
    end = next(tokens.index(sign) for sign in ("(", "=", "{", ";", "}") if sign in tokens)
    return tokens[end - 1] if end > 1 else None


def declared_names(text):
    """The qualified names that a header declares in its namespaces, in classes only those of the classes."""
    names, scopes, statement, skipped = set(), [], [], 0
    for token in TOKEN.findall(IGNORED.sub(" ", text)):
        if skipped:
            skipped += (token == "{") - (token == "}")
            continue
        if token not in ("{", "}", ";"):
            statement.append(token)
            continue
        if token == "{" and statement[:1] == ["namespace"]:
            scopes.append([part for part in statement[1:] if part != "::"])
        elif token == "{" and statement == ["extern"]:  # "C"; the string is gone
            scopes.append([])
        elif token == "}" and not statement:
            if scopes:
                scopes.pop()
        else:
            if name := declared_by(statement + [token]):
                names.add("::".join([part for scope in scopes for part in scope] + [name]))
            skipped = token == "{"
        statement = []
    return names


def qualified_name(symbol):
    """The qualified name in a demangled symbol, without results, arguments and arguments of templates."""
    symbol = MADE_FOR.sub("", symbol)
    depth, kept = 0, ""
    for place, sign in enumerate(symbol):
        if re.search(r"(?<!\w)operator$", kept) and depth == 0:
            break
        if sign == "(" and depth == 0 and not symbol.startswith("(anonymous", place):
            break
        depth += sign in "<(["
        if depth == 0:
            kept += sign
        depth -= sign in ">)]" and depth > 0
    return kept.strip().split(" ")[-1]


def is_declared(symbol, names):
    parts = qualified_name(symbol).split("::")
    return any("::".join(parts[:count]) in names for count in range(1, len(parts) + 1))


def defined_symbols(library, nm):
    """(symbol, demangled symbol) of each global symbol that the library defines."""
    lines = subprocess.run([nm, "-g", "-P", "--defined-only", library], check=True, text=True,
                           stdout=subprocess.PIPE).stdout.splitlines()
    symbols = sorted({line.split(" ")[0] for line in lines if re.match(r"\S+ [A-Zu] ", line)})
    demangled = subprocess.run(["c++filt"], input="\n".join(symbols), check=True, text=True,
                               stdout=subprocess.PIPE).stdout.splitlines()
    return list(zip(symbols, demangled, strict=True))


def version_script(symbols, version):
    lines = "".join(f"    {symbol};\n" for symbol in symbols)
    return f"{version} {{\n  global:\n{lines}  local:\n    *;\n}};\n"


def main():
    parser = argparse.ArgumentParser()
    for name in ("headers", "library", "version"):
        parser.add_argument(name)
    parser.add_argument("--nm", default="nm")
    given = parser.parse_args()
    names = set()
    for header in sorted(Path(given.headers).rglob("*.h")):
        names |= declared_names(header.read_text(encoding="utf-8"))
    exported = [symbol for symbol, shown in defined_symbols(given.library, given.nm) if is_declared(shown, names)]
    if not exported:
        raise SystemExit(f"exported_symbols: {given.library} defines nothing that {given.headers} declares")
    print(version_script(exported, given.version), end="")


if __name__ == "__main__":
    main()
