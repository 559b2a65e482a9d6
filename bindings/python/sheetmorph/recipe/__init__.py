# SPDX-License-Identifier: LGPL-2.1-or-later
"""The recipe as a document: its schema, its typed model, its poses and the parts that it names."""

from __future__ import annotations

from .reading import named_in, read_json
from .structure import faults_against, schema, where_faults

__all__ = ["faults_against", "named_in", "read_json", "schema", "where_faults"]
