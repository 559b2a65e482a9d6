// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/rigid_motion.h"
#include "sheetmorph/mesh/triangle_mesh.h"

#include <utility>

namespace sheetmorph
{

//! Pairs of vertices whose distance vector a form feature keeps: F_k of (2.4).
using FeatureEdges = std::vector<std::pair<int, int>>;

//! The mesh edges inside every feature, and the pairs of its consecutive vertices.
std::vector<FeatureEdges> edges_of_features(const TriangleMesh& rest,
                                            const std::vector<VertexIds>& features);

//! How far a form feature is from (2.4): the worst |p_i - p_j - R (p_hat_i - p_hat_j)|, mm.
double edge_error(const TriangleMesh& rest, const FeatureEdges& edges, const Points& positions,
                  const RigidMotion& motion);

}  // namespace sheetmorph
