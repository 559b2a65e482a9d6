# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scripting interface of SheetMorph: everything in the workbench, without a window.

`doc` is the active document, as macros write it.

Lengths are in mm, angles in degrees. Vectors and points are in global coordinates, as the user sees
them. Vertices are indices into the mesh of their part. No call recomputes: call
`document.recompute()` after the changes. Invalid arguments raise ValueError with a remedy and
change nothing.
"""

import FreeCAD

from freecad.sheetmorph.api import following
from freecad.sheetmorph.api.assemblies import (
    add_part,
    create_assembly,
    remove,
    remove_dependents,
    set_energy,
    set_operator,
    set_primary,
    set_refine,
    set_symmetry,
    set_unheld,
)
from freecad.sheetmorph.api.certificates import certify
from freecad.sheetmorph.api.cad import add_shape, exact_features, import_cad
from freecad.sheetmorph.api.contacts import (
    add_contact,
    contact_vertices,
    set_active,
    set_contact_type,
    set_contact_vertices,
    touching_vertices,
)
from freecad.sheetmorph.api.decks import import_deck
from freecad.sheetmorph.api.features import (
    coaxial,
    group,
    keep_distance,
    set_feature_motion,
    set_size,
    shape_of,
)
from freecad.sheetmorph.api.files import (
    export_recipe,
    import_part,
    import_recipe,
    in_the_way,
    write_parts,
)
from freecad.sheetmorph.api.finding import (
    add_found_contacts,
    add_found_features,
    find_contacts,
    find_features,
)
from freecad.sheetmorph.api.motions import (
    deform,
    pivot,
    reset_motion,
    set_free_rotation,
    set_motion,
    set_rotation,
)
from freecad.sheetmorph.api.picking import (
    diagnose,
    face,
    global_frame,
    grow,
    hole_rim,
    hole_rims,
    invert,
    piece,
    rest_mesh,
    shrink,
    vertices_inside,
    vertices_of_facets,
)
from freecad.sheetmorph.api.poses import (
    apply_pose,
    blend_poses,
    compare_poses,
    copy_as_meshes,
    copy_in_pose,
    poses,
    save_pose,
)
from freecad.sheetmorph.api.preparing import (
    diagnose_original,
    places_of,
    preparation,
    preparation_of,
    prepare,
    split_part,
)
from freecad.sheetmorph.api.propagations import (
    control_mesh,
    propagation,
    set_mode,
    set_propagation,
)
from freecad.sheetmorph.api.regions import (
    add_feature,
    add_fixed,
    add_follower,
    add_handle,
    hold_loose_pieces,
    select,
    set_vertices,
    take_out,
    vertices,
    where,
)
from freecad.sheetmorph.api.replacing import follow_shape, replace_file
from freecad.sheetmorph.api.shapes import deformed_shape, update_shapes
from freecad.sheetmorph.api.flat import flatten
from freecad.sheetmorph.api.studies import (
    add_study,
    apply_variant,
    results,
    run_study,
    set_study,
    variables,
    write_study,
)
from freecad.sheetmorph.api.thin import (
    add_through_holes,
    propose_thin,
    set_sheet,
    set_thin,
    thin_solid,
)


def __getattr__(name: str):
    """Return the active document for `doc`."""
    if name == "doc":
        return FreeCAD.ActiveDocument
    raise AttributeError(f"module '{__name__}' has no attribute '{name}'")


Unbound = following.Unbound

__all__ = [
    "add_contact",
    "add_feature",
    "add_fixed",
    "add_follower",
    "add_found_contacts",
    "add_found_features",
    "add_handle",
    "add_part",
    "add_shape",
    "add_study",
    "add_through_holes",
    "apply_pose",
    "apply_variant",
    "blend_poses",
    "certify",
    "coaxial",
    "compare_poses",
    "contact_vertices",
    "control_mesh",
    "copy_as_meshes",
    "copy_in_pose",
    "create_assembly",
    "deform",
    "deformed_shape",
    "diagnose",
    "diagnose_original",
    "exact_features",
    "export_recipe",
    "face",
    "find_contacts",
    "find_features",
    "flatten",
    "global_frame",
    "group",
    "grow",
    "hold_loose_pieces",
    "hole_rim",
    "hole_rims",
    "import_cad",
    "import_deck",
    "import_part",
    "import_recipe",
    "in_the_way",
    "invert",
    "keep_distance",
    "piece",
    "pivot",
    "places_of",
    "poses",
    "preparation",
    "preparation_of",
    "prepare",
    "propagation",
    "propose_thin",
    "remove",
    "remove_dependents",
    "follow_shape",
    "replace_file",
    "reset_motion",
    "rest_mesh",
    "results",
    "run_study",
    "save_pose",
    "select",
    "set_active",
    "set_contact_type",
    "set_contact_vertices",
    "set_energy",
    "set_feature_motion",
    "set_free_rotation",
    "set_mode",
    "set_motion",
    "set_operator",
    "set_primary",
    "set_propagation",
    "set_refine",
    "set_rotation",
    "set_size",
    "set_symmetry",
    "set_sheet",
    "set_study",
    "set_thin",
    "set_unheld",
    "set_vertices",
    "shape_of",
    "shrink",
    "split_part",
    "take_out",
    "thin_solid",
    "touching_vertices",
    "variables",
    "vertices",
    "vertices_inside",
    "vertices_of_facets",
    "where",
    "write_parts",
    "write_study",
    "update_shapes",
]
