# SPDX-License-Identifier: LGPL-2.1-or-later
"""The GUI tests that need the kernel; imported by name, one file a topic."""

from checks_answering import *  # noqa: F401,F403
from checks_commands import *  # noqa: F401,F403
from checks_contacts import *  # noqa: F401,F403
from checks_decks import *  # noqa: F401,F403
from checks_dragging import *  # noqa: F401,F403
from checks_drawing import *  # noqa: F401,F403
from checks_faults import *  # noqa: F401,F403
from checks_features import *  # noqa: F401,F403
from checks_fields import *  # noqa: F401,F403
from checks_finding import *  # noqa: F401,F403
from checks_flow import *  # noqa: F401,F403
from checks_guide import *  # noqa: F401,F403
from checks_macro import *  # noqa: F401,F403
from checks_moving import *  # noqa: F401,F403
from checks_panels import *  # noqa: F401,F403
from checks_picking import *  # noqa: F401,F403
from checks_poses import *  # noqa: F401,F403
from checks_preferences import *  # noqa: F401,F403
from checks_preparing import *  # noqa: F401,F403
from checks_propagation import *  # noqa: F401,F403
from checks_reach import *  # noqa: F401,F403
from checks_sentences import *  # noqa: F401,F403
from checks_showing import *  # noqa: F401,F403
from checks_solids import *  # noqa: F401,F403
from checks_speed import *  # noqa: F401,F403
from checks_steel import *  # noqa: F401,F403
from checks_study import *  # noqa: F401,F403
from checks_thickness import *  # noqa: F401,F403
from checks_tree import *  # noqa: F401,F403
from checks_tutorial import *  # noqa: F401,F403
from checks_undo import *  # noqa: F401,F403
from checks_workbench import *  # noqa: F401,F403
