# SPDX-License-Identifier: LGPL-2.1-or-later
"""Certificates: what a run wrote is read again, measured, judged by criteria, and told."""

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
