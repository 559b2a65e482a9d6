# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the add-on keeps its icons, panels and examples."""

import os

# abspath, not realpath: a staged add-on may consist of links, and its resources lie beside them.
_ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
_RESOURCES = os.path.join(_ROOT, "resources")


def icon(name: str) -> str:
    """Absolute path of an icon, without its suffix in ``name``."""
    return os.path.join(_RESOURCES, "icons", f"{name}.svg")


def panel(name: str) -> str:
    """Absolute path of a panel's widgets, without the suffix in ``name``."""
    return os.path.join(_RESOURCES, "panels", f"{name}.ui")


def icons() -> str:
    """Absolute path of the folder of the icons."""
    return os.path.join(_RESOURCES, "icons")


def translations() -> str:
    """Absolute path of the folder of the compiled translations."""
    return os.path.join(_RESOURCES, "translations")


def examples() -> str:
    """Absolute path of the folder of the example assemblies."""
    return os.path.join(_RESOURCES, "examples")
