# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kernel positions in Coin nodes: what is drawn is what was given, shaded up to the creases."""

import math

import numpy as np
import pytest

coin = pytest.importorskip("pivy.coin")
from sheetmorph import _coin  # noqa: E402

POINTS = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 1], [2, 1, 1]], dtype=float)
TRIANGLES = np.array([[0, 1, 2], [0, 2, 3], [1, 4, 5], [1, 5, 2]], np.int32)  # bent by 45 degrees


class Nodes:
    """The three nodes and what is in them."""

    def __init__(self):
        self.nodes = coin.SoCoordinate3(), coin.SoNormal(), coin.SoIndexedFaceSet()
        self.addresses = tuple(int(node.this) for node in self.nodes)

    def positions(self):
        return np.array([v.getValue() for v in self.nodes[0].point.getValues()])

    def normals(self):
        return np.array([v.getValue() for v in self.nodes[1].vector.getValues()])

    def indices(self, field):
        values = np.array(list(getattr(self.nodes[2], field).getValues()))
        assert (values.reshape(-1, 4)[:, 3] == -1).all()
        return values.reshape(-1, 4)[:, :3]


def shown(crease_degrees: float):
    nodes = Nodes()
    mesh = _coin.MeshNodes(nodes.addresses, POINTS, TRIANGLES, math.radians(crease_degrees))
    return nodes, mesh


def test_positions_and_faces_arrive_as_given():
    nodes, _ = shown(30)
    assert np.array_equal(nodes.positions(), POINTS)
    assert np.array_equal(nodes.indices("coordIndex"), TRIANGLES)


def test_shading_breaks_at_a_crease():
    nodes, _ = shown(30)
    corner = nodes.normals()[nodes.indices("normalIndex")]
    assert np.allclose(corner[:2], (0, 0, 1))
    assert np.allclose(corner[2:], np.array([-1, 0, 1]) / math.sqrt(2))


def test_shading_is_smooth_below_the_crease_angle():
    nodes, _ = shown(60)
    assert len(nodes.normals()) == len(POINTS)
    bend = nodes.normals()[nodes.indices("normalIndex")[0, 1]]
    assert 0.0 > bend[0] > -0.7 and np.isclose(np.linalg.norm(bend), 1.0)


def test_other_positions_come_with_their_own_normals():
    nodes, mesh = shown(30)
    turn = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])  # z becomes y
    mesh.show(np.ascontiguousarray(POINTS @ turn + (5, 6, 7)))
    assert np.allclose(nodes.positions(), POINTS @ turn + (5, 6, 7))
    corner = nodes.normals()[nodes.indices("normalIndex")]
    assert np.allclose(corner[:2], np.array([0, 0, 1]) @ turn)


def test_global_positions_are_shown_where_the_part_has_them():
    nodes, mesh = shown(30)
    rotation, base = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]]), np.array([10.0, 20, 30])
    mesh.show(POINTS @ rotation.T + base, rotation, base)
    assert np.allclose(nodes.positions(), POINTS)
    corner = nodes.normals()[nodes.indices("normalIndex")]
    assert np.allclose(corner[:2], (0, 0, 1))


def test_the_nodes_live_as_long_as_the_mesh():
    nodes, mesh = shown(30)
    assert [node.getRefCount() for node in nodes.nodes] == [2, 2, 2]
    del mesh
    assert [node.getRefCount() for node in nodes.nodes] == [1, 1, 1]


def test_a_degenerate_triangle_has_a_harmless_normal():
    nodes = Nodes()
    _coin.MeshNodes(nodes.addresses, np.zeros((3, 3)), TRIANGLES[:1], 0.5)
    assert np.isfinite(nodes.normals()).all()


def test_another_number_of_positions_is_refused():
    _, mesh = shown(30)
    with pytest.raises(ValueError, match="6 vertices, got 5"):
        mesh.show(POINTS[:5].copy())


def test_a_node_of_another_type_is_refused():
    nodes = Nodes()
    swapped = (nodes.addresses[1], nodes.addresses[0], nodes.addresses[2])
    with pytest.raises(ValueError, match="Coordinate3"):
        _coin.MeshNodes(swapped, POINTS, TRIANGLES, 0.5)


def test_a_triangle_outside_the_mesh_is_refused():
    with pytest.raises(ValueError, match="does not have"):
        _coin.MeshNodes(Nodes().addresses, POINTS, TRIANGLES + 3, 0.5)


def coloured(values, span=(1.0, 3.0)) -> np.ndarray:
    """The colours that values get on a ramp from black to white, grey where there is none."""
    material = coin.SoMaterial()
    ramp = np.repeat(np.linspace(0.0, 1.0, 256)[:, None], 3, axis=1)
    colours = _coin.ValueColours(int(material.this), ramp, (0.5, 0.25, 0.5))
    colours.show(np.array(values, float), span)
    return np.array([c.getValue() for c in material.diffuseColor.getValues()])


def test_values_are_colours_and_what_is_outside_has_the_colour_of_its_end():
    found = coloured([1.0, 2.0, 3.0, -9.0, 1e300])
    assert np.allclose(found[:, 0], (0, 0.5, 1, 0, 1), atol=0.003)
    assert np.allclose(found[:, 0], found[:, 2])


def test_where_there_is_no_value_the_colour_says_so():
    assert np.allclose(coloured([np.nan, np.inf]), (0.5, 0.25, 0.5))


def test_a_span_of_nothing_is_harmless():
    assert np.allclose(coloured([1.0, 5.0], (1.0, 1.0)), 0.0)


def test_a_material_is_needed():
    node = coin.SoNormal()
    with pytest.raises(ValueError, match="Material"):
        _coin.ValueColours(int(node.this), np.zeros((2, 3)), np.zeros(3))
