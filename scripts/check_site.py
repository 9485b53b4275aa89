#!/usr/bin/env python3
"""Checks the links of a folder of HTML pages, without a network.

- A link within the folder refers to a file in it and, if it has a fragment, to an element with that id.
- Other links are complete addresses of the web or of mail.
- Scripts, styles, pictures and fonts are in the folder, so that the pages need no network.

usage: check_site.py FOLDER
"""

import sys
from dataclasses import dataclass, field
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

LOADED = {("script", "src"), ("img", "src"), ("source", "src"), ("iframe", "src"), ("object", "data"),
          ("link", "href")}
NOT_LOADED = {"canonical", "index", "search", "next", "prev", "author", "license"}  # kinds of <link>


@dataclass
class Page:
    ids: set = field(default_factory=set)
    links: list = field(default_factory=list)  # (line, address, whether a browser loads it)


class Reader(HTMLParser):
    def __init__(self):
        super().__init__()
        self.page = Page()

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.page.ids.update(filter(None, (given.get("id"), given.get("name") if tag == "a" else None)))
        for name, value in attributes:
            is_loaded = (tag, name) in LOADED and given.get("rel") not in NOT_LOADED
            if value and (is_loaded or name in ("href", "src")):
                self.page.links.append((self.getpos()[0], value, is_loaded))


def read(path):
    reader = Reader()
    reader.feed(path.read_text(encoding="utf-8"))
    return reader.page


def problem_of_external(address, is_loaded):
    if address.scheme == "data":
        return None
    if is_loaded:
        return "is loaded from elsewhere"
    if address.scheme == "mailto" and "@" in address.path:
        return None
    if address.scheme in ("http", "https") and "." in address.netloc and " " not in address.geturl():
        return None
    return "is not a complete address"


def problem_of_internal(address, path, pages):
    target = path if not address.path else (path.parent / unquote(address.path)).resolve()
    if not target.is_file():
        return "does not exist"
    if target in pages and address.fragment and unquote(address.fragment) not in pages[target].ids:
        return "has no such anchor"
    return None


def problem_of(link, path, pages):
    _, text, is_loaded = link
    address = urlsplit(text)
    if address.scheme or address.netloc:
        return problem_of_external(address, is_loaded)
    return problem_of_internal(address, path, pages)


def problems_of(folder):
    folder = folder.resolve()
    pages = {path: read(path) for path in sorted(folder.rglob("*.html"))}
    found = {}
    for path, page in pages.items():
        for link in page.links:
            if problem := problem_of(link, path, pages):
                found.setdefault(f"{path.relative_to(folder)}: '{link[1]}' {problem}")
    return list(found)


def main():
    problems = problems_of(Path(sys.argv[1]))
    print(*problems, sep="\n", end="\n" if problems else "", file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
