# SPDX-License-Identifier: LGPL-2.1-or-later
"""A fault knows its objects by identity, whatever they are called."""

from __future__ import annotations

import json
import random
import traceback
import unittest

import FreeCAD
import numpy as np

from freecad.sheetmorph import api
from freecad.sheetmorph.bridge import conversion, faults
from freecad.sheetmorph.kinds import RELATION
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.errors import UNREACHED, MorphError
from freecad.sheetmorph.tests import support

HOSTILE = (
    "Weld",
    "weld",
    "Contact 'Weld'",
    "Contact 'Weld': vertex 9999 is no longer in part 'Second'",
    "part 'Second': handle 'Tip'",
    "a; b; c",
    "has no vertices; pick some or delete it",
    "Tip' and 'Clamp",
    "Tip (mirrored)",
    "Tip 2",
    '"quoted" \\ back',
    "7",
    "vertices 3, 7 and 5 more",
    "vertex",
    "the",
    "region",
    " ",
    "\u00a0",
    "x",
    "é 蓋 \U0001f527",
    "one\ntwo: three",
    "Region",
    "Clamp (Region001)",
    "handles[0]",
    "{0}",
    "%s",
    "and 3 more",
)
SEEDS = range(6)


class Scene(support.DocumentTest):
    """Two parts, a fixed region, two handles, a form feature, two contacts; all named anew."""

    def setUp(self) -> None:
        super().setUp()
        self.group = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Document")
        self.was_allowed = self.group.GetBool("DuplicateLabels", False)
        self.group.SetBool("DuplicateLabels", True)
        self.addCleanup(lambda: self.group.SetBool("DuplicateLabels", self.was_allowed))

    def build(self, seed: int) -> None:
        self.assembly, self.handle, self.contact = self.add_pair()
        self.first, self.second = model.parts(self.assembly)
        points = support.strip()[0]
        self.clamp = model.regions(self.assembly)[0]
        x, y = points[:, 0], points[:, 1]
        near = np.flatnonzero((np.abs(x - 150.0) < 25.0) & (np.abs(y - 50.0) < 25.0))
        self.feature = api.add_feature(self.assembly, self.first, near.tolist(), "Hole")
        lower = np.flatnonzero((x > 255.0) & (x < 275.0) & (y < 15.0))
        self.other = api.add_handle(self.assembly, self.first, lower.tolist(), "Other")
        sides = [model.contact_vertices(self.contact, side)[:6].tolist() for side in ("a", "b")]
        self.weld = api.add_contact(
            self.assembly, (self.first, sides[0]), (self.second, sides[1]), label="Weld 2"
        )
        choice = random.Random(seed)
        api.set_motion(self.handle, (0, 0, 5))
        api.set_motion(self.other, (0, 0, 2))
        for obj in [*self.assembly.Group, self.assembly]:
            obj.Label = choice.choice(HOSTILE)
        self.document.recompute()
        self.assertEqual(model.failure_of(self.assembly), "")

    # -- one method for every kind of fault; each returns the objects that are at fault

    def fault_empty_handle(self):
        self.handle.Vertices = []
        return [self.handle]

    def fault_lost_vertex_of_a_fixed_region(self):
        self.clamp.Vertices = [0.0, 99999.0]
        return [self.clamp]

    def fault_damaged_feature(self):
        self.feature.Vertices = [-1.0, 3.0]
        return [self.feature]

    def fault_empty_contact(self):
        self.weld.VerticesB = []
        return [self.weld]

    def fault_lost_vertex_of_a_contact(self):
        self.weld.VerticesA = [1.0, 9999.0]
        return [self.weld]

    def fault_zero_axis(self):
        self.other.Axis = (0, 0, 0)
        self.other.Angle = 10
        return [self.other]

    def fault_two_handles_on_a_vertex(self):
        shared = api.vertices(self.handle)[:2]
        api.set_vertices(self.other, api.vertices(self.other) + shared)
        return [self.handle, self.other]

    def fault_a_fixed_region_and_a_handle(self):
        shared = api.vertices(self.other)[:2]
        api.set_vertices(self.clamp, api.vertices(self.clamp) + shared)
        return [self.clamp, self.other]

    def fault_a_handle_all_fixed(self):
        api.set_vertices(self.clamp, api.vertices(self.clamp) + api.vertices(self.other))
        api.set_motion(self.other)
        return [self.other]

    def fault_a_torn_feature(self):
        held = api.vertices(self.other)[:2] + api.vertices(self.handle)[:2]
        api.set_vertices(self.feature, api.vertices(self.feature) + held)
        return [self.feature, self.handle, self.other]

    def fault_a_loose_piece(self):
        api.set_unheld(self.assembly, "refuse")
        points, triangles = support.strip()
        both = np.concatenate([points, points + (0, 0, 50)])
        corners = np.concatenate([triangles, triangles + len(points)])
        self.first.Source.Mesh = conversion.MeshWriter(corners).mesh(both)
        return [self.first]

    def fault_an_emptied_part(self):
        self.second.Source.Mesh = conversion.Mesh.Mesh()
        return [self.second]

    def fault_a_part_that_is_no_thin_solid(self):
        self.second.Thin = "of given thickness"
        self.second.Thickness = 1.0
        return [self.second]

    def fault_a_size_without_a_shape(self):
        self.feature.Size = 12.0
        return [self.feature]

    def fault_a_group_on_two_parts(self):
        other = api.add_feature(self.assembly, self.first, [0, 1, 2], "far")
        relation = api.group(self.assembly, [self.feature, other], "G")
        other.Part = self.second
        relation.Label, other.Label = self.weld.Label, self.clamp.Label
        return [relation]

    def fault_a_mode_that_bends_features(self):
        api.add_feature(self.assembly, self.second, [0, 1, 20], self.weld.Label)
        self.second.Mode = model_modes()[1]
        return [self.second]


def model_modes() -> list[str]:
    from freecad.sheetmorph.objects.part import MODES

    return MODES


KINDS = sorted(name for name in dir(Scene) if name.startswith("fault_"))


class TestFaults(Scene):
    def test_the_objects_of_a_fault_are_those_at_fault_whatever_they_are_called(self):
        wrong = []
        for kind in KINDS:
            for seed in SEEDS:
                self.build(seed)
                wanted = getattr(self, kind)()
                self.document.recompute()
                failure = model.failure_of(self.assembly)
                self.assertNotEqual(failure, "", kind)
                named = faults.at_fault(self.assembly, failure)
                if {obj.Name for obj in named} != {obj.Name for obj in wanted}:
                    wrong.append((kind, seed, failure, [o.Name for o in named]))
                FreeCAD.closeDocument(self.document.Name)
                self.document = self.new_document()
        self.assertEqual(len(wrong), 0, f"{len(wrong)} of {len(KINDS) * len(SEEDS)}: {wrong[:4]}")

    def test_a_handle_with_the_name_of_a_point_leaves_it_its_pose(self):
        self.build(0)
        point = {"name": "P", "part": self.second.Name, "triangle": 7}
        point["barycentric"] = [0.2, 0.3, 0.5]
        place = np.array([0.2, 0.3, 0.5]) @ self.corners_of(self.second, 7)
        target = (place + (0.0, 0.0, 0.7)).tolist()
        extras = {"recipe": {"points": [point]}, "pose": {"P": {"target": target}}}
        self.assembly.Extras = json.dumps(extras)
        for obj in (self.handle, self.other, self.clamp):
            obj.Label = "P"
        self.document.recompute()
        self.assertEqual(model.failure_of(self.assembly), "")
        now = np.array([0.2, 0.3, 0.5]) @ self.corners_of(self.second, 7, is_moved=True)
        self.assertLess(np.abs(now - target).max(), 1e-3)
        moved = support.local_points(self.first)[api.vertices(self.handle)]
        self.assertLess(np.abs(moved[:, 2] - 5.0).max(), 1e-4)

    def corners_of(self, part, triangle: int, is_moved: bool = False) -> np.ndarray:
        source = part if is_moved else part.Source
        return support.local_points(source)[conversion.read_mesh(source.Mesh)[1][triangle]]

    def test_warnings_know_their_objects(self):
        assembly, _part, handle = self.add_morph()
        second = self.add_second(assembly)
        api.set_motion(handle, (0, 0, 5))
        second.Label = 'reaches "Strip", so it'
        self.document.recompute()
        (warning,) = [one for one in model.warnings_of(assembly) if one.code == UNREACHED]
        self.assertEqual(warning.objects, (second.Name,))
        self.assertIn(str(warning), assembly.Warnings)


class TestCures(Scene):
    def test_a_button_never_touches_what_is_not_at_fault(self):
        from freecad.sheetmorph import mending

        offered = 0
        for kind in KINDS:
            for seed in SEEDS[:2]:
                self.build(seed)
                wanted = getattr(self, kind)()
                self.document.recompute()
                fault = model.failure_of(self.assembly)
                places = mending.places(self.assembly, fault)
                own = {part.Name for obj in wanted for part in parts_of(obj)}
                self.assertLessEqual({part.Name for part, _ in places}, own, kind)
                cure = mending.cure_of(self.assembly, fault)
                if cure is not None:
                    offered += 1
                    before = state_of(self.assembly)
                    exec(cure[1], {"api": api})
                    changed = {
                        n for n, now in state_of(self.assembly).items() if now != before.get(n)
                    }
                    made = changed - before.keys()
                    self.assertLessEqual(changed - made, {obj.Name for obj in wanted}, cure)
                    self.assertEqual(bool(made), kind == "fault_a_loose_piece")
                FreeCAD.closeDocument(self.document.Name)
                self.document = self.new_document()
        self.assertGreater(offered, 8)


def parts_of(obj) -> list:
    """Return the parts on which an object of a morph is."""
    of = {
        model.PART: lambda: [obj],
        model.REGION: lambda: [obj.Part],
        model.CONTACT: lambda: [obj.PartA, obj.PartB],
        RELATION: lambda: [feature.Part for feature in obj.Features],
    }
    return of[model.kind(obj)]()


def state_of(assembly) -> dict:
    """Return what the buttons of a panel may change, by object name."""
    regions = {r.Name: tuple(model.vertices(r)) for r in model.regions(assembly)}
    return regions | {contact.Name: contact.Active for contact in model.contacts(assembly)}


class TestReports(support.DocumentTest):
    def test_a_morph_that_cannot_be_is_reported_without_a_traceback(self):
        _assembly, _part, handle = self.add_morph()
        handle.Vertices = []
        proxy, other = handle.Part.Deformation.Proxy, handle.Part
        for one, obj in ((proxy, handle.Part.Deformation), (other.Proxy, other)):
            error, places = raised_by(one.execute, obj)
            self.assertEqual(len(places), 1, "that of the call alone")
            self.assertEqual(error.fault.objects, (handle.Name,))
        self.assertEqual(str(MorphError), "SheetMorph", "what FreeCAD writes before the sentence")


def raised_by(function, *arguments) -> tuple[MorphError, list]:
    """Return the error that a function raises, and the places of its traceback."""
    try:
        function(*arguments)
    except MorphError as error:
        return error, traceback.extract_tb(error.__traceback__)
    raise AssertionError("nothing was raised")


if __name__ == "__main__":
    unittest.main()
