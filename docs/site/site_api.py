"""Pages of the public interfaces, and a warning for each public symbol without documentation.

A page docs/reference/cpp/FOLDER.md receives the declarations of include/somato/FOLDER, as Doxygen read
them; docs/reference/python-api.md uses autodoc.
"""

import inspect
from pathlib import Path
from xml.etree import ElementTree

from docutils import nodes
from sphinx import addnodes
from sphinx.util import logging

logger = logging.getLogger(__name__)

PAGES = "docs/reference/cpp/"
SECTIONS = ("briefdescription detaileddescription innernamespace innerclass enum func typedef var define "
            "public-attrib public-func public-static-func public-static-attrib public-type")
# Members of these kinds must be documented outside classes; within, a name may be enough.
KINDS = {"function", "enum", "typedef", "variable", "define"}
COMPOUNDS = {"class", "struct", "union"}


def add_headers(app, document, source):
    folder = Path(app.srcdir) / "include/somato" / document.removeprefix(PAGES)
    if document.startswith(PAGES) and folder.is_dir():
        for header in sorted(folder.glob("*.h")):
            name = f"{folder.name}/{header.name}"
            source[0] += (f"\n## `{name}`\n\n```{{doxygenfile}} {header.name}\n"
                          f":sections: {SECTIONS}\n```\n")


def remove_namespaces(app, doctree):
    """Removes the level of the namespace, which is the same for all declarations."""
    for node in list(doctree.findall(addnodes.desc)):
        if node[0].astext() == "namespace somato":
            node.replace_self(nodes.container("", *node[1].children, ids=node[0]["ids"]))


def is_documented(element):
    return any("".join(element.find(f"{kind}description").itertext()).strip()
               for kind in ("brief", "detailed"))


def place_of(element):
    location = element.find("location")
    return f"include/{location.get('file')}", location.get("line")


def public_symbols(folder):
    """Elements of Doxygen's XML for all compounds, and for the functions and constants outside them."""
    for path in sorted(folder.glob("*.xml")):
        for compound in ElementTree.parse(path).getroot().findall("compounddef"):
            if compound.get("kind") in COMPOUNDS and compound.get("prot") != "private":
                yield compound.findtext("compoundname"), compound
            elif compound.get("kind") in ("namespace", "file"):
                for member in compound.iter("memberdef"):
                    if member.get("kind") in KINDS:
                        yield member.findtext("name"), member


def check_headers(app):
    headers = Path(app.srcdir) / "include/somato"
    for folder in sorted(path for path in headers.iterdir() if path.is_dir()):
        page = Path(app.srcdir) / f"{PAGES}{folder.name}.md"
        if not page.is_file():
            logger.warning("the folder include/somato/%s has no page %s", folder.name, page)
    places = {place_of(element): name
              for name, element in public_symbols(Path(app.config.breathe_projects["somato"]))
              if not is_documented(element)}
    for (path, line), name in sorted(places.items()):
        logger.warning("%s is public and not documented", name, location=f"{path}:{line}")


def check_docstring(app, what, name, thing, options, lines):
    is_inherited = not getattr(thing, "__module__", "pysomato").startswith("pysomato")
    if not any(lines) and not is_inherited and not inspect.ismodule(thing):
        logger.warning("%s is public and not documented", name)


def setup(app):
    app.connect("builder-inited", check_headers)
    app.connect("source-read", add_headers)
    app.connect("doctree-read", remove_namespaces)
    app.connect("autodoc-process-docstring", check_docstring, priority=900)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
