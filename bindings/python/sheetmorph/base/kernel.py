# SPDX-License-Identifier: LGPL-2.1-or-later
"""The compiled kernel, loaded when it is first needed."""

from __future__ import annotations

import importlib
from types import ModuleType

from .errors import KernelError

KERNEL_API = 1
_TODO = "build and stage it again with ./sheetmorph build"


def load_kernel() -> ModuleType:
    """``sheetmorph._core``. Raises KernelError with one sentence if it cannot be used."""
    try:
        core = importlib.import_module("sheetmorph._core")
    except ImportError as error:
        reason = " ".join(str(error).split())
        what = f"the kernel sheetmorph._core cannot be loaded ({reason})"
        raise KernelError(what, _TODO) from None
    found = getattr(core, "KERNEL_API", None)
    if found != KERNEL_API:
        what = f"the kernel sheetmorph._core has interface {found}, but this package needs"
        raise KernelError(f"{what} {KERNEL_API}", _TODO)
    return core
