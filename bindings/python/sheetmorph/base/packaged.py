# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that are part of the package, such as schemas."""

from __future__ import annotations

import json
from importlib import resources
from typing import Any


def packaged_text(package: str, name: str) -> str:
    """Return the text of a file beside the modules of a package."""
    return resources.files(package).joinpath(name).read_text("utf-8")


def packaged_json(package: str, name: str) -> dict[str, Any]:
    """Return the object in a JSON file beside the modules of a package."""
    found: dict[str, Any] = json.loads(packaged_text(package, name))
    return found
