# SPDX-License-Identifier: LGPL-2.1-or-later
"""A vandal for as long as wanted: SHEETMORPH_VANDAL_ACTS=1000 SHEETMORPH_VANDAL_SEED=7
tests/gui/run.sh <add-on> vandal."""

from checks_vandal import *  # noqa: F401,F403
