# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is drawn is the same by the compiled module and, where that is left out, through pivy."""

import math
import sys

import numpy as np
import pytest

coin = pytest.importorskip("pivy.coin")
pytest.importorskip("sheetmorph._coin")
from freecad.sheetmorph.scene import drawing, nodes  # noqa: E402
from freecad.sheetmorph.tools import colour_scale  # noqa: E402

CREASE = math.radians(30.0)
TURN = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
BASE = np.array([10.0, 20.0, -3.0])


@pytest.fixture(autouse=True)
def nothing_chosen():
    drawing.chosen.cache_clear()
    yield
    drawing.chosen.cache_clear()


def channel(columns: int = 24) -> tuple[np.ndarray, np.ndarray]:
    """A bent sheet with a sharp flange, a fin of three triangles at one edge and one of no area."""
    u, v = np.meshgrid(np.linspace(0, 4, columns), np.linspace(0, 3, 7), indexing="ij")
    z = np.where(u > 3.0, 4.0 * (u - 3.0), 0.1 * np.sin(3.0 * u)) + 0.05 * v**2
    points = np.stack([u.ravel(), v.ravel(), z.ravel()], axis=1)
    index = np.arange(u.size).reshape(u.shape)
    a, b, c, d = index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]
    faces = [np.stack([p.ravel() for p in corners], 1) for corners in ((a, b, c), (a, c, d))]
    fin = np.array([[1, 0, len(points)], [0, 0, 1]])
    points = np.vstack([points, [0.0, 0.0, 5.0]])
    return points, np.concatenate([*faces, fin]).astype(np.int32)


class Drawn:
    """A mesh drawn by somebody, and what its nodes say then."""

    def __init__(self, drawer):
        self.points, self.triangles = channel()
        self.nodes = coin.SoCoordinate3(), coin.SoNormal(), coin.SoIndexedFaceSet()
        self.mesh = drawer.mesh_nodes(self.nodes, self.points, self.triangles, CREASE)

    def indices(self, field: str) -> np.ndarray:
        return np.array(list(getattr(self.nodes[2], field).getValues())).reshape(-1, 4)

    def said(self) -> tuple:
        normals = nodes.rows(self.nodes[1].vector)
        corners = normals[self.indices("normalIndex")[:, :3]]
        return nodes.rows(self.nodes[0].point), self.indices("coordIndex"), corners


@pytest.fixture
def both():
    return Drawn(drawing.Direct()), Drawn(drawing.ThroughPivy)


def assert_same(both) -> None:
    for direct, slow in zip(*(drawn.said() for drawn in both)):
        assert direct.shape == slow.shape
        assert np.abs(direct - slow).max() < 2e-5  # single precision, of coordinates up to 30


def test_a_mesh_at_rest_is_drawn_the_same(both):
    assert_same(both)


def test_moved_vertices_are_drawn_the_same(both):
    for drawn in both:
        drawn.mesh.show(drawn.points + 0.3 * np.sin(drawn.points[:, ::-1]))
    assert_same(both)


def test_global_positions_are_drawn_the_same(both):
    for drawn in both:
        drawn.mesh.show(drawn.points @ TURN.T + BASE, TURN, BASE)
    assert_same(both)
    assert np.allclose(both[1].said()[0], both[1].points, atol=1e-5)


def test_normals_are_shared_over_bends_and_not_over_creases(both):
    direct, slow = (drawn.indices("normalIndex")[:, :3].ravel() for drawn in both)
    pairs = {*zip(direct.tolist(), slow.tolist())}
    assert len(pairs) == len(set(direct.tolist())) == len(set(slow.tolist()))
    assert len(set(slow.tolist())) > len(both[1].points)  # vertices at the crease have several


def test_values_have_the_same_colours():
    values = np.array([0.0, 1.0, 0.51, np.nan, -4.0, 9.0, np.inf, 1e300])
    for span in ((0.0, 1.0), (2.0, 2.0), (0.5, 0.500001)):
        found = []
        for drawer in (drawing.Direct(), drawing.ThroughPivy):
            material = coin.SoMaterial()
            ramp = colour_scale.ramp(256)
            drawer.value_colours(material, ramp, colour_scale.MISSING).show(values, span)
            found.append(nodes.rows(material.diffuseColor))
        assert np.array_equal(*found), span


def patch_nodes(drawer, triangles, vertices) -> tuple:
    """What a drawer puts into the nodes of a patch, and whether it says that there is anything."""
    drawn = coin.SoIndexedFaceSet(), coin.SoIndexedLineSet(), coin.SoIndexedPointSet()
    is_any = drawer.show_patch(drawn, triangles, np.asarray(vertices, np.int32))
    return (is_any, *(list(node.coordIndex.getValues()) for node in drawn))


def test_a_patch_is_drawn_alike_whoever_draws_it():
    points, triangles = channel()
    random = np.random.default_rng(3)
    chosen = [[], [0], range(len(points)), [5, 5, 4]]
    chosen += [random.integers(0, len(points), count) for count in (3, 20, 60, 100, 300)]
    for vertices in chosen:
        found = [
            patch_nodes(one, triangles, vertices) for one in (drawing.Direct(), drawing.ThroughPivy)
        ]
        assert found[0] == found[1], vertices
    assert not patch_nodes(drawing.Direct(), triangles, [])[0]


def test_a_patch_is_facets_their_outline_and_the_vertices_left():
    strip = np.array([[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 5]], np.int32)
    _, faces, lines, points = patch_nodes(drawing.Direct(), strip, [0, 1, 2, 5])
    assert faces == [0, 1, 2, -1] and points == [5]
    assert lines == [0, 1, -1, 0, 2, -1, 1, 2, -1]
    assert patch_nodes(drawing.Direct(), strip, range(4))[2].count(-1) == 4  # not where two meet


def test_a_patch_has_no_negative_vertex():
    with pytest.raises(ValueError, match="negative"):
        patch_nodes(drawing.Direct(), np.zeros((0, 3), np.int32), [-1])


def test_the_compiled_module_is_used_where_it_fits():
    assert isinstance(drawing.drawer(), drawing.Direct)
    assert drawing.report() == "View: filled by the kernel."


def test_pivy_is_used_where_the_compiled_module_was_left_out(monkeypatch):
    monkeypatch.setitem(sys.modules, "sheetmorph._coin", None)
    assert drawing.drawer() is drawing.ThroughPivy
    assert "through pivy, slower (" in drawing.report() and "_coin" in drawing.report()


class _Other:
    """A module as it is when it was linked with another Coin than FreeCAD's."""

    @staticmethod
    def coin_version() -> str:
        return "SIM Coin 3.1.3"


def test_pivy_is_used_where_the_compiled_module_is_for_another_coin(monkeypatch):
    monkeypatch.setitem(sys.modules, "sheetmorph._coin", _Other)
    assert drawing.drawer() is drawing.ThroughPivy
    assert "it is built for SIM Coin 3.1.3, but FreeCAD draws with" in drawing.report()
