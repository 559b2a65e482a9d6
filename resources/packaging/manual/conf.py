# SPDX-License-Identifier: LGPL-2.1-or-later
"""Settings of Sphinx for the manual; `./sheetmorph docs` calls it with resources/docs as source."""
import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
# The manual describes the sources beside it, not an installed package.
sys.path[:0] = [str(HERE), str(ROOT / "bindings" / "python")]

_found = re.search(r"SheetMorph VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text("utf-8"))

project = "SheetMorph"
author = "The SheetMorph developers"
release = version = _found.group(1) if _found else ""
language = "en"

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "generated_pages"]
myst_enable_extensions = ["colon_fence", "deflist"]
myst_heading_anchors = 4

autodoc_member_order = "bysource"
autodoc_typehints = "signature"
add_module_names = False
python_use_unqualified_type_names = True

html_theme = "furo"
html_title = f"SheetMorph {version}"
html_logo = html_favicon = str(ROOT / "resources" / "icons" / "SheetMorph.svg")
html_copy_source = html_show_sourcelink = False
html_show_copyright = False
html_theme_options = {"navigation_with_keys": True}
