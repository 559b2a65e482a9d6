# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rooms of the workbench that see little: what each may import of the others."""

MAY_IMPORT = {
    "doors": set(),
    "kinds": set(),
    "paths": set(),
    "preferences": set(),
    "qt": set(),
    "garbage": {"qt"},
    "generations": set(),
    "tools": set(),
    "objects": {"doors", "generations", "kinds", "tools"},
    "bridge": {"kinds", "objects", "reporting", "tools"},
    "scene": {"bridge", "generations", "preferences", "qt", "tools"},
    "editing": {"generations", "kinds", "qt"},
    "interaction": {"actions", "api", "bridge", "garbage", "generations", "objects", "qt"}
    | {"scene", "tools"},
}
"""By room, a folder or a file at the top of the workbench. The others only stand in no circle."""


def room_faults(room: str, found: set[str]) -> list[str]:
    """What a room imports although it may not; `found`: the rooms that it imports."""
    allowed = MAY_IMPORT.get(room, found)
    return [f"{room} imports {other}" for other in sorted(found - allowed)]
