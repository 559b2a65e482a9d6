# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colours of roles, the same in the 3D view and in the legend."""

import colorsys
from collections.abc import Mapping

from freecad.sheetmorph import preferences

Colour = tuple[float, float, float]


class Preferred(Mapping):
    """Colours by key, from the preferences or with default values."""

    def __init__(self, **defaults: tuple[str, Colour]):
        """Create the colours; `defaults` maps preference entries to (key, default)."""
        self._entries = {key: (entry, colour) for entry, (key, colour) in defaults.items()}

    def __getitem__(self, key: str) -> Colour:
        return preferences.get_colour(*self._entries[key])

    def __iter__(self):
        return iter(self._entries)

    def __len__(self) -> int:
        return len(self._entries)


ROLES = Preferred(
    ColourFixed=("fixed", (0.12, 0.44, 0.77)),
    ColourHandle=("handle", (0.94, 0.54, 0.11)),
    ColourFeature=("form feature", (0.06, 0.64, 0.49)),
    ColourFollower=("follower", (0.53, 0.34, 0.72)),
)
SIDES = Preferred(
    ColourSideA=("a", (0.86, 0.16, 0.44)),
    ColourSideB=("b", (0.02, 0.66, 0.78)),
)
FAULT = (0.87, 0.16, 0.14)
HOVER = (1.0, 0.93, 0.45)
SHEET = (0.80, 0.84, 0.88)
WIRES = (0.36, 0.20, 0.58)
GHOST = (0.95, 0.96, 1.0)
MARKS = (1.0, 0.97, 0.82)
SNAP = (0.95, 0.20, 0.85)
MEASURE = (1.0, 0.90, 0.15)
EDGES = (0.25, 0.32, 0.40)


def of_number(number: int) -> Colour:
    """Return the colour of one of many items, clearly different from its neighbours."""
    hue = (0.11 + 0.618034 * number) % 1.0
    return colorsys.hls_to_rgb(hue, 0.62, 0.55)


def css(colour: Colour) -> str:
    """Return a colour with components 0 to 1 in the notation of Qt style sheets, as `#1f70c4`."""
    return "#" + "".join(f"{round(255 * c):02x}" for c in colour)


def light(colour: Colour) -> Colour:
    """Return a light tint of a colour, for the surroundings of a coloured region."""
    return tuple(0.35 * c + 0.65 for c in colour)
