# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every door of the kernel, with arrays nobody should hand in: words or a finite answer."""

import inspect

import hostile
import numpy as np
import pytest
from hostile import assert_sound
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from plates import ends, plate_with_holes

from sheetmorph import _core

drawn = settings(
    max_examples=150,
    deadline=None,
    derandomize=True,
    database=None,
    suppress_health_check=list(HealthCheck),
)

ARRAYS = (hostile.points(), hostile.triangles())
MESH = (hostile.meshes(),)
NUMBER, INTEGER, IDS, VECTOR = hostile.numbers, hostile.integers, hostile.ids(), hostile.vectors


def screen():
    return _core.Screen(np.diag([0.1, 0.1, 0.1, 1.0]), 640.0, 480.0)


# What each door is handed, by name: as in the signature.
DOORS = {
    "TriangleMesh": (_core.TriangleMesh, *ARRAYS),
    "PickingTree": (_core.PickingTree, *ARRAYS),
    "quality": (_core.quality, *ARRAYS),
    "vertex_quality": (_core.vertex_quality, *ARRAYS),
    "compare_quality": (_core.compare_quality, hostile.points(), *ARRAYS),
    "vertex_normals": (_core.vertex_normals, *ARRAYS),
    "feature_shape": (_core.feature_shape, *ARRAYS, IDS),
    "first_hit": (_core.first_hit, *ARRAYS, VECTOR, VECTOR),
    "fit_circle": (_core.fit_circle, hostile.points()),
    "split_polygon": (_core.split_polygon, hostile.points(), IDS),
    "split_quads": (
        lambda points, ids: _core.split_quads(points, np.array([ids[:4]])),
        hostile.points(),
        st.lists(st.one_of(st.integers(0, 8), hostile.integers), min_size=3, max_size=4),
    ),
    "rotation_log": (_core.rotation_log, VECTOR, NUMBER),
    "rotation_matrix": (_core.rotation_matrix, VECTOR),
    "RigidMotion": (
        lambda *given: _core.RigidMotion(*given[:3]).apply(given[3]),
        VECTOR,
        VECTOR,
        VECTOR,
        hostile.points(),
    ),
    "components": (_core.components, *MESH),
    "boundary_loops": (_core.boundary_loops, *MESH),
    "boundary_loop_at": (_core.boundary_loop_at, *MESH, INTEGER),
    "grow_rings": (_core.grow_rings, *MESH, IDS, INTEGER),
    "shrink_rings": (_core.shrink_rings, *MESH, IDS, INTEGER),
    "grow_to_creases": (_core.grow_to_creases, *MESH, INTEGER, NUMBER),
    "connected_triangles": (_core.connected_triangles, *MESH, INTEGER),
    "triangles_with_all_vertices": (_core.triangles_with_all_vertices, *MESH, IDS),
    "vertices_of_triangles": (_core.vertices_of_triangles, *MESH, IDS),
    "round_holes": (_core.round_holes, *MESH, NUMBER),
    "diagnose": (_core.diagnose, *MESH, NUMBER),
    "cured": (_core.cured, *MESH, NUMBER),
    "self_intersections": (_core.self_intersections, *MESH),
    "remeshed": (_core.remeshed, *MESH, NUMBER, st.booleans()),
    "find_thin_solid": (_core.find_thin_solid, *MESH, NUMBER),
    "find_features": (_core.find_features, *MESH),
    "flatten": (
        lambda mesh, rim, along, longer, is_told: _core.flatten(
            mesh, [rim, rim], (along, longer) if is_told else None
        ),
        *MESH,
        IDS,
        hostile.points(),
        IDS,
        st.booleans(),
    ),
    "Screen": (
        lambda matrix, width, height: _core.Screen(matrix, width, height),
        st.lists(NUMBER, min_size=16, max_size=16).map(lambda all: np.reshape(all, (4, 4))),
        NUMBER,
        NUMBER,
    ),
    "vertices_inside": (
        lambda mesh, outline: _core.vertices_inside(
            _core.PickingTree(mesh.points, mesh.triangles), screen(), outline
        ),
        *MESH,
        st.lists(st.tuples(NUMBER, NUMBER), max_size=5).map(lambda all: np.reshape(all, (-1, 2))),
    ),
    "visible_vertices": (
        lambda mesh, ids, other: _core.visible_vertices(
            _core.PickingTree(mesh.points, mesh.triangles), ids, screen(), [other]
        ),
        *MESH,
        IDS,
        st.one_of(st.none(), MESH[0].map(lambda m: _core.PickingTree(m.points, m.triangles))),
    ),
    "find_contacts": (
        lambda a, b, thickness, ends: _core.find_contacts(
            [_core.ContactPart(a, thickness), _core.ContactPart(b)], [ends]
        ),
        *MESH,
        *MESH,
        NUMBER,
        st.lists(st.one_of(st.integers(0, 3), hostile.integers), min_size=4, max_size=4),
    ),
    "proposed_gap": (
        lambda a, b, thickness: _core.proposed_gap(
            [_core.ContactPart(a, thickness), _core.ContactPart(b)]
        ),
        *MESH,
        *MESH,
        NUMBER,
    ),
}
# Reached through other doors, without arguments, or taking what the program itself gives.
ELSEWHERE = {"abi_info", "return_freed_memory", "thickness_change", "without_traceback"}


@pytest.mark.parametrize("door", DOORS)
@drawn
@given(data=st.data())
def test_a_door_refuses_in_words_or_answers_finitely(door, data):
    call, *arguments = DOORS[door]
    drawn_ones = [data.draw(argument) for argument in arguments]
    assert_sound(lambda: call(*drawn_ones))


def test_every_function_of_the_kernel_is_a_door_here():
    functions = {name for name, value in vars(_core).items() if inspect.isbuiltin(value)}
    assert functions - ELSEWHERE <= set(DOORS)


@drawn
@given(
    mesh=hostile.meshes(),
    origin=VECTOR,
    direction=VECTOR,
    moved=hostile.points(),
)
def test_a_picking_tree_refuses_in_words_or_answers_finitely(mesh, origin, direction, moved):
    tree = _core.PickingTree(mesh.points, mesh.triangles)
    assert_sound(lambda: tree.refit(moved))
    assert_sound(lambda: tree.nearest_hit(origin, direction))
    assert_sound(lambda: tree.nearest_point(origin))


@drawn
@given(mesh=hostile.meshes(), ids=IDS, number=hostile.integers, angle=hostile.numbers)
def test_a_neighbourhood_refuses_in_words_or_answers_finitely(mesh, ids, number, angle):
    around = _core.Neighbourhood(mesh)
    assert_sound(lambda: around.triangles_at(ids))
    assert_sound(lambda: around.grown(ids, number))
    assert_sound(lambda: around.shrunk(ids, number))
    assert_sound(lambda: around.face(number, angle))
    assert_sound(lambda: around.piece(number))
    assert_sound(lambda: around.pieces(ids))
    assert_sound(lambda: around.rims(angle))


def sheet_box():
    """A closed box of 40 x 30 x 2 mm: a sheet as a solid."""
    x, y = np.meshgrid(np.linspace(0.0, 40.0, 9), np.linspace(0.0, 30.0, 7))
    flat = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])
    first = (np.arange(6)[:, None] * 9 + np.arange(8)).ravel()
    a, b, c, d = first, first + 1, first + 10, first + 9
    top = np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    rim = np.concatenate(
        [np.arange(9), 9 * np.arange(1, 7) + 8, 54 + np.arange(7, -1, -1), 9 * np.arange(5, 0, -1)]
    )
    after = np.roll(rim, -1)
    wall = np.concatenate(
        [np.column_stack([rim, rim + 63, after + 63]), np.column_stack([rim, after + 63, after])]
    )
    points = np.concatenate([flat + [0.0, 0.0, 2.0], flat])
    return points, np.concatenate([top, top[:, ::-1] + 63, wall]).astype(np.int32)


def test_a_thin_solid_is_measured_on_its_own_mesh_alone():
    points, triangles = sheet_box()
    mesh = _core.TriangleMesh(points, triangles)
    solid, reason = _core.find_thin_solid(mesh)
    assert solid is not None, reason
    assert _core.thickness_change(mesh, solid, points).worst < 1e-9
    smaller = _core.TriangleMesh(points[:63], triangles[:96])
    with pytest.raises(ValueError, match="found on another mesh"):
        _core.thickness_change(smaller, solid, points[:63])
    with pytest.raises(ValueError, match="63 positions"):
        _core.thickness_change(mesh, solid, points[:63])


def plate_assembly(**changes):
    """A plate with three holes between a fixed and a moved end; some of it replaced."""
    points, triangles, rims = plate_with_holes(rim=16, rings=3)
    left, right = ends(points)
    # As decks have them: nodes in no element, one before all others.
    points = np.concatenate([[[5.0, 5.0, 9.0]], points, points[:1]])
    shift = [[vertex + 1 for vertex in ids] for ids in (left, right, *rims)]
    mesh = _core.TriangleMesh(points, triangles + 1)
    given = {"ids": None, "fixed": shift[0], "handle": shift[1], "feature": shift[2]}
    given |= {"triangle": 0, "barycentric": [0.2, 0.3, 0.5], "part": 0, "size": None}
    given |= {"translation": [0.0, 0.0, 5.0], "log": [0.0, 0.1, 0.0], "target": [0.0, 0.0, 1.0]}
    given |= changes
    whole = _core.Assembly([_core.Part("plate", mesh, given["ids"])])
    whole.fixed = [_core.Region("root", given["part"], given["fixed"])]
    whole.handles = [_core.Handle("tip", 0, given["handle"])]
    whole.features = [_core.FormFeature("hole", 0, given["feature"], size=given["size"])]
    if "triangle" in changes or "barycentric" in changes or "target" in changes:
        place = _core.PointConstraint("pin", 0, given["triangle"], given["barycentric"])
        whole.points = [place]
    return whole, given


def deformed(**changes):
    whole, given = plate_assembly(**changes)
    session = _core.DeformationSession(whole)
    pose = _core.Pose()
    pose.move_handle("tip", _core.RigidMotion(given["translation"], given["log"]))
    if whole.points:
        pose.place_point("pin", given["target"])
    drag = session.begin_drag(["tip"])
    drag.wait()
    return session.deform(pose).positions(0), np.array(drag.frame(pose).positions(0))


@pytest.mark.parametrize("size", [None, 20.0])
def test_nodes_in_no_element_do_no_harm(size):
    exact, live = deformed(size=size)
    assert np.isfinite(exact).all() and np.abs(exact - live).max() < 1e-6 * 190


CHANGES = {
    "ids": hostile.ids(),
    "fixed": hostile.ids(),
    "handle": hostile.ids(),
    "feature": hostile.ids(),
    "triangle": hostile.integers,
    "part": hostile.integers,
    "size": hostile.numbers,
    "barycentric": hostile.vectors,
    "target": hostile.vectors,
    "translation": hostile.vectors,
    "log": hostile.vectors,
}


@pytest.mark.parametrize("name", CHANGES)
@settings(drawn, max_examples=25)
@given(data=st.data())
def test_a_session_refuses_in_words_or_answers_finitely(name, data):
    value = data.draw(CHANGES[name])
    assert_sound(lambda: deformed(**{name: value}))


@pytest.mark.parametrize("is_thin", [False, True])
@pytest.mark.parametrize("is_symmetric", [False, True])
@pytest.mark.parametrize("triangle", [-1, 10**6, 2**31 - 1])
def test_a_point_on_a_triangle_that_is_not_there_is_refused(triangle, is_symmetric, is_thin):
    points, triangles = sheet_box()
    part = _core.Part("box", _core.TriangleMesh(points, triangles))
    if is_thin:
        part.make_thin(True)
    whole = _core.Assembly([part])
    whole.fixed = [_core.Region("root", 0, np.flatnonzero(points[:, 0] < 1.0))]
    whole.points = [_core.PointConstraint("pin", 0, triangle, [1.0, 0.0, 0.0])]
    if is_symmetric:
        whole.symmetry = _core.SymmetryPlane([0.0, 15.0, 0.0], [0.0, 1.0, 0.0])
    with pytest.raises(ValueError, match="part 'box': point 'pin' lies on triangle"):
        _core.DeformationSession(whole)


@pytest.mark.parametrize("is_thin", [False, True])
def test_a_part_has_a_number_for_every_vertex_or_for_none(is_thin):
    points, triangles = sheet_box()
    part = _core.Part("box", _core.TriangleMesh(points, triangles), [7, 8, 9])
    if is_thin:
        part.make_thin(True)
    whole = _core.Assembly([part])
    whole.fixed = [_core.Region("root", 0, np.flatnonzero(points[:, 0] < 1.0))]
    whole.handles = [_core.Handle("tip", 0, np.flatnonzero(points[:, 0] > 39.0))]
    with pytest.raises(ValueError, match="part 'box' has 3 vertex numbers and 126 vertices"):
        _core.DeformationSession(whole)


def test_shapes_of_another_session_have_no_control_mesh():
    session = _core.DeformationSession(plate_assembly()[0])
    points, triangles = sheet_box()
    other = _core.Assembly([_core.Part("box", _core.TriangleMesh(points, triangles))])
    other.fixed = [_core.Region("root", 0, [0, 1, 2, 63, 64])]
    foreign = _core.DeformationSession(other).deform(_core.Pose())
    with pytest.raises(ValueError, match="not of this session"):
        session.control_mesh(-1, foreign)
    with pytest.raises(ValueError, match="part 1 does not exist"):
        foreign.positions(1)
    for part in (-1, 1, 10**6):
        with pytest.raises(ValueError, match=f"part {part} does not exist"):
            session.thin_solid(part)


def test_a_form_takes_its_own_vertices_alone():
    points, triangles, rims = plate_with_holes()
    shape = _core.feature_shape(points, triangles, rims[0])
    assert shape.resized(points[rims[0]], 20.0).shape == (32, 3)
    with pytest.raises(ValueError, match="31 places, the feature has 32"):
        shape.resized(points[rims[0][1:]], 20.0)
    assert _core.feature_shape(points, triangles, []) is None


@pytest.mark.parametrize("door", ["self_intersections", "remeshed", "cured"])
def test_a_triangle_that_repeats_a_vertex_ends_no_door_in_a_loop(door):
    points = np.array([[0.0, 0, 0], [9, 0, 0], [0, 9, 0], [9, 9, 0]])
    mesh = _core.TriangleMesh(points, np.array([[0, 1, 2], [1, 1, 3], [3, 2, 2]], np.int32))
    if door == "cured":
        assert _core.cured(mesh, 0.01).triangles.tolist() == [[0, 1, 2]]
    elif door == "self_intersections":
        assert _core.self_intersections(mesh).shape == (0, 2)
    else:
        with pytest.raises(ValueError, match="one vertex at two corners: 1, 2; cure the mesh"):
            _core.remeshed(mesh, 1.0)


@pytest.mark.parametrize("kind", ["FeatureTolerances", "ContactTolerances"])
@drawn
@given(data=st.data())
def test_tolerances_are_refused_in_words_or_used(kind, data):
    tolerances = getattr(_core, kind)()
    name = data.draw(st.sampled_from([n for n in dir(tolerances) if not n.startswith("_")]))
    value = data.draw(st.one_of(hostile.numbers, hostile.integers))
    mesh = data.draw(hostile.meshes())
    if (
        assert_sound(lambda: setattr(tolerances, name, value)) is None
        and kind == "FeatureTolerances"
    ):
        assert_sound(lambda: _core.find_features(mesh, tolerances))
    else:
        parts = [_core.ContactPart(mesh), _core.ContactPart(mesh)]
        assert_sound(lambda: _core.find_contacts(parts, [], tolerances))
        assert_sound(lambda: _core.proposed_gap(parts, tolerances))
