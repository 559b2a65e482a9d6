# SPDX-License-Identifier: LGPL-2.1-or-later
"""Certificates: read the files of a run again, measure them, judge them by criteria, report."""

from .certifying import Certifier, Inputs, NotCertified, Targets, certify
from .criteria import Criteria, read_criteria, shipped

__all__ = [
    "Certifier",
    "Inputs",
    "Criteria",
    "NotCertified",
    "Targets",
    "certify",
    "read_criteria",
    "shipped",
]
