# SPDX-License-Identifier: LGPL-2.1-or-later
"""GUI measurements that take too long for every run: tests/gui/run.sh <add-on> large."""

from checks_covers import *  # noqa: F401,F403
from checks_enclosure import *  # noqa: F401,F403
from checks_idle import *  # noqa: F401,F403
from checks_large import *  # noqa: F401,F403
from checks_memory import *  # noqa: F401,F403
from checks_memory import test_300_openings_of_move_handle_keep_no_shape  # noqa: F401
