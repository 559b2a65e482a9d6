# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is done to open panels, in a FreeCAD of its own."""

from checks_hostile import *  # noqa: F401,F403
from checks_vandal import *  # noqa: F401,F403
