"""Configuration of the documentation site for Sphinx (docs/decisions/0027-documentation-site.md)."""

import functools
import os
import re
import sys
from pathlib import Path

from nbclient import NotebookClient

HERE = Path(__file__).resolve().parent
TREE = HERE.parent.parent
sys.path.insert(0, str(HERE))

project = "Somato"
author = "Somato contributors"
copyright = author  # noqa: A001: the name that Sphinx reads
version = release = re.search(r"project\(somato VERSION ([0-9.]+)",
                              (TREE / "CMakeLists.txt").read_text(encoding="utf-8"))[1]

extensions = ["myst_nb", "breathe", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx_copybutton",
              "site_pages", "site_api", "site_math"]

FOLDERS_WITHOUT_PAGES = [path.name for path in TREE.iterdir()
                         if path.name not in ("docs", "examples", "src", "program", "tests") and path.is_dir()]
# The pages stay where they are, so that their links are those of the repository.
root_doc = "docs/README"
include_patterns = ["docs/**", "README.md", "ARCHITECTURE.md", "CHANGELOG.md", "CONTRIBUTING.md", "STYLE.md",
                    "SECURITY.md", "examples/**", "src/*/README.md", "program/README.md", "tests/golden/README.md"]
exclude_patterns = ["docs/site", "docs/pictures", *FOLDERS_WITHOUT_PAGES]

myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 6
nb_execution_mode = "force"
# The limits end broken notebooks only: on a busy machine a kernel may start for minutes. That of the start
# is no setting of MyST-NB.
nb_execution_timeout = KERNEL_START = 1800
NotebookClient.__init__ = functools.partialmethod(NotebookClient.__init__, startup_timeout=KERNEL_START)
nb_execution_show_tb = True

breathe_projects = {"somato": os.environ.get("SOMATO_DOXYGEN", "")}
breathe_default_project = "somato"
# Each header opens the namespace again.
suppress_warnings = ["duplicate_declaration.cpp"]
toc_object_entries = False
napoleon_use_ivar = True
autodoc_member_order = "bysource"

html_theme = "furo"
html_title = f"Somato {version}"
html_static_path = ["static"]
html_css_files = ["site.css"]
templates_path = ["templates"]
html_additional_pages = {"index": "title.html"}
html_show_sourcelink = False
html_show_search_summary = False  # would read pages over the network
html_copy_source = False
