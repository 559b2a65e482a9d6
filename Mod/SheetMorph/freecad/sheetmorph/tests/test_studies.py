# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies are kept in the document, computed in processes of their own, and come back as poses."""

import glob
import json
import os
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import FreeCAD
import numpy as np

from freecad.sheetmorph import api
from freecad.sheetmorph.api import studies
from freecad.sheetmorph.bridge.study_run import interpreter
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.study import kept_parameters
from freecad.sheetmorph.tests import support
from freecad.sheetmorph.tests.test_features import FeatureTest


def is_alive(group: int) -> bool:
    """Whether a group has processes."""
    try:
        os.killpg(group, 0)
    except ProcessLookupError:
        return False
    return True


class StudyTest(support.DocumentTest):
    def setUp(self):
        super().setUp()
        self.assembly, self.part, self.handle = self.add_morph()
        self.hole = api.add_feature(self.assembly, self.part, api.hole_rims(self.part)[1], "Hole")
        self.document.recompute()

    def variable(self, label: str):
        return next(one for one in api.variables(self.assembly) if one.label == label)

    def lift(self, **settings):
        settings = {"count": 3, **settings}
        parameters = [("lift", self.handle, "TranslationZ", 0.0, 30.0)]
        return api.add_study(self.assembly, parameters=parameters, **settings)


class TestStudy(StudyTest):
    def test_what_may_change_is_offered(self):
        labels = [one.label for one in api.variables(self.assembly)]
        self.assertEqual(labels, ["Tip X", "Tip Y", "Tip Z", "Tip angle", "Hole size"])
        with self.assertRaisesRegex(ValueError, "'Hole' is not a hole, slot or cylinder"):
            studies.value_of(self.variable("Hole size"))

    def test_a_study_becomes_a_table_and_a_row_a_pose(self):
        study = self.lift(criteria="displacement <= 20")
        counts = api.run_study(study)
        rows = api.results(study)
        self.assertEqual(sum(counts.values()), 3)
        self.assertEqual(counts["passed"] + counts["failed"], 3)
        self.assertGreaterEqual(counts["failed"], 1)
        before = self.handle.TranslationZ.Value
        self.assertEqual(before, 0.0)
        for row in rows:
            lift = row["parameters"]["lift"]
            self.assertAlmostEqual(row["measures"]["displacement"], lift, delta=1e-6)
            self.assertEqual(row["status"], "passed" if lift <= 20.0 else "failed")
        api.apply_variant(study, 1)
        self.assertEqual(self.handle.TranslationZ.Value, rows[1]["parameters"]["lift"])
        self.document.recompute()
        moved = support.local_points(self.part) - support.local_points(self.part.Source)
        self.assertAlmostEqual(float(moved[:, 2].max()), rows[1]["parameters"]["lift"], delta=1e-3)

    def test_nothing_is_left_of_a_run_without_a_folder(self):
        before = set(glob.glob(os.path.join(tempfile.gettempdir(), "sheetmorph-study-*")))
        with studies.begun(self.lift(count=50)) as run:
            self.assertFalse(run.is_over)
        self.assertTrue(run.is_over)
        after = set(glob.glob(os.path.join(tempfile.gettempdir(), "sheetmorph-study-*")))
        self.assertEqual(after - before, set())

    def test_it_ends_with_the_process_that_began_it(self):
        folder = os.path.join(self.folder, "study")
        path = studies.write_study(self.lift(count=5000), folder)
        code = f"import os, sys; sys.path[:0] = {sys.path!r}\n"
        code += "from pathlib import Path\n"
        code += "from freecad.sheetmorph.bridge.study_run import StudyRun\n"
        code += f"run = StudyRun(Path({str(path)!r}))\n"
        code += "print(run._process.pid, flush=True)\nos._exit(1)\n"
        done = subprocess.run(
            [interpreter(), "-c", code], capture_output=True, text=True, check=False
        )
        group = int(done.stdout.split()[-1])
        end = time.monotonic() + 20.0
        while is_alive(group) and time.monotonic() < end:
            time.sleep(0.05)
        self.assertFalse(is_alive(group))

    def test_a_cell_drives_what_expressions_say(self):
        sheet = self.document.addObject("Spreadsheet::Sheet", "Inputs")
        sheet.set("B1", "=12 mm")
        sheet.set("B2", "=B1 * 2")
        sheet.set("B3", "words")
        self.document.recompute()
        self.handle.setExpression("TranslationZ", "Inputs.B1 / 2")
        self.document.recompute()
        labels = [one.label for one in api.variables(self.assembly)]
        self.assertNotIn("Tip Z", labels)
        self.assertEqual([label for label in labels if "Inputs" in label], ["Inputs B1"])
        parameters = [("lift", sheet, "B1", 0.0, 40.0)]
        study = api.add_study(self.assembly, parameters=parameters, count=3)
        self.assertEqual(api.run_study(study)["passed"], 3)
        self.assertEqual(sheet.get("B1").Value, 12.0)
        self.assertEqual(self.handle.TranslationZ.Value, 6.0)
        for row in api.results(study):
            halved = row["parameters"]["lift"] / 2.0
            self.assertAlmostEqual(row["parameters"]["Tip Z"], halved, delta=1e-9)
        api.apply_variant(study, 2)
        self.document.recompute()
        lift = api.results(study)[2]["parameters"]["lift"]
        self.assertAlmostEqual(sheet.get("B1").Value, lift, delta=1e-9)
        self.assertAlmostEqual(self.handle.TranslationZ.Value, lift / 2.0, delta=1e-9)

    def test_files_stay_in_a_folder_and_the_command_line_goes_on_with_them(self):
        folder = os.path.join(self.folder, "study")
        study = self.lift(folder=folder)
        api.run_study(study)
        self.assertTrue(glob.glob(os.path.join(folder, "out", "000002", "*.obj")))
        entries = json.loads(Path(folder, "study.json").read_text("utf-8"))
        self.assertEqual(entries["parameters"]["lift"]["path"], 'pose."Tip".translation[2]')
        written = os.path.getmtime(os.path.join(folder, "out", "000002", "parameters.json"))
        api.run_study(study)
        again = os.path.getmtime(os.path.join(folder, "out", "000002", "parameters.json"))
        self.assertEqual(again, written)

    def test_faults_are_told_and_change_nothing(self):
        study = self.lift()
        for settings in (
            {"count": 0},
            {"sampling": "guessing"},
            {"criteria": "stretch = 2"},
            {"colour": "red"},
            {"parameters": [("a", self.handle, "TranslationX", 3.0, 1.0)]},
            {"parameters": [("a", self.handle, "Pivot", 0.0, 1.0)]},
            {"parameters": [("a", self.handle, "Angle", 0.0, 1.0)] * 2},
        ):
            with self.subTest(settings), self.assertRaises(ValueError):
                api.set_study(study, **settings)
        self.assertEqual([one.name for one in kept_parameters(study)], ["lift"])
        with self.assertRaisesRegex(ValueError, "compute it first"):
            api.apply_variant(study, 0)
        api.set_study(study, criteria="unheard <= 2")
        with self.assertRaisesRegex(ValueError, "unheard"):
            api.run_study(study)
        self.assertEqual(api.results(study), [])

    def test_a_study_without_parameters_is_refused(self):
        with self.assertRaisesRegex(ValueError, "has no parameter yet"):
            api.run_study(api.add_study(self.assembly))


class TestNumbers(FeatureTest):
    def test_turns_and_sizes_of_the_mesh_itself_may_change(self):
        self.handle.Axis = (0, 1, 0)
        parameters = [
            ("turn", self.handle, "Angle", -10.0, 10.0),
            ("hole", self.holes[1], "Size", 15.0, 18.0),
        ]
        study = api.add_study(self.assembly, parameters=parameters, count=2, sampling="sobol")
        self.assertEqual(api.run_study(study)["passed"], 2)
        api.apply_variant(study, 0)
        found = api.results(study)[0]["parameters"]
        told = {"turn": self.handle.Angle.Value, "hole": self.holes[1].Size.Value}
        self.assertEqual(told, found)
        self.assertAlmostEqual(2.0 * self.circle(1)[0], found["hole"], 9)


class TestKept(StudyTest):
    def test_it_is_saved_with_the_document(self):
        study = self.lift()
        api.run_study(study)
        rows = api.results(study)
        document = self.reopen(self.document)
        assembly = next(o for o in document.Objects if model.kind(o) == model.ASSEMBLY)
        (again,) = model.studies(assembly)
        self.assertEqual(api.results(again), rows)
        api.apply_variant(again, 2)
        lifted = next(r for r in model.regions(assembly) if r.Label == "Tip")
        self.assertEqual(lifted.TranslationZ.Value, rows[2]["parameters"]["lift"])

    def test_a_copy_changes_the_copy(self):
        api.run_study(self.lift())
        twin = self.document.copyObject(self.assembly, True)
        (study,) = model.studies(twin)
        api.apply_variant(study, 1)
        self.assertEqual(self.handle.TranslationZ.Value, 0.0)
        tips = [r for r in model.regions(twin) if r.Role == "handle"]
        self.assertGreater(tips[0].TranslationZ.Value, 0.0)

    def test_undo_takes_it_away_and_a_deleted_handle_is_told(self):
        self.document.openTransaction("Study")
        self.lift()
        self.document.commitTransaction()
        self.document.undo()
        self.assertEqual(model.studies(self.assembly), [])
        self.document.redo()
        (study,) = model.studies(self.assembly)
        self.document.removeObject(self.handle.Name)
        self.assertEqual(kept_parameters(study), [])
        with self.assertRaisesRegex(ValueError, "has no parameter yet"):
            api.run_study(study)
        api.remove(self.assembly)
        self.assertIsNone(FreeCAD.ActiveDocument.getObject("Study"))

    def test_the_document_is_as_before_after_a_run(self):
        study = self.lift()
        self.document.recompute()
        seen = support.local_points(self.part)
        api.run_study(study)
        self.assert_up_to_date(self.document)
        np.testing.assert_array_equal(support.local_points(self.part), seen)


if __name__ == "__main__":
    unittest.main()
