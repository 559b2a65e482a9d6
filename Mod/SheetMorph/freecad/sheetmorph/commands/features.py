# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands about form features: what they may do, and what they keep between them."""

from freecad.sheetmorph import actions, subject
from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.commands.base import Command
from freecad.sheetmorph.qt import QtCore

QT_TRANSLATE_NOOP = QtCore.QT_TRANSLATE_NOOP


def chosen_features() -> list:
    """The form features that are selected."""
    return [region for region in subject.selected(subject.REGION) if region.Role == "form feature"]


class FeatureSettings(Command):
    """Opens the panel of a form feature."""

    name = "SheetMorph_FeatureSettings"
    text = QT_TRANSLATE_NOOP("SheetMorph_FeatureSettings", "Form Feature Settings…")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_FeatureSettings",
        "Says how the selected form feature turns, what it may do, and which size it has",
    )

    def possible(self) -> bool:
        """With one form feature selected."""
        return len(chosen_features()) == 1

    def execute(self) -> None:
        """Opens the panel."""
        from freecad.sheetmorph.panels import feature_panel

        feature_panel.open_panel(chosen_features()[0])


class _Relate(Command):
    """Relates the form features that are selected."""

    function = ""
    most = 2

    def possible(self) -> bool:
        """With two form features selected, or more where that makes sense."""
        return 2 <= len(chosen_features()) <= self.most

    def execute(self) -> None:
        """One undo step."""
        features = chosen_features()
        members = ", ".join(name(feature) for feature in features)
        if self.function == "group":
            members = f"[{members}]"
        owner = name(subject.assembly_of(features[0]))
        actions.attempt(self.text, call(self.function, owner, members))


class GroupFeatures(_Relate):
    """Makes form features one rigid body."""

    name = "SheetMorph_GroupFeatures"
    function = "group"
    most = 10000
    text = QT_TRANSLATE_NOOP("SheetMorph_GroupFeatures", "Group Form Features")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_GroupFeatures", "Lets the selected form features of a part move as one body"
    )


class MakeCoaxial(_Relate):
    """Lets two form features keep their axis."""

    name = "SheetMorph_MakeCoaxial"
    function = "coaxial"
    text = QT_TRANSLATE_NOOP("SheetMorph_MakeCoaxial", "Make Coaxial")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_MakeCoaxial",
        "Lets two selected form features, of one part or of two, keep their common axis",
    )


class KeepDistance(_Relate):
    """Lets two form features keep their distance."""

    name = "SheetMorph_KeepDistance"
    function = "keep_distance"
    text = QT_TRANSLATE_NOOP("SheetMorph_KeepDistance", "Keep Distance")
    tooltip = QT_TRANSLATE_NOOP(
        "SheetMorph_KeepDistance",
        "Lets two selected form features, of one part or of two, keep their distance",
    )
