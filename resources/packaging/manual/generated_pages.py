# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sphinx extension: replace `<!-- generated: NAME -->` in a page by what the program says."""
import re
from typing import Any

import reference
import workbench
from pygments.lexers.special import TextLexer

MARKER = re.compile(r"^<!-- generated: ([\w -]+) -->$", re.MULTILINE)


def expand(text: str) -> str:
    """Return the text of a page with its generated parts.

    Raises KeyError for a marker with an unknown name.
    """
    return MARKER.sub(lambda found: reference.PAGES[found.group(1)](), text)


def _read(_app: Any, _page: str, source: list[str]) -> None:
    source[0] = expand(source[0])


def setup(app: Any) -> dict[str, Any]:
    """Connect to the event that Sphinx sends for each page it reads."""
    app.connect("source-read", _read)
    app.connect("html-collect-pages", lambda _app: workbench.command_pages())
    app.add_lexer("obj", TextLexer)  # Pygments has none for OBJ files
    return {"parallel_read_safe": True, "parallel_write_safe": True}
