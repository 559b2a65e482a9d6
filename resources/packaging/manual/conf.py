# SPDX-License-Identifier: LGPL-2.1-or-later
"""Settings of Sphinx for the manual; `./sheetmorph docs` calls it with resources/docs as source."""
import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
# The manual describes the sources beside it, not an installed package.
sys.path[:0] = [str(HERE), str(ROOT / "bindings" / "python")]

_found = re.search(r"<version>([\d.]+)<", (ROOT / "package.xml").read_text("utf-8"))

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
html_static_path = ["static"]
html_css_files = ["manual.css"]
html_js_files = ["manual.js"]
smartquotes = False  # options begin with two hyphens

# Furo's own dark colours; that of Debian 12 has them only for readers who press its button.
_DARK = {
    "color-problematic": "#ee5151",
    "color-foreground-primary": "#ffffffcc",
    "color-foreground-secondary": "#9ca0a5",
    "color-foreground-muted": "#81868d",
    "color-foreground-border": "#666666",
    "color-background-primary": "#131416",
    "color-background-secondary": "#1a1c1e",
    "color-background-hover": "#1e2124ff",
    "color-background-hover--transparent": "#1e212400",
    "color-background-border": "#303335",
    "color-background-item": "#444",
    "color-brand-primary": "#2b8cee",
    "color-brand-content": "#368ce2",
    "color-highlighted-background": "#083563",
    "color-highlight-on-target": "#333300",
    "color-api-keyword": "var(--color-foreground-secondary)",
    "color-admonition-background": "#18181a",
    "color-card-border": "var(--color-background-secondary)",
    "color-card-background": "#18181a",
    "color-card-marginals-background": "var(--color-background-hover)",
}
html_theme_options = {"navigation_with_keys": True, "dark_css_variables": _DARK}
