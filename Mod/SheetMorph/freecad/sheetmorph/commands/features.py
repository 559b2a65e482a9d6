# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands about form features: their settings and the relations between them."""

from freecad.sheetmorph import actions, subject
from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.commands.base import Command
from freecad.sheetmorph.qt import QtCore

QT_TRANSLATE_NOOP = QtCore.QT_TRANSLATE_NOOP


def chosen_features() -> list:
    """Return the selected form features."""
    return [region for region in subject.selected(subject.REGION) if region.Role == "form feature"]


class FeatureSettings(Command):
    """The command that opens the panel of a form feature."""

    name = "SheetMorph_FeatureSettings"
    text = QT_TRANSLATE_NOOP("SheetMorph_FeatureSettings", "Form Feature Settings…")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_FeatureSettings",
        "Sets the rotation, the motion and the size of the selected form feature",
    )

    def possible(self) -> bool:
        """Return whether one form feature is selected."""
        return len(chosen_features()) == 1

    def execute(self) -> None:
        """Open the panel."""
        from freecad.sheetmorph.panels import feature_panel

        feature_panel.open_panel(chosen_features()[0])


class _Relate(Command):
    """The base of commands that relate the selected form features."""

    function = ""
    most = 2

    def possible(self) -> bool:
        """Return whether two form features are selected, or more for a group."""
        return 2 <= len(chosen_features()) <= self.most

    def execute(self) -> None:
        """Create the relation in one undo step."""
        features = chosen_features()
        members = ", ".join(name(feature) for feature in features)
        if self.function == "group":
            members = f"[{members}]"
        owner = name(subject.assembly_of(features[0]))
        actions.attempt(self.text, call(self.function, owner, members))


class GroupFeatures(_Relate):
    """The command that joins form features to one rigid body."""

    name = "SheetMorph_GroupFeatures"
    function = "group"
    most = 10000
    text = QT_TRANSLATE_NOOP("SheetMorph_GroupFeatures", "Group Form Features")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_GroupFeatures", "Moves the selected form features of a part as one rigid body"
    )


class MakeCoaxial(_Relate):
    """The command that preserves the common axis of two form features."""

    name = "SheetMorph_MakeCoaxial"
    function = "coaxial"
    text = QT_TRANSLATE_NOOP("SheetMorph_MakeCoaxial", "Make Coaxial")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_MakeCoaxial",
        "Keeps two selected form features on a common axis, on one part or on two",
    )


class KeepDistance(_Relate):
    """The command that preserves the distance of two form features."""

    name = "SheetMorph_KeepDistance"
    function = "keep_distance"
    text = QT_TRANSLATE_NOOP("SheetMorph_KeepDistance", "Keep Distance")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_KeepDistance",
        "Keeps the distance between two selected form features, on one part or " "on two",
    )
