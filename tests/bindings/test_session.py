# SPDX-License-Identifier: LGPL-2.1-or-later
import threading

import numpy as np
import pytest
from kkt import Problem
from natural import NaturalProblem
from plates import ends, plate_with_holes

from sheetmorph import _core


def assembly(points, triangles, rims, energy="neumann", **changes):
    left, right = ends(points)
    whole = _core.Assembly(
        [_core.Part("plate", _core.TriangleMesh(points, triangles))], energy=energy
    )
    whole.fixed = [_core.Region("root", 0, changes.get("fixed", left))]
    whole.handles = [_core.Handle("tip", 0, changes.get("handle", right))]
    whole.features = [
        _core.FormFeature(f"hole{k}", 0, rim, changes.get("rotation", "interpolated"))
        for k, rim in enumerate(rims)
    ]
    return whole


def pose(motion):
    moved = _core.Pose()
    moved.move_handle("tip", motion)
    return moved


def motion(degrees=0.0, shift=(0.0, 0.0, 0.0)):
    log = _core.rotation_log([0.1, 1.0, 0.2], np.radians(degrees))
    return _core.RigidMotion(shift, log, (180.0, 30.0, 0.0))


@pytest.mark.parametrize("energy", ["paper", "neumann"])
@pytest.mark.parametrize("degrees, shift", [(0.0, (0, 0, 40.0)), (55.0, (-20.0, 5.0, 30.0))])
def test_an_independent_kkt_solution_agrees_to_1e_8_of_the_size(energy, degrees, shift):
    points, triangles, rims = plate_with_holes()
    left, right = ends(points)
    session = _core.DeformationSession(assembly(points, triangles, rims, energy))
    ours = session.deform(pose(motion(degrees, shift))).positions(0)
    theirs = Problem(points, triangles, left, right, rims).positions(energy, motion(degrees, shift))
    size = np.linalg.norm(np.ptp(points, axis=0))
    assert np.abs(ours - theirs).max() < 1e-8 * size
    assert np.abs(ours - points).max() > 0.1 * size


@pytest.mark.parametrize("is_bent", [False, True])
def test_an_independent_solution_of_natural_agrees_to_1e_8_of_the_size(is_bent):
    points, triangles, rims = plate_with_holes()
    left, right = ends(points)
    if is_bent:
        angle = points[:, 0] / 120.0
        points = np.ascontiguousarray(
            np.column_stack([120 * np.sin(angle), points[:, 1], 120 * (1 - np.cos(angle))])
        )
    whole = assembly(points, triangles, rims, "natural", fixed=left, handle=right)
    turn = motion(40.0, (0, 0, 20.0))
    ours = _core.DeformationSession(whole).deform(pose(turn)).positions(0)
    theirs = NaturalProblem(points, triangles, left, right, rims).positions(turn)
    assert np.abs(ours - theirs).max() < 1e-8 * 180


def test_the_kkt_solution_agrees_on_a_curved_sheet_too():
    points, triangles, rims = plate_with_holes()
    left, right = ends(points)
    angle = points[:, 0] / 120.0
    bent = np.ascontiguousarray(
        np.column_stack([120 * np.sin(angle), points[:, 1], 120 * (1 - np.cos(angle))])
    )
    whole = assembly(points, triangles, rims, "neumann")
    whole = assembly(bent, triangles, rims, "neumann", fixed=left, handle=right)
    ours = _core.DeformationSession(whole).deform(pose(motion(40.0, (0, 0, 20.0)))).positions(0)
    theirs = Problem(bent, triangles, left, right, rims).positions(
        "neumann", motion(40.0, (0, 0, 20.0))
    )
    assert np.abs(ours - theirs).max() < 1e-8 * 180


def test_features_report_their_motion_and_are_rigid_to_rounding():
    points, triangles, rims = plate_with_holes()
    result = _core.DeformationSession(assembly(points, triangles, rims)).deform(
        pose(motion(60.0, (-30.0, 0, 40.0)))
    )
    for feature, rim in zip(result.features, rims):
        moved = result.positions(0)[rim]
        expected = (points[rim] - feature.centre) @ feature.rotation.T
        expected += feature.centre + feature.translation
        assert np.abs(moved - expected).max() < 1e-11
        assert feature.edge_error < 1e-12 * 190 + 8 * np.finfo(float).eps * 190
        radii = np.linalg.norm(moved - moved.mean(axis=0), axis=1)
        assert np.ptp(radii) < 1e-11


def test_parts_that_nothing_moves_stay_and_are_listed():
    points, triangles, rims = plate_with_holes()
    whole = assembly(points, triangles, rims)
    other = _core.Part("other", _core.TriangleMesh(points + 500.0, triangles))
    both = _core.Assembly([_core.Part("plate", _core.TriangleMesh(points, triangles)), other])
    both.fixed, both.handles, both.features = whole.fixed, whole.handles, whole.features
    session = _core.DeformationSession(both)
    assert session.unreached == ["other"]
    assert session.order == ["plate"]
    result = session.deform(pose(motion(10.0)))
    assert np.array_equal(result.positions(1), points + 500.0)


def test_messages_name_the_part_and_the_files_own_vertex_numbers():
    points, triangles, rims = plate_with_holes()
    whole = assembly(points, triangles, rims)
    loose = np.vstack([points, [[900.0, 0, 0], [910.0, 0, 0], [900.0, 10.0, 0]]])
    n = len(points)
    mesh = _core.TriangleMesh(loose, np.vstack([triangles, [[n, n + 1, n + 2]]]).astype(np.int32))
    numbers = np.arange(len(loose), dtype=np.int32) + 7000
    numbered = _core.Assembly([_core.Part("rail", mesh, numbers)])
    numbered.fixed, numbered.handles = whole.fixed, whole.handles
    _core.DeformationSession(numbered)  # the loose triangle stays at rest
    numbered.set_unheld("refuse")
    with pytest.raises(_core.InvalidInput, match=f"part 'rail'.*{n + 7000}.*mark a fixed region"):
        _core.DeformationSession(numbered)


def test_a_pose_that_names_what_is_not_there_is_refused():
    points, triangles, rims = plate_with_holes()
    session = _core.DeformationSession(assembly(points, triangles, rims))
    wrong = _core.Pose()
    wrong.move_handle("nose", motion(1.0))
    with pytest.raises(_core.InvalidInput, match="'nose'"):
        session.deform(wrong)


def test_progress_rises_and_false_cancels():
    points, triangles, rims = plate_with_holes()
    seen = []
    _core.DeformationSession(
        assembly(points, triangles, rims), progress=lambda part, task: seen.append(part)
    )
    assert seen == sorted(seen) and seen[-1] == 1.0
    with pytest.raises(_core.Cancelled):
        _core.DeformationSession(
            assembly(points, triangles, rims), progress=lambda part, task: part < 0.3
        )


def test_an_error_in_the_progress_callback_reaches_the_caller():
    points, triangles, rims = plate_with_holes()

    def fails(part, task):
        raise KeyError("from the callback")

    with pytest.raises(KeyError, match="from the callback"):
        _core.DeformationSession(assembly(points, triangles, rims), progress=fails)


def test_other_threads_run_while_the_kernel_computes():
    points, triangles, rims = plate_with_holes(holes=6, rim=64, rings=16)
    ticks, done = [], threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(1)
            done.wait(0.001)

    thread = threading.Thread(target=tick)
    thread.start()
    before = len(ticks)
    _core.DeformationSession(assembly(points, triangles, rims))
    during = len(ticks) - before
    done.set()
    thread.join()
    assert during > 1


def test_threads_that_share_a_drag_get_the_frames_that_one_thread_gets():
    points, triangles, rims = plate_with_holes()
    session = _core.DeformationSession(assembly(points, triangles, rims, rotation="free"))
    poses = [pose(motion(3.0 * k, (0.0, 0.0, 2.0 * k))) for k in range(1, 13)]
    expected = [session.deform(one).positions(0) for one in poses]
    drag, worst, failures = session.begin_drag(["tip"]), [], []
    start = threading.Barrier(4)

    def work(offset):
        held = []
        try:
            start.wait()
            for k in range(120):
                which = (5 * k + offset) % len(poses)
                held = [*held[-2:], (which, drag.frame(poses[which]))]
                assert len(drag.answered) == 1
                # A frame stays as it is while somebody holds it.
                worst.append(max(np.abs(f.positions(0) - expected[w]).max() for w, f in held))
        except Exception as error:  # noqa: BLE001
            failures.append(error)

    threads = [threading.Thread(target=work, args=(3 * k,)) for k in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failures
    assert max(worst) < 1e-6 * np.ptp(points, axis=0).max()


def test_a_pose_may_change_while_another_thread_reads_it():
    points, triangles, rims = plate_with_holes()
    session = _core.DeformationSession(assembly(points, triangles, rims))
    drag, shared, done = session.begin_drag(["tip"]), pose(motion()), threading.Event()

    shared.move_handle("nose", motion())

    def change():
        for k in range(3000):
            shared.move_handle(f"nose{k}", motion(shift=(0.0, 0.0, float(k % 9))))
            done.wait(1e-5)

    thread = threading.Thread(target=change)
    thread.start()
    try:
        for _ in range(300):
            with pytest.raises(_core.InvalidInput, match="nose"):
                drag.frame(shared)
            with pytest.raises(_core.InvalidInput, match="nose"):
                session.deform(shared, exact=False)
    finally:
        done.set()
        thread.join()


@pytest.mark.parametrize(
    "points, triangles, error",
    [
        (np.zeros((3, 3), dtype=np.float32), np.zeros((1, 3), np.int32), TypeError),
        (np.zeros((3, 2)), np.zeros((1, 3), np.int32), ValueError),
        ([[0, 0, 0]], np.zeros((1, 3), np.int32), TypeError),
        (np.zeros((3, 3)), np.zeros((1, 3)), TypeError),
        (np.zeros((3, 3)), np.array([[0, 1, 3]], np.int32), ValueError),
        (np.full((3, 3), np.nan), np.array([[0, 1, 2]], np.int32), ValueError),
    ],
)
def test_arrays_of_the_wrong_type_or_shape_are_refused_in_words(points, triangles, error):
    with pytest.raises(error, match="points|triangles|vertices|finite"):
        _core.TriangleMesh(points, triangles)


def test_results_are_read_only_views_that_outlive_their_session():
    points, triangles, rims = plate_with_holes()
    positions = (
        _core.DeformationSession(assembly(points, triangles, rims))
        .deform(pose(motion()))
        .positions(0)
    )
    assert positions.dtype == np.float64 and positions.flags.c_contiguous
    assert np.array_equal(positions, points)
    with pytest.raises(ValueError):
        positions[0, 0] = 1.0
