# SPDX-License-Identifier: LGPL-2.1-or-later
"""View providers: icon, tree, double click and context menu of document objects."""


def attach(obj) -> None:
    """Attach the view provider of a document object; the objects call it through `doors`."""
    from freecad.sheetmorph.views import assembly, contact, deck, part, pose, region, relation
    from freecad.sheetmorph.views import study

    providers = {
        "SheetMorph::Assembly": assembly.AssemblyView,
        "SheetMorph::Contact": contact.ContactView,
        "SheetMorph::Deck": deck.DeckView,
        "SheetMorph::Deformation": assembly.DeformationView,
        "SheetMorph::Part": part.PartView,
        "SheetMorph::Pose": pose.PoseView,
        "SheetMorph::Region": region.RegionView,
        "SheetMorph::Relation": relation.RelationView,
        "SheetMorph::Shells": deck.ShellsView,
        "SheetMorph::Study": study.StudyView,
    }
    provider = providers.get(getattr(obj.Proxy, "Type", ""))
    view = obj.ViewObject
    if provider is not None and view is not None:
        provider(view)
