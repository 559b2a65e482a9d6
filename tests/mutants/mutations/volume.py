# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mistakes in mean value coordinates, control meshes, boxes, local rotations and links."""
from mutation import Mutation

KERNEL = "volume/mean_value_kernel.cpp"
GRAZED = "volume/grazed_triangle.cpp"
ROTATIONS = "volume/local_rotations.cpp"
LINK = "volume/volume_link.cpp"
BOX = "volume/oriented_box.cpp"
VALUES = "MeanValue*"

MUTATIONS = [
    # Mean value weights, equations (2.11) to (2.14).
    Mutation(
        KERNEL,
        "IfThenElse(is_sound, load(block.weights[v]) * inverse, alike)",
        "Abs(alike)",
        VALUES,
    ),
    Mutation(KERNEL, "filled(sign[1]) * load", "load", VALUES),
    Mutation(KERNEL, "filled(sign[0] * sign[2])", "filled(sign[1] * sign[2])", VALUES),
    Mutation(KERNEL, "any(t > filled(0.25))", "any(t > filled(0.95))", VALUES),
    Mutation(KERNEL, "grazing = 3e-4", "grazing = 3e-9", VALUES),
    Mutation(
        KERNEL,
        "load(block.weights[v]) * load(block.inverse_distance[v])",
        "load(block.weights[v])",
        VALUES,
    ),
    Mutation(KERNEL, "filled(share[2])}", "filled(0.0)}", VALUES),
    Mutation(
        KERNEL,
        "inverse = load(block.inverse_distance[j])",
        "inverse = load(block.inverse_distance[i])",
        VALUES,
    ),
    Mutation(GRAZED, "/ (2 * sine)", "/ sine", VALUES),
    Mutation(GRAZED, "flat = 1e-9L", "flat = 1e-1L", VALUES),
    Mutation(GRAZED, "distance <= tolerance", "distance <= 1e6 * tolerance", VALUES),
    Mutation(
        "volume/mean_value_coordinates.cpp",
        "share.weights(k) / block.inverse_distance",
        "share.weights(k) * block.inverse_distance",
        VALUES,
    ),
    # The fit of a control mesh, equation (3.3), and its shape.
    Mutation("volume/control_mesh_fit.cpp", "(areas / areas.mean())", "areas", "ControlMeshFit*"),
    Mutation(
        "volume/control_mesh_fit.cpp", "smoothness * share *", "smoothness *", "ControlMeshFit*"
    ),
    Mutation(
        "volume/control_mesh.cpp",
        "-1.0 / valence[face[k]]",
        "-1.0 / valence[face[(k + 1) % 4]]",
        "ControlMeshTest.*",
    ),
    Mutation(
        "volume/control_mesh.cpp",
        "middle[(k + 3) % 4]});",
        "middle[(k + 1) % 4]});",
        "ControlMeshTest.*",
    ),
    Mutation(BOX, "axes * (0.5 * (low + high))", "axes * (0.5 * (high - low))", "OrientedBox*"),
    Mutation(BOX, ".array() + options.margin * largest", ".array()", "OrientedBox*"),
    # How rings turn.
    Mutation(ROTATIONS, "moments += spoke.triangles[lane] * edge", "moments += edge", "LocalRot*"),
    Mutation(
        ROTATIONS,
        "motion.translation = (share.transpose() * (deformed - rest)).transpose()",
        "motion.translation = (deformed - rest).colwise().mean().transpose()",
        "MeanMotion*",
    ),
    Mutation(
        "volume/rotations/rotation_kernel.cpp",
        "hn::MulSub(before.at[y], now.at[z], before.at[z] * now.at[y])",
        "hn::MulSub(before.at[z], now.at[y], before.at[y] * now.at[z])",
        "LocalRot*",
    ),
    Mutation(
        "volume/rotations/rotation_kernel.cpp",
        "{{0, 3, 4}, {3, 1, 5}, {4, 5, 2}}",
        "{{0, 3, 4}, {3, 1, 4}, {4, 4, 2}}",
        "LocalRot*",
    ),
    # From sources over control meshes to targets.
    Mutation(LINK, "/ (2.0 * steps_.col(a).norm())", "/ steps_.col(a).norm()", "VolumeLink*"),
    Mutation(LINK, "above - below;", "above + below;", "VolumeLink*"),
    Mutation(LINK, "negligible = 0x1p-43", "negligible = 0x1p-20", "VolumeLink*"),
    Mutation(
        LINK,
        "state.positions - state.mean.apply(source_)",
        "state.positions - source_",
        "VolumeLink*",
    ),
]
