"""Navigation from the tables of docs/README.md, and pages for folders that links refer to."""

import os
import re
from html import escape
from pathlib import Path

from docutils import nodes
from sphinx import addnodes
from sphinx.transforms.post_transforms import SphinxPostTransform

CONTENTS = "docs/README"
SECTION = re.compile(r"^## (.+)$", re.MULTILINE)
ROW = re.compile(r"^\|.*\|$", re.MULTILINE)
LINK = re.compile(r"\]\(([^)#]+)\)")
LARGEST_SHOWN = 100_000  # bytes of a file


def toctree(lines, *options):
    return "\n".join(["", "```{toctree}", *options, "", *lines, "```", ""])


def document_of(link):
    """The document of a link in docs/README.md: a page, or the README.md of a folder."""
    path = os.path.normpath(os.path.join("docs", link))
    return "/" + (re.sub(r"\.(md|ipynb)$", "", path) if path.endswith((".md", ".ipynb")) else f"{path}/README")


def navigation(text):
    """A toctree for each section of docs/README.md, with the pages of its table."""
    titles = SECTION.split(text)[1:]
    for title, section in zip(titles[::2], titles[1::2]):
        if links := LINK.findall("\n".join(ROW.findall(section))):
            yield toctree(map(document_of, links), ":hidden:", f":caption: {title}")


def add_navigation(app, document, source):
    """Adds what the Markdown of a forge cannot express: the order and the hierarchy of the pages."""
    if document == CONTENTS:
        source[0] += "".join(navigation(source[0]))
    elif document.startswith("docs/") and document.endswith("/README"):
        source[0] += toctree(["*"], ":glob:")


class FolderLinks(SphinxPostTransform):
    """Resolves links to folders: to the README.md of the folder, or to a page that lists its files."""

    default_priority = 8  # just before the links that MyST resolves

    def run(self):
        for node in list(self.document.findall(addnodes.pending_xref)):
            if node["reftype"] == "myst" and (folder := self.folder(node)):
                page = f"{folder}/README"
                if page not in self.env.found_docs:
                    page = f"{folder}/index"
                    self.env.somato_folders.add(folder)
                target = self.app.builder.get_relative_uri(self.env.docname, page)
                node.replace_self(nodes.reference("", "", *node.children, refuri=target, internal=True))

    def folder(self, node):
        """The folder of the tree that a link refers to, or None."""
        path = os.path.normpath(os.path.join(os.path.dirname(self.env.docname), node["reftarget"]))
        return path if (Path(self.env.srcdir) / path).is_dir() and not path.startswith("..") else None


def shown(app, path):
    """HTML of a file: its name, and its content on demand."""
    language = {".toml": "toml", ".json": "json"}.get(path.suffix, "text")
    content = app.builder.highlighter.highlight_block(path.read_text(encoding="utf-8"), language)
    return f"<details><summary><code>{escape(path.name)}</code></summary>{content}</details>"


def folder_pages(app):
    """A page for each folder without README.md that a link refers to."""
    for folder in sorted(app.env.somato_folders):
        files = sorted(path for path in (Path(app.srcdir) / folder).iterdir()
                       if path.is_file() and path.stat().st_size < LARGEST_SHOWN)
        body = f"<h1>{escape(folder)}</h1>\n" + "\n".join(shown(app, path) for path in files)
        yield f"{folder}/index", {"title": folder, "body": body}, "page.html"


def begin(app):
    app.env.somato_folders = set()


def setup(app):
    app.connect("builder-inited", begin)
    app.connect("source-read", add_navigation)
    app.add_post_transform(FolderLinks)
    app.connect("html-collect-pages", folder_pages)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
