# SPDX-License-Identifier: LGPL-2.1-or-later
"""Position-dependent data of an LS-DYNA deck that stay unchanged when nodes move."""

from __future__ import annotations

from ..model import Place
from ..numbers import parse_integer
from .cards import DynaCards, Section

_REASONS = {
    "INITIAL_STRESS": "an initial stress of the undeformed shape",
    "INITIAL_STRAIN": "an initial strain of the undeformed shape",
    "INITIAL_FOAM_REFERENCE_GEOMETRY": "a reference geometry of the undeformed shape",
    "AIRBAG_REFERENCE_GEOMETRY": "a reference geometry of the undeformed shape",
    "AIRBAG_SHELL_REFERENCE_GEOMETRY": "a reference geometry of the undeformed shape",
    "BOUNDARY_PRESCRIBED_FINAL_GEOMETRY": "a final geometry for the undeformed shape",
    "DEFINE_COORDINATE_SYSTEM": "a coordinate system by coordinates stays where it is",
    "DEFINE_COORDINATE_VECTOR": "a coordinate system by vectors stays unchanged",
    "DEFINE_BOX": "a box by coordinates stays where it is",
    "ELEMENT_INERTIA": "its inertia stays unchanged",
    "PART_INERTIA": "its centre of gravity and inertia stay unchanged",
    "CONSTRAINED_NODAL_RIGID_BODY_INERTIA": "its inertia stays unchanged",
    "ELEMENT_SHELL_THICKNESS": "its thickness at the nodes stays unchanged",
    "ELEMENT_SHELL_BETA": "its material angle stays unchanged",
    "ELEMENT_SHELL_OFFSET": "its offset stays unchanged",
    "ELEMENT_BEAM_ORIENTATION": "its orientation stays unchanged",
    "ELEMENT_BEAM_OFFSET": "its offsets stay unchanged",
    "ELEMENT_SOLID_ORTHO": "its material axes stay unchanged",
    "PERTURBATION_NODE": "it shifts nodes of the undeformed shape when the solver starts",
    "RIGIDWALL": "a rigid wall stays where it is",
    "INCLUDE_STAMPED": "forming results belong to the undeformed shape",
    "DYNAIN": "results of the undeformed shape",
}


def stale_of(cards: DynaCards, section: Section) -> list[Place]:
    """Return the keyword if moved nodes make it stale."""
    for name, reason in _REASONS.items():
        if section.name.startswith(name):
            rows = section.rows.tolist()
            number = parse_integer(cards.fields(rows[0], 10)[0]) if rows else 0
            return [Place(f"*{section.name}", number or 0, cards.file, section.line, reason)]
    return []
