# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study: the varied numbers of a morph with their ranges, and the results."""

from __future__ import annotations

import json

from freecad.sheetmorph.objects.model import STUDY
from freecad.sheetmorph.objects.orphans import MemberProxy
from freecad.sheetmorph.objects.properties import HIDDEN, Property
from freecad.sheetmorph.tools import studies
from freecad.sheetmorph.tools.studies import METHODS, Parameter

CRITERIA_DOC = (
    "Criteria for every variant, such as: stretch <= 0.2, angle >= 12. "
    "Flipped triangles always fail"
)
FOLDER_DOC = "Folder for the recipe, the study and the variants. Empty: only the table is kept"


class StudyProxy(MemberProxy):
    """Proxy of a study; no object depends on it."""

    Type = STUDY
    PROPERTIES = (
        Property("String", "Parameters", "Study", "The parameters, as JSON", "", HIDDEN),
        Property(
            "LinkListHidden", "Owners", "Study", "Objects that own the parameters", mode=HIDDEN
        ),
        Property("Enumeration", "Sampling", "Study", "Sampling method", METHODS),
        Property("Integer", "Count", "Study", "Number of variants", 20),
        Property("Integer", "Seed", "Study", "Another seed gives other values", 1),
        Property("String", "Criteria", "Study", CRITERIA_DOC),
        Property("Path", "Folder", "Study", FOLDER_DOC),
        Property("String", "Results", "Study", "The table, as JSON", "", HIDDEN, is_output=True),
    )


def keep_parameters(study, parameters: list[Parameter]) -> None:
    """Store parameters, and links to the objects that own them."""
    study.Parameters = studies.to_text(parameters)
    study.Owners = [study.Document.getObject(name) for name in studies.owners(parameters)]


def kept_parameters(study) -> list[Parameter]:
    """Return the parameters whose objects still exist.

    In a copy the objects have other names, and the links identify them. A deleted object loses its
    link; then the names identify the others.
    """
    kept = studies.from_text(study.Parameters)
    names = studies.owners(kept)
    links = [owner.Name for owner in study.Owners if owner is not None]
    if len(links) == len(names):
        kept = studies.renamed(kept, dict(zip(names, links)))
    return [one for one in kept if study.Document.getObject(one.owner) is not None]


def kept_results(study) -> dict:
    """Return the table in the form of a study's summary.json, empty before the first run."""
    return json.loads(study.Results or "{}")
