"""Formulas as MathML, which browsers draw without scripts, and without fonts from elsewhere.

KaTeX converts them in a process of Node.js.
"""

import time

from docutils import nodes
from sphinx.util import logging
from sphinxcontrib import katex

logger = logging.getLogger(__name__)

PATIENCE = 60.0  # seconds for starting KaTeX, and for a formula
ATTEMPTS = 20  # to connect
OPTIONS = {"output": "mathml", "throwOnError": True}

katex.STARTUP_TIMEOUT = katex.RENDER_TIMEOUT = PATIENCE


def start_katex():
    """Starts the process if it does not run.

    The package connects as soon as the file of the socket exists, some time before the process accepts
    connections.
    """
    for _ in range(ATTEMPTS):
        try:
            katex.KaTeXServer.get()
            return
        except ConnectionRefusedError:
            time.sleep(0.1)
    raise OSError(f"KaTeX has refused {ATTEMPTS} connections; does 'node' run?")


def mathml(node):
    start_katex()
    is_block = isinstance(node, nodes.math_block)
    try:
        converted = katex.render_latex(node.astext(), OPTIONS | {"displayMode": is_block})
    except katex.KaTeXError as error:
        logger.warning("KaTeX refuses the formula '%s': %s", node.astext(), error, location=node)
        return ""
    return f'<div class="formula">{converted}</div>' if is_block else converted


def convert(app, doctree, document):
    for kind in (nodes.math, nodes.math_block):
        for node in list(doctree.findall(kind)):
            node.replace_self(nodes.raw("", mathml(node), format="html"))


def setup(app):
    app.connect("doctree-resolved", convert)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
