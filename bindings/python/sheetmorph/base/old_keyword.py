# SPDX-License-Identifier: LGPL-2.1-or-later
"""Old names of parameters, which scripts still use."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any, TypeVar, cast

Function = TypeVar("Function", bound=Callable[..., Any])


def old_keyword(old: str, new: str) -> Callable[[Function], Function]:
    """Return a decorator: the function also takes its parameter `new` by the name `old`."""

    def decorate(function: Function) -> Function:
        @functools.wraps(function)
        def call(*arguments: Any, **keywords: Any) -> Any:
            if old in keywords:
                keywords.setdefault(new, keywords.pop(old))
            return function(*arguments, **keywords)

        return cast(Function, call)

    return decorate
