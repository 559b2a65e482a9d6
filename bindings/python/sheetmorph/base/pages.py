# SPDX-License-Identifier: LGPL-2.1-or-later
"""HTML pages from the templates of the package; a page needs no network."""

from __future__ import annotations

import base64
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from .errors import FailedError

if TYPE_CHECKING:
    from jinja2 import Environment

_MOST = 8


def require_pages() -> None:
    """Check that pages can be written. Raises FailedError."""
    _environment()


def page(template: str, **content: object) -> str:
    """Return a page; a template is named by its path in the package, such as "study/page.html".

    Text in the content stays text, whatever characters it has. Raises FailedError.
    """
    return _environment().get_template(template).render(content)


@cache
def _environment() -> Environment:
    try:  # most commands write no page and start faster without the import
        from jinja2 import Environment, FileSystemLoader, StrictUndefined
    except ModuleNotFoundError:
        raise FailedError("no page can be written", "install python3-jinja2") from None

    made = Environment(
        loader=FileSystemLoader(Path(__file__).parents[1]),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    made.filters.update(number=_number, png=_png)
    made.policies["json.dumps_kwargs"] = {"ensure_ascii": False, "allow_nan": False}
    return made


def _number(value: object, factor: float = 1.0) -> object:
    """Return a value as a table shows it: a dash for None, the first of many, a rounded number."""
    if isinstance(value, list):
        return ", ".join(map(str, value[:_MOST])) + (", …" if len(value) > _MOST else "")
    return "–" if value is None else f"{factor * value:.4g}" if isinstance(value, float) else value


def _png(image: bytes) -> str:
    """Return a PNG image as an address that contains it."""
    return "data:image/png;base64," + base64.b64encode(image).decode("ascii")
