# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions of a document say what they are, and mean it again on another mesh."""

import json
import os
import unittest

import FreeCAD
import numpy as np

from freecad.sheetmorph import api
from freecad.sheetmorph.bridge import seen, selecting
from freecad.sheetmorph.tests.support import (
    DocumentTest,
    largest,
    placement,
    strip,
    write_obj,
)
from freecad.sheetmorph.tests.test_thin import thick_strip
from freecad.sheetmorph.tools import figures, picking
from freecad.sheetmorph.tools.rims import Ray
from freecad.sheetmorph.tools.sentences import DrawnFigure

LEFT = {"half_space": {"point": [15, 0, 0], "normal": [-1, 0, 0]}}
RIM = {"rim_at": [75, 36, 0]}


def from_above(points: np.ndarray) -> figures.Camera:
    """A view straight down on points (n, 3), 1000 x 500 px."""
    low, high = points.min(axis=0), points.max(axis=0)
    middle, half = 0.5 * (low + high), 0.6 * (high - low).max()
    matrix = np.diag([1.0 / half, 2.0 / half, -1.0 / 1000.0, 1.0])
    matrix[:3, 3] = -matrix[:3, :3] @ middle
    return figures.Camera(matrix, 1000.0, 500.0)


class TestSelectors(DocumentTest):
    def setUp(self) -> None:
        super().setUp()
        self.points, self.triangles, _ = thick_strip()
        self.assembly = api.create_assembly(self.document)
        self.source = self.add_source(mesh=(self.points, self.triangles))
        self.part = api.add_part(self.assembly, self.source)

    def take_a_sheet(self) -> None:
        """Go on with an open sheet, whose holes have rims."""
        self.part = api.add_part(self.assembly, self.add_source())

    def picker(self, **options) -> picking.RegionPicker:
        """A picker on the part, as a panel has it."""
        picker = picking.RegionPicker(api.picking.mesh_at_rest(self.part))
        picker.choose(**options)
        return picker

    def said(self, picker):
        """What a picker's sentence is in the document; it gives just what is picked."""
        return selecting.sentence_for(self.part, picker.said, picker.picked)

    def test_a_region_keeps_what_it_says_and_vertices_alone_say_nothing(self):
        clamp = api.add_fixed(self.assembly, self.part, LEFT)
        expected = np.flatnonzero(self.points[:, 0] <= 15.0 + 1e-6)
        self.assertEqual(api.vertices(clamp), expected.tolist())
        self.assertEqual(api.where(clamp), LEFT)
        self.assertEqual(api.select(self.part, LEFT), expected.tolist())
        api.set_vertices(clamp, [0, 1, 2])
        self.assertIsNone(api.where(clamp))
        api.set_vertices(clamp, [LEFT, RIM])
        self.assertEqual(api.where(clamp), [LEFT, RIM])
        name = clamp.Name
        opened = self.reopen(self.document)
        self.assertEqual(api.where(opened.getObject(name)), [LEFT, RIM])

    def test_what_selects_nothing_or_is_no_selector_is_a_sentence(self):
        for wrong in (
            {"box": 5},
            {"face_at": [0, 0]},
            {},
            {"sphere": {"center": [9e5, 0, 0], "radius": 1}},
        ):
            with self.assertRaises(ValueError) as caught:
                api.add_fixed(self.assembly, self.part, wrong)
            self.assertNotIn("\n", str(caught.exception))
        self.assertEqual([o for o in self.document.Objects if o.Name.startswith("Region")], [])

    def test_the_coordinates_are_those_of_the_part_wherever_it_stands(self):
        before = api.select(self.part, LEFT)
        self.source.Placement = FreeCAD.Placement(
            FreeCAD.Vector(500, 3, 1), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 90)
        )
        self.document.recompute()
        self.assertEqual(api.select(self.part, LEFT), before)

    def test_prepared_anew_with_other_edges_every_region_is_kept(self):
        regions = [
            api.add_fixed(self.assembly, self.part, LEFT),
            api.add_handle(
                self.assembly,
                self.part,
                {"half_space": {"point": [285, 0, 0], "normal": [1, 0, 0]}},
            ),
        ]
        shapes = []
        for edge in (12.0, 6.0, 4.0):
            done = api.prepare(self.part, edge=edge)
            self.assertEqual(done["told"], [])
            shape = selecting.shape_of(self.part)
            found = [selecting.chosen_on(shape, api.where(region)) for region in regions]
            for region, chosen in zip(regions, found):
                self.assertEqual(api.vertices(region), chosen.vertices.tolist())
            shapes.append([shape.area_of(chosen) for chosen in found])
        areas = np.array(shapes)
        self.assertLess(largest(areas / areas[-1] - 1.0), 0.03)

    def test_what_cannot_be_found_again_is_told_and_keeps_its_vertices(self):
        region = api.add_fixed(self.assembly, self.part, LEFT)
        region.Where = json.dumps({"group": "flange"})
        (text,) = api.prepare(self.part, edge=8.0)["told"]
        self.assertIn("keeps its vertices without a selector", text)
        self.assertIsNone(api.where(region))
        points = api.rest_mesh(self.part)[0]
        self.assertLess(points[api.vertices(region), 0].max(), 20.0)

    def test_a_region_that_became_another_one_is_told(self):
        region = api.add_fixed(self.assembly, self.part, {"rim_at": [75, 36, 0], "rings": 2})
        told = api.prepare(self.part, edge=3.0)["told"]
        self.assertIn(f"'{region.Label}' covers", told[0])

    def test_clicks_on_faces_rims_and_pieces_say_where_they_were(self):
        self.take_a_sheet()
        down = np.array([0.0, 0.0, -1.0])
        for options, at, key in (
            ({"what": picking.FACE}, (40.0, 20.0), "face_at"),
            ({"what": picking.RIM, "rings": 1}, (75.0, 50.0), "rim_at"),
            ({"what": picking.WHOLE}, (40.0, 20.0), "piece_at"),
        ):
            picker = self.picker(**options)
            self.assertTrue(picker.click(Ray(np.array([*at, 100.0]), down)))
            where = self.said(picker)
            self.assertIn(key, where)
            self.assertLess(len(repr(where)), 120)
            self.assertEqual(api.select(self.part, where), picker.picked.tolist())

    def test_adding_removing_and_growing_go_into_the_sentence(self):
        self.take_a_sheet()
        down = np.array([0.0, 0.0, -1.0])
        picker = self.picker(what=picking.RIM)
        picker.click(Ray(np.array([75.0, 50.0, 100.0]), down))
        picker.click(Ray(np.array([150.0, 50.0, 100.0]), down), picking.ADD)
        picker.grow()
        vertex = int(picker.picked[3])
        picker.take([vertex], picking.REMOVE, {"vertices": [vertex]})
        self.assertEqual(api.select(self.part, self.said(picker)), picker.picked.tolist())
        picker.invert()
        self.assertEqual(api.select(self.part, self.said(picker)), picker.picked.tolist())
        picker.back()
        picker.back()
        self.assertIn("grow", self.said(picker))
        picker.take([1, 2, 3])
        self.assertIsNone(self.said(picker))

    def test_drawn_figures_are_short_and_taken_again_to_the_vertex(self):
        camera = from_above(self.points)
        drawing = figures.Drawing(figures.BRUSH, (200, 250), 25.0)
        picker = self.picker(what=figures.BRUSH)
        picker.paint(camera, drawing.outline())
        for x in range(201, 420, 3):
            picker.paint(camera, drawing.go_to((x, 250 + (x % 7))))
        rest = drawing.rest()
        if rest is not None:
            picker.paint(camera, rest)
        figure = DrawnFigure(figures.BRUSH, drawing.places, camera.view, 25.0)
        picker.take_painted(picking.REPLACE, figure.said())
        where = self.said(picker)
        self.assertLess(len(repr(where)), 500)
        self.assertEqual(api.select(self.part, where), picker.picked.tolist())
        self.assertGreater(len(picker.picked), 10)
        hidden = api.select(self.part, {"drawn": {**where["drawn"], "through": True}})
        self.assertGreater(len(hidden), len(picker.picked))

    def test_an_imported_recipe_keeps_its_sentences(self):
        points, triangles = strip()
        write_obj(os.path.join(self.folder, "strip.obj"), points, triangles)
        right = {"half_space": {"point": [285, 0, 0], "normal": [1, 0, 0]}}
        recipe = {
            "sheetmorph": 1,
            "parts": [{"name": "strip", "file": "strip.obj"}],
            "fixed": [{"name": "clamp", "part": "strip", "where": LEFT}],
            "handles": [{"name": "tip", "part": "strip", "where": [right]}],
            "features": [{"name": "sheet", "part": "strip", "where": {"group": "sheet"}}],
            "pose": {"tip": {"translation": [0, 0, 5]}},
        }
        recipe["features"][0]["where"] = {"intersection": [{"group": "sheet"}, RIM]}
        path = os.path.join(self.folder, "recipe.json")
        with open(path, "w", encoding="utf-8") as file:
            json.dump(recipe, file)
        assembly = api.import_recipe(self.document, path)
        found = {r.Label: api.where(r) for r in seen.model.regions(assembly)}
        self.assertEqual(found["clamp"], LEFT)
        self.assertEqual(found["tip"], [right])
        self.assertEqual(found["sheet"], recipe["features"][0]["where"])

    def moved_pair(self):
        """Two sheets, the first one turned, joined where half-spaces meet them; the contact."""
        self.source.Placement = placement((500, 3, 1), (0, 0, 1), 30)
        other = self.add_source(mesh=(self.points, self.triangles))
        other.Placement = placement((500, 3, 4), (0, 0, 1), 30)
        self.document.recompute()
        second = api.add_part(self.assembly, other)
        return api.add_contact(self.assembly, (self.part, LEFT), (second, [LEFT]))

    def test_sides_of_contacts_keep_their_sentences_on_another_mesh(self):
        contact = self.moved_pair()
        self.assertEqual([api.where(contact, side) for side in "ab"], [LEFT, [LEFT]])
        self.assertEqual(api.contact_vertices(contact, "a"), api.select(self.part, LEFT))
        before = len(api.contact_vertices(contact, "a"))
        self.assertEqual(api.prepare(self.part, edge=4.0)["told"], [])
        self.assertEqual(api.where(contact, "a"), LEFT)
        self.assertNotEqual(len(api.contact_vertices(contact, "a")), before)
        self.assertEqual(api.contact_vertices(contact, "a"), api.select(self.part, LEFT))
        api.set_contact_vertices(contact, "a", [0, 1, 2])
        self.assertIsNone(api.where(contact, "a"))
        with self.assertRaisesRegex(ValueError, "selects nothing"):
            far = {"sphere": {"center": [9e5, 0, 0], "radius": 1}}
            api.set_contact_vertices(contact, "b", far)
        self.assertEqual(api.where(contact, "b"), [LEFT])

    def test_an_exported_recipe_says_what_regions_are_where_that_gives_them_again(self):
        contact = self.moved_pair()
        clamp = api.add_fixed(self.assembly, self.part, {"vertices": [0, 1, 2]}, "Clamp")
        end = {"half_space": {"point": [285, 0, 0], "normal": [1, 0, 0]}}
        tip = api.add_handle(self.assembly, self.part, end, "Tip")
        low, high = self.points.min(axis=0) - 1, self.points.max(axis=0) + 1
        boxed = {"box": [low.tolist(), [10.0, *high[1:].tolist()]]}
        api.add_follower(self.assembly, contact.PartB, boxed, "Boxed")
        path = api.export_recipe(self.assembly, os.path.join(self.folder, "morph.json"))
        with open(path, encoding="utf-8") as file:
            written = json.load(file)
        self.assertEqual(written["fixed"][0]["where"], {"vertices": [0, 1, 2]})
        self.assertEqual(written["handles"][0].keys(), {"name", "part", "where"})
        self.assertIn("vertices", written["regions"][0])  # a box in a turned part is none
        self.assertEqual([len(written["contacts"][0][side]) for side in "ab"], [2, 2])
        again = api.import_recipe(self.new_document(), path)
        found = {r.Label: r for r in seen.model.regions(again)}
        for old in (clamp, tip):
            new = found[old.Label]
            self.assertEqual(api.vertices(new), api.vertices(old))
            self.assertIsNotNone(api.where(new))
        self.assertIsNone(api.where(found["Boxed"]))
        (other,) = seen.model.contacts(again)
        for side in "ab":
            self.assertEqual(api.contact_vertices(other, side), api.contact_vertices(contact, side))
            self.assertIsNotNone(api.where(other, side))
        self.assertEqual(
            api.export_recipe(again, os.path.join(self.folder, "again.json")).read_bytes(),
            path.read_bytes(),
        )

    def test_names_of_a_deck_are_known_in_the_document(self):
        deck = os.path.join(self.folder, "sheet.bdf")
        with open(deck, "w", encoding="utf-8") as file:
            file.write(DECK)
        part = api.import_part(self.assembly, deck)
        self.assertEqual(api.select(part, {"group": "PID 7"}), [0, 1, 3, 4])
        self.assertEqual(api.select(part, {"group": "SET 5"}), [3, 4, 5])
        region = api.add_fixed(self.assembly, part, {"group": "SET 5"})
        api.prepare(part, edge=0.2)
        points = api.rest_mesh(part)[0]
        self.assertTrue((points[api.vertices(region), 1] > 0.9).all())

    def test_what_a_part_says_is_driven_becomes_a_follower(self):
        points, triangles = strip()
        for name in ("low", "high"):
            write_obj(os.path.join(self.folder, f"{name}.obj"), points, triangles)
        recipe = {
            "sheetmorph": 1,
            "parts": [
                {"name": "low", "file": "low.obj"},
                {"name": "high", "file": "high.obj", "driven": {"where": LEFT}},
            ],
            "primary": "low",
            "fixed": [{"part": "low", "where": LEFT}],
        }
        path = os.path.join(self.folder, "recipe.json")
        with open(path, "w", encoding="utf-8") as file:
            json.dump(recipe, file)
        assembly = api.import_recipe(self.document, path)
        (driven,) = [r for r in seen.model.regions(assembly) if r.Role == "follower"]
        self.assertEqual((driven.Label, driven.Part.Label), ("high: driven", "high"))
        self.assertEqual(api.where(driven), LEFT)


DECK = """BEGIN BULK
GRID,1,,0.,0.,0.
GRID,2,,1.,0.,0.
GRID,3,,2.,0.,0.
GRID,4,,0.,1.,0.
GRID,5,,1.,1.,0.
GRID,6,,2.,1.,0.
CQUAD4,1,7,1,2,5,4
CQUAD4,2,8,2,3,6,5
SET3,5,GRID,4,THRU,6
ENDDATA
"""


if __name__ == "__main__":
    unittest.main()
