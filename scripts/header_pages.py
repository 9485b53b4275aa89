#!/usr/bin/env python3
"""Lists the public headers on the pages of docs/reference/cpp: a sentence of each, and what it declares.

usage: header_pages.py [--check] [TREE]     --check: fails where a page differs, and writes nothing
"""

import re
import sys
from pathlib import Path

TREE = Path(__file__).resolve().parent.parent
HEAD = "| header | content | declares |\n|---|---|---|\n"
TYPE = re.compile(r"(?:class|struct|enum class|enum|concept)\s+(\w+)(?=\s*(?:final)?\s*(?:[:{=]|$))")
ALIAS = re.compile(r"using\s+(\w+)\s*=")
FUNCTION = re.compile(r"(operator\S+|\w+)\s*\(")
CONSTANT = re.compile(r"\b(\w+)\s*(?:=|\{)")
NOT_OF_USERS = re.compile(r"^namespace detail \{.*?^\}", re.MULTILINE | re.DOTALL)


def declared_in(declaration):
    """The name that a declaration declares, or nothing."""
    if declaration.startswith("friend"):
        return None
    if found := TYPE.match(declaration) or ALIAS.match(declaration):
        return found[1]
    if "(" in declaration.split("=")[0]:
        return FUNCTION.search(declaration)[1] + "()"
    found = CONSTANT.search(declaration)
    return found[1] if found else None


def documented(text):
    """(name, first sentence) of the documented declarations of a header, in their order."""
    text = NOT_OF_USERS.sub("", text)
    for found in re.finditer(r"^((?:///[^\n]*\n)+)(.*)$((?:\n.+)?)", text, re.MULTILINE):
        words = " ".join(line.removeprefix("///").strip() for line in found[1].splitlines())
        declaration = re.sub(r"^template <.*?>\s*(?:requires .*)?", "", found[2] + found[3].replace("\n", " "))
        if name := declared_in(declaration.strip()):
            yield name, re.split(r"(?<=[.:])\s+(?=[A-Z`(]|$)", words)[0].rstrip(":").replace("|", "\\|")


def plain(name):
    return re.sub(r"[^a-z0-9]", "", name.lower())


def named_like(header, names):
    """The declaration that the header is named after, or else its first one."""
    stem = plain(header.stem)
    ranked = [lambda name: name in (stem, stem.removesuffix("s")), lambda name: stem in name]
    return next((name for fits in ranked for name in names if fits(plain(name))), names[0])


def row(header):
    found = {}
    for name, sentence in documented(header.read_text(encoding="utf-8")):
        found.setdefault(name, sentence.rstrip(".") + ".")
    if not found:
        sys.exit(f"{header}: no declaration has a comment that begins with ///")
    names = ", ".join(f"`{name}`" for name in found)
    link = f"../../../include/somato/{header.parent.name}/{header.name}"
    return f"| [{header.name}]({link}) | {found[named_like(header, list(found))]} | {names} |\n"


def page_with_headers(page, folder):
    """The text of a page with the table of the headers in `folder` at its end."""
    text = page.read_text(encoding="utf-8")
    introduction = text.split(HEAD)[0].rstrip("\n")
    return f"{introduction}\n\n{HEAD}" + "".join(row(header) for header in sorted(folder.glob("*.h")))


def main():
    trees = [Path(word) for word in sys.argv[1:] if word != "--check"]
    tree = trees[0] if trees else TREE
    differing = []
    for page in sorted((tree / "docs/reference/cpp").glob("*.md")):
        text = page_with_headers(page, tree / "include/somato" / page.stem)
        if text == page.read_text(encoding="utf-8"):
            continue
        differing.append(page)
        if "--check" not in sys.argv[1:]:
            page.write_text(text, encoding="utf-8")
    if "--check" not in sys.argv[1:]:
        return 0
    for page in differing:
        print(f"{page.relative_to(tree)}: its headers have changed; run scripts/header_pages.py", file=sys.stderr)
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
