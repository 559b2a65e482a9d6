# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fixtures of the package's tests: part files in a folder of their own."""

from __future__ import annotations

from pathlib import Path

import pytest

from part_samples import samples


@pytest.fixture(params=sorted(samples()))
def sample(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    """A part file of each kind, in its own folder."""
    path = tmp_path / request.param
    path.write_bytes(samples()[request.param])
    return path
