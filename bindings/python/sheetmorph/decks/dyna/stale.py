# SPDX-License-Identifier: LGPL-2.1-or-later
"""Position-dependent data of an LS-DYNA deck that stay unchanged when nodes move."""

from __future__ import annotations

from ..model import Place
from ..numbers import parse_integer
from .cards import DynaCards, Section

_REASONS = {
    "INITIAL_STRESS": "an initial stress of the shape before",
    "INITIAL_STRAIN": "an initial strain of the shape before",
    "INITIAL_FOAM_REFERENCE_GEOMETRY": "a reference geometry of the shape before",
    "AIRBAG_REFERENCE_GEOMETRY": "a reference geometry of the shape before",
    "AIRBAG_SHELL_REFERENCE_GEOMETRY": "a reference geometry of the shape before",
    "BOUNDARY_PRESCRIBED_FINAL_GEOMETRY": "a final geometry for the shape before",
    "DEFINE_COORDINATE_SYSTEM": "a coordinate system by coordinates stays where it is",
    "DEFINE_COORDINATE_VECTOR": "a coordinate system by vectors stays as it is",
    "DEFINE_BOX": "a box by coordinates stays where it is",
    "ELEMENT_INERTIA": "its inertia is kept as it is",
    "PART_INERTIA": "its centre of gravity and inertia are kept as they are",
    "CONSTRAINED_NODAL_RIGID_BODY_INERTIA": "its inertia is kept as it is",
    "ELEMENT_SHELL_THICKNESS": "its thickness at the nodes is kept as it is",
    "ELEMENT_SHELL_BETA": "its material angle is kept as it is",
    "ELEMENT_SHELL_OFFSET": "its offset is kept as it is",
    "ELEMENT_BEAM_ORIENTATION": "its orientation is kept as it is",
    "ELEMENT_BEAM_OFFSET": "its offsets are kept as they are",
    "ELEMENT_SOLID_ORTHO": "its material axes are kept as they are",
    "PERTURBATION_NODE": "it shifts nodes of the shape before when the solver starts",
    "RIGIDWALL": "a rigid wall stays where it is",
    "INCLUDE_STAMPED": "what is mapped from forming belongs to the shape before",
    "DYNAIN": "results of the shape before",
}


def stale_of(cards: DynaCards, section: Section) -> list[Place]:
    """Return the keyword if moved nodes make it stale."""
    for name, reason in _REASONS.items():
        if section.name.startswith(name):
            rows = section.rows.tolist()
            number = parse_integer(cards.fields(rows[0], 10)[0]) if rows else 0
            return [Place(f"*{section.name}", number or 0, cards.file, section.line, reason)]
    return []
