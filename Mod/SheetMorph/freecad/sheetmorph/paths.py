# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paths of the add-on's icons, panels, examples and manual."""

import os
from pathlib import Path

# abspath, not realpath: a staged add-on may consist of links, next to its resources.
_ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
_RESOURCES = os.path.join(_ROOT, "resources")


def icon(name: str) -> str:
    """Return the absolute path of an icon; `name` has no suffix."""
    return os.path.join(_RESOURCES, "icons", f"{name}.svg")


def panel(name: str) -> str:
    """Return the absolute path of a panel's widgets; `name` has no suffix."""
    return os.path.join(_RESOURCES, "panels", f"{name}.ui")


def icons() -> str:
    """Return the absolute path of the folder of icons."""
    return os.path.join(_RESOURCES, "icons")


def translations() -> str:
    """Return the absolute path of the folder of compiled translations."""
    return os.path.join(_RESOURCES, "translations")


def examples() -> str:
    """Return the absolute path of the folder of examples."""
    return os.path.join(_RESOURCES, "examples")


def manual(page: str) -> str:
    """Return the address of a page of the installed manual, empty without that page."""
    path = Path(_ROOT, "manual", page)
    return path.as_uri() if path.is_file() else ""


def manual_of(command: str) -> str:
    """Return the address of the page of a command, empty without a manual."""
    return manual(f"command/{command}.html")
