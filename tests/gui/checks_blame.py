# SPDX-License-Identifier: LGPL-2.1-or-later
"""What makes a motion impossible is red in the view before anyone asks."""

import numpy as np
from checks_faults import add_overlapping_handle, sentence
from checks_moving import open_panel
from checks_showing import found
from desk import child, enter, picture, press, settled, until
from freecad.sheetmorph.scene import colours
from pivy import coin
from scenes import new_morph, part, stored

__all__ = [
    "test_the_regions_at_fault_are_red_at_once",
    "test_triangles_that_flip_are_red_until_they_do_not",
]


def red_triangles() -> int:
    """The number of triangles of the part that are painted as a fault."""
    root, count = part().ViewObject.RootNode, 0
    for group in found(coin.SoSeparator, root):
        nodes = list(group.getChildren())
        looks = [n for n in nodes if n.isOfType(coin.SoMaterial.getClassTypeId())]
        if any(np.allclose(m.diffuseColor[0].getValue(), colours.FAULT) for m in looks):
            count += sum(n.coordIndex.getNum() // 4 for n in found(coin.SoIndexedFaceSet, group))
    return count


def test_the_regions_at_fault_are_red_at_once():
    yield from new_morph()
    yield from add_overlapping_handle()
    rest = stored()
    yield from open_panel()
    yield from until(sentence, "the fault")
    assert red_triangles() > 0
    picture("blame-regions")
    yield from press(child("mend_fault").text())
    yield from until(lambda: not sentence(), "the repair")
    assert red_triangles() == 0
    yield from press("Cancel")
    assert red_triangles() == 0 and np.array_equal(stored(), rest)


def test_triangles_that_flip_are_red_until_they_do_not():
    yield from new_morph()
    rest = stored()
    yield from open_panel()
    assert red_triangles() == 0
    yield from enter(child("angle"), "100")
    yield from until(lambda: red_triangles() > 0, "the red triangles")
    yield from settled()
    assert "onto a neighbour" in child("staying").text(), child("staying").text()
    picture("blame-triangles")
    yield from enter(child("angle"), "2")
    yield from settled()
    assert red_triangles() == 0
    yield from enter(child("angle"), "100")
    yield from until(lambda: red_triangles() > 0, "the red triangles again")
    yield from press("Cancel")
    assert red_triangles() == 0 and np.array_equal(stored(), rest)
