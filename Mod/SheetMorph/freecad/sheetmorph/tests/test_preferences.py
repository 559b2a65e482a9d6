# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user prefers is what the preferences page writes, and what panels and colours read."""

import unittest
import xml.etree.ElementTree as ET

import FreeCAD

from freecad.sheetmorph import paths, preferences
from freecad.sheetmorph.scene import colours


class TestPreferences(unittest.TestCase):
    def setUp(self):
        group = FreeCAD.ParamGet(preferences.PATH)
        self.group = group
        self.kept = [(kind, name, value) for kind, name, value in group.GetContents() or []]
        group.Clear()
        self.addCleanup(self.bring_back)

    def bring_back(self):
        """Put back what the user had."""
        setters = {"Boolean": "SetBool", "Integer": "SetInt", "Float": "SetFloat"}
        setters |= {"String": "SetString", "Unsigned Long": "SetUnsigned"}
        self.group.Clear()
        for kind, name, value in self.kept:
            getattr(self.group, setters[kind])(name, value)

    def page(self) -> dict:
        """The widgets of the page by the entry they write."""
        found = {}
        for widget in ET.parse(paths.panel("preferences")).getroot().iter("widget"):
            named = {p.get("name"): p for p in widget.findall("property")}
            if "prefEntry" in named:
                self.assertEqual(named["prefPath"].findtext("cstring"), "Mod/SheetMorph")
                found[named["prefEntry"].findtext("cstring")] = named
        return found

    def test_the_page_writes_entries_that_are_read_and_shows_their_defaults(self):
        shown = self.page()
        for entry, named in shown.items():
            if entry.startswith("Colour"):
                continue
            default = preferences.DEFAULTS[entry]
            if "value" in named:
                text = named["value"].findtext("double") or named["value"].findtext("number")
                self.assertEqual(float(text), default, entry)
            elif isinstance(default, bool):
                is_on = "checked" in named and named["checked"].findtext("bool") == "true"
                self.assertEqual(is_on, default, entry)
        self.assertGreaterEqual(len(shown), 14)

    def test_the_page_offers_every_colour_of_a_role_as_it_is_by_default(self):
        shown = self.page()
        entries = {"ColourFixed": colours.ROLES["fixed"], "ColourHandle": colours.ROLES["handle"]}
        entries |= {"ColourFeature": colours.ROLES["form feature"]}
        entries |= {"ColourFollower": colours.ROLES["follower"]}
        entries |= {f"ColourSide{side.upper()}": colours.SIDES[side] for side in "ab"}
        for entry, colour in entries.items():
            element = shown[entry]["color"].find("color")
            found = [int(element.findtext(part)) for part in ("red", "green", "blue")]
            self.assertEqual(found, [round(255 * c) for c in colour], entry)

    def test_a_colour_that_is_set_is_used(self):
        self.group.SetUnsigned("ColourHandle", 0xFF0080FF)
        self.assertEqual(colours.ROLES["handle"], (1.0, 0.0, 128 / 255))
        self.assertEqual(colours.css(colours.ROLES["handle"]), "#ff0080")
        self.assertEqual(len(colours.ROLES), 4)

    def test_values_are_kept_in_their_type(self):
        for entry, value in (("Snap", True), ("CreaseAngle", 12.5), ("HoleRings", 3)):
            preferences.put(entry, value)
            self.assertEqual(preferences.get(entry), value)


if __name__ == "__main__":
    unittest.main()
