# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is wrong with a morph, whom the sentence about it names, and what would mend it."""

from __future__ import annotations

from freecad.sheetmorph.kinds import ASSEMBLY, kind
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.tools.naming import named_in


def faults_in(document) -> dict[str, str]:
    """Return what the last recompute could not do, by object name of the assembly."""
    morphs = [obj for obj in document.Objects if kind(obj) == ASSEMBLY]
    found = {morph.Name: model.failure_of(morph) for morph in morphs}
    return {name: sentence for name, sentence in found.items() if sentence}


def named_by(assembly, sentence: str) -> list:
    """Return the regions and contacts that a sentence names, in its order."""
    found = {obj.Label: obj for obj in [*model.regions(assembly), *model.contacts(assembly)]}
    return [found[label] for label in named_in(sentence, found)]


def parts_named_by(assembly, sentence: str) -> list:
    """Return the parts that a sentence names, in its order."""
    found = {part.Label: part for part in model.parts(assembly)}
    return [found[label] for label in named_in(sentence, found)]


def new_fault(document, before: dict[str, str]) -> str:
    """Return the sentence about a morph that was sound `before`, if it names who is to blame.

    Where nobody is named something is still missing, and a step that leaves that open is none to
    refuse.
    """
    for name, sentence in faults_in(document).items():
        assembly = document.getObject(name)
        if name not in before and named_by(assembly, sentence):
            return sentence
    return ""
