# SPDX-License-Identifier: LGPL-2.1-or-later
"""The differences between the panels that propose features and contacts."""

from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.api.finding import HOLES, with_washers
from freecad.sheetmorph.panels.base import vertices_said
from freecad.sheetmorph.qt import QtWidgets, translate
from freecad.sheetmorph.tools import words
from freecad.sheetmorph.tools.marked import QT_TRANSLATE_NOOP

MARKED = QT_TRANSLATE_NOOP("SheetMorph_find", "Already in the document")


def widget(form, title: str):
    """Return a widget of the panel, searched anew, since an attribute can outlive its widget."""
    return form.findChild(QtWidgets.QWidget, title)


def plain(vertices) -> str:
    """Return vertices as source text with plain integers."""
    return repr([int(vertex) for vertex in vertices])


class Features:
    """Proposals that become form features."""

    title, icon = QT_TRANSLATE_NOOP("SheetMorph_find", "Find Features"), "FindFeatures"
    columns = (
        QT_TRANSLATE_NOOP("SheetMorph_find", "Feature"),
        QT_TRANSLATE_NOOP("SheetMorph_find", "Size"),
        QT_TRANSLATE_NOOP("SheetMorph_find", "Deviation"),
    )

    def prepare(self, form) -> None:
        """Hide the tolerances of contacts."""
        for widget in (form.gap, form.gap_label, form.facing, form.facing_label, form.one_per_pair):
            widget.setVisible(False)
        form.hint.setText(
            translate(
                "SheetMorph_find",
                "Size: diameter or length. Deviation: distance of the rim from its ideal form.",
            )
        )

    def options(self, form) -> dict:
        """Return the tolerances of the panel."""
        return {
            "roundness": widget(form, "roundness").value() / 100.0,
            "crease_angle": widget(form, "crease").value(),
            "rings": max(1, widget(form, "rings").value()),
            "kinds": None if widget(form, "surfaces").isChecked() else _OFFERED,
        }

    def find(self, api, assembly, options) -> list:
        """Return the proposals."""
        return api.find_features(assembly, **options)

    def size(self, one) -> float:
        """Return the size for the filter, mm."""
        return one.size

    def doubt(self, one) -> str:
        """Return why its vertices are uncertain, empty if they are not."""
        return one.unsettled

    def row(self, one) -> tuple:
        """Return the list entry of a proposal."""
        quality = one.residual / (0.5 * one.size) if one.size else 0.0
        size = words.length(one.size, 4)
        if one.kind == "bend":
            size = f"R {words.length(one.radius, 4)}, {words.plain(one.angle)}°"
        mark = "? " if self.doubt(one) else ""
        texts = (one.name, size, mark + words.percent(quality))
        is_checked = not one.is_marked and one.kind in HOLES
        tip = f"{one.kind}, {vertices_said(len(one.vertices))}"
        tip = translate("SheetMorph_find", MARKED) if one.is_marked else tip
        tip = "\n".join(filter(None, (one.name, tip, self.doubt(one))))
        return texts, (one.name, one.size, quality), is_checked, not one.is_marked, tip

    def places(self, one, colours) -> list:
        """Return (part, vertices, colour) to highlight."""
        return [(one.part, one.vertices, colours.ROLES["form feature"])]

    def lines(self, assembly, chosen, form) -> list[str]:
        """Return the macro lines that accept proposals."""
        sets = with_washers(assembly, chosen, form.rings.value())
        return [
            call("add_feature", name(assembly), name(one.part), plain(ids), repr(one.name))
            for one, ids in zip(chosen, sets)
        ]


class Contacts:
    """Proposals that become contacts."""

    title, icon = QT_TRANSLATE_NOOP("SheetMorph_find", "Find Contacts"), "FindContacts"
    columns = (
        QT_TRANSLATE_NOOP("SheetMorph_find", "Contact"),
        QT_TRANSLATE_NOOP("SheetMorph_find", "Type"),
        QT_TRANSLATE_NOOP("SheetMorph_find", "Size"),
        QT_TRANSLATE_NOOP("SheetMorph_find", "Gap"),
    )

    def prepare(self, form) -> None:
        """Hide the tolerances of features."""
        for widget in (
            form.roundness,
            form.roundness_label,
            form.crease,
            form.crease_label,
            form.rings,
            form.rings_label,
            form.surfaces,
        ):
            widget.setVisible(False)
        form.hint.setText(
            translate(
                "SheetMorph_find",
                "Size of the contact area; median gap.",
            )
        )

    def options(self, form) -> dict:
        """Return the tolerances of the panel."""
        options = {
            "facing_angle": widget(form, "facing").value(),
            "one_per_pair": widget(form, "one_per_pair").isChecked(),
        }
        gap = widget(form, "gap").value()
        return {**options, "gap": gap} if gap > 0.0 else options

    def find(self, api, assembly, options) -> list:
        """Return the proposals."""
        return api.find_contacts(assembly, **options)

    def size(self, one) -> float:
        """Return the size for the filter, mm."""
        return one.size

    def doubt(self, _one) -> str:
        """Return an empty string, since no uncertain contact is proposed."""
        return ""

    def row(self, one) -> tuple:
        """Return the list entry of a proposal."""
        texts = (one.name, one.type, words.length(one.size, 4), words.length(one.distance))
        tip = f"{len(one.a)} + {vertices_said(len(one.b))}"
        tip = translate("SheetMorph_find", MARKED) if one.is_marked else tip
        tip = f"{one.name}\n{tip}"
        values = (one.name, one.type, one.size, one.distance)
        return texts, values, not one.is_marked, not one.is_marked, tip

    def places(self, one, colours) -> list:
        """Return (part, vertices, colour) to highlight."""
        return [(one.part_a, one.a, colours.SIDES["a"]), (one.part_b, one.b, colours.SIDES["b"])]

    def lines(self, assembly, chosen, _form) -> list[str]:
        """Return the macro lines that accept proposals."""
        return [self._line(name(assembly), one) for one in chosen]

    def _line(self, assembly: str, one) -> str:
        sides = [
            f"({name(part)}, {plain(ids)})"
            for part, ids in ((one.part_a, one.a), (one.part_b, one.b))
        ]
        keywords = {"label": repr(one.name), "type": repr(one.type)}
        return call("add_contact", assembly, *sides, **keywords)


# Holes are checked initially, bends are not.
_OFFERED = (*HOLES, "bend")
FEATURES, CONTACTS = Features(), Contacts()
