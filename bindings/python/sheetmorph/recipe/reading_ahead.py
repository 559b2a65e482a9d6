# SPDX-License-Identifier: LGPL-2.1-or-later
"""CAD files that are read at once, each by a worker of its own."""

from __future__ import annotations

import os
import threading
from collections.abc import Mapping
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path
from types import TracebackType
from typing import Any

from ..files import PartFile, is_cad, read_part


class ReadAhead:
    """The files of some entries, as they are needed. As many CAD files as there are cores are read
    at once; other files are read when it is their turn. In its context; on leaving it, workers end.
    """

    def __init__(self, wanted: Mapping[str, tuple[Path, Mapping[str, float] | None]]):
        """wanted: by the place of its entry the path of a file and how it is meshed."""
        self._wanted = wanted
        self._is_over = threading.Event()
        self._pool = ThreadPoolExecutor(os.cpu_count() or 1)
        ahead = [key for key, (path, _) in wanted.items() if is_cad(path)]
        self._reading: dict[str, Future[PartFile]] = {
            key: self._pool.submit(read_part, *wanted[key], self._goes_on)
            for key in (ahead if len(ahead) > 1 else [])
        }

    def read(self, key: str) -> PartFile:
        """One of the files. Raises what read_part does."""
        if key in self._reading:
            return self._reading[key].result()
        path, meshing = self._wanted[key]
        return read_part(path, meshing)

    def _goes_on(self, *_: Any) -> bool:
        return not self._is_over.is_set()

    def __enter__(self) -> ReadAhead:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self._is_over.set()
        self._pool.shutdown(cancel_futures=True)
