// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/rigid_motion.h"
#include "sheetmorph/forms/feature_shape.h"
#include "sheetmorph/mesh/triangle_mesh.h"

#include <utility>

namespace sheetmorph::assembly
{

//! Pairs of vertices whose distance vector a form feature keeps: F_k of (2.4).
using FeatureEdges = std::vector<std::pair<int, int>>;

//! The mesh edges inside every feature, and the pairs of its consecutive vertices.
std::vector<FeatureEdges> edges_of_features(const mesh::TriangleMesh& rest,
                                            const std::vector<VertexIds>& features);

//! Error of a form feature in (2.4): the largest |p_i - p_j - R (p_hat_i - p_hat_j)|, mm.
//! \param rest  (n, 3) mm; with the sizes of the features, if set
double edge_error(const Points& rest, const FeatureEdges& edges, const Points& positions,
                  const RigidMotion& motion);

//! A form feature with its size in a pose.
struct SizedForm
{
    const forms::FeatureShape& shape;
    double size = 0.0;  //!< mm
    Points rest;        //!< (k, 3) mm, with that size
};

//! Largest distance of its rim from the exact circle (slot, cylinder) of its size, mm.
//! \param deformed  (k, 3) mm
double outline_error(const SizedForm& form, const Points& deformed, const Matrix3& rotation);

}  // namespace sheetmorph::assembly
