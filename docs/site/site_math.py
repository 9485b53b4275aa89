"""Formulas as MathML, which browsers draw without scripts, and without fonts from elsewhere.

KaTeX converts all formulas of a page in one run of Node.js, so that no process is left when the page is
written.
"""

import json
import subprocess
from importlib.util import find_spec
from pathlib import Path

from docutils import nodes
from sphinx.util import logging

logger = logging.getLogger(__name__)

SCRIPT = Path(__file__).with_name("formulas.js")
PATIENCE = 120  # seconds for the formulas of a page


def mathml(formulas):
    """What KaTeX writes for each formula {"latex": ..., "isBlock": ...}: {"html": ...} or {"error": ...}."""
    katex = Path(find_spec("sphinxcontrib.katex").origin).with_name("katex.min.js")
    done = subprocess.run(["node", SCRIPT, katex], input=json.dumps(formulas), timeout=PATIENCE, check=True,
                          stdout=subprocess.PIPE, text=True)
    return json.loads(done.stdout)


def element_of(node, converted):
    if "error" in converted:
        logger.warning("KaTeX refuses the formula '%s': %s", node.astext(), converted["error"], location=node)
        return ""
    if isinstance(node, nodes.math_block):
        return f'<div class="formula">{converted["html"]}</div>'
    return converted["html"]


def convert(app, doctree, document):
    found = [node for kind in (nodes.math, nodes.math_block) for node in doctree.findall(kind)]
    if not found:
        return
    formulas = [{"latex": node.astext(), "isBlock": isinstance(node, nodes.math_block)} for node in found]
    for node, converted in zip(found, mathml(formulas), strict=True):
        node.replace_self(nodes.raw("", element_of(node, converted), format="html"))


def setup(app):
    app.connect("doctree-resolved", convert)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
