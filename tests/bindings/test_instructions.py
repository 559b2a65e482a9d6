# SPDX-License-Identifier: LGPL-2.1-or-later
# One binary for every x86-64: on a processor without wide instructions it gives the same shapes.
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

SHAPES = """
import sys
import numpy as np
from plates import ends, plate_with_holes
from test_session import motion, pose
from sheetmorph import _core

points, triangles, rims = plate_with_holes()
left, right = ends(points)
sheets = [points, points + [0.0, 0.0, 5.0]]
shapes = [points]
for rotation in ("interpolated", "free"):
    whole = _core.Assembly(
        [_core.Part(f"part{k}", _core.TriangleMesh(p, triangles)) for k, p in enumerate(sheets)]
    )
    whole.fixed = [_core.Region("root", 0, left)]
    whole.handles = [_core.Handle("tip", 0, right)]
    whole.features = [_core.FormFeature("hole", 0, rims[0], rotation)]
    sides = [_core.Region("weld", part, rims[1]) for part in (0, 1)]
    whole.contacts = [_core.Contact("weld", "control mesh", *sides)]
    session = _core.DeformationSession(whole)
    moved = pose(motion(40.0, (-10.0, 5.0, 30.0)))
    exact = session.deform(moved)
    shapes += [exact.positions(0), exact.positions(1)]
    drag = session.begin_drag(["tip"], _core.Pose())
    drag.wait()
    shapes.append(np.array(drag.frame(moved).positions(0)))
np.save(sys.argv[1], np.array(shapes))
"""


def shapes(instructions, path):
    here = Path(__file__).parent
    places = [str(here), *sys.path]
    environment = dict(os.environ, SHEETMORPH_INSTRUCTIONS=instructions)
    environment["PYTHONPATH"] = os.pathsep.join(place for place in places if place)
    command = [sys.executable, "-c", SHAPES, str(path)]
    subprocess.run(command, check=True, env=environment, timeout=120)
    return np.load(path)


@pytest.mark.parametrize("instructions", ["portable", "ssse3", "avx2"])
def test_narrow_instructions_give_the_same_shapes(instructions, tmp_path):
    widest = shapes("avx512", tmp_path / "widest.npy")
    narrow = shapes(instructions, tmp_path / "narrow.npy")
    size = np.linalg.norm(np.ptp(widest[0], axis=0))
    for k, (ours, theirs) in enumerate(zip(narrow, widest)):
        is_live = k in (3, 6)
        assert np.abs(ours - theirs).max() < (1e-6 if is_live else 1e-9) * size
    assert np.abs(widest[1] - widest[0]).max() > 0.05 * size
