# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paths of the add-on's icons, panels and examples."""

import os

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
