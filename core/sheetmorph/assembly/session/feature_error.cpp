// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/session/feature_error.h"

#include <algorithm>

namespace sheetmorph::assembly
{

std::vector<FeatureEdges> edges_of_features(const mesh::TriangleMesh& rest,
                                            const std::vector<VertexIds>& features)
{
    std::vector<FeatureEdges> edges(features.size());
    std::vector<std::vector<std::size_t>> owners(static_cast<std::size_t>(rest.vertex_count()));
    for (std::size_t f = 0; f < features.size(); ++f)
        for (std::size_t k = 0; k < features[f].size(); ++k)
        {
            owners[static_cast<std::size_t>(features[f][k])].push_back(f);
            if (k > 0)
                edges[f].emplace_back(features[f][k - 1], features[f][k]);
        }
    const Triangles& triangles = rest.triangles();
    for (int t = 0; t < rest.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
        {
            const int a = triangles(t, k);
            const int b = triangles(t, (k + 1) % 3);
            const std::vector<std::size_t>& of_b = owners[static_cast<std::size_t>(b)];
            for (const std::size_t f : owners[static_cast<std::size_t>(a)])
                if (std::find(of_b.begin(), of_b.end(), f) != of_b.end())
                    edges[f].emplace_back(a, b);
        }
    return edges;
}

double edge_error(const Points& rest, const FeatureEdges& edges, const Points& positions,
                  const RigidMotion& motion)
{
    const Matrix3 rotation = motion.rotation();
    double worst = 0.0;
    for (const auto& [a, b] : edges)
    {
        const Vector3 before = (rest.row(a) - rest.row(b)).transpose();
        const Vector3 after = (positions.row(a) - positions.row(b)).transpose();
        worst = std::max(worst, (after - rotation * before).norm());
    }
    return worst;
}

double outline_error(const SizedForm& form, const Points& deformed, const Matrix3& rotation)
{
    const Eigen::RowVector3d from = deformed.colwise().mean();
    const Points turned_back = (deformed.rowwise() - from) * rotation;
    const Points placed = turned_back.rowwise() + form.rest.colwise().mean();
    return form.shape.outline_error(placed, form.size);
}

}  // namespace sheetmorph::assembly
