// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/errors.h"
#include "sheetmorph/volume/mean_value_kernel.h"

#include <map>
#include <utility>

namespace sheetmorph::volume
{

namespace
{

[[noreturn]] void refuse_edge(int from, int to)
{
    throw InvalidInput(
        "the control mesh is not closed and consistently oriented at the edge between "
        "its vertices "
            + std::to_string(from) + " and " + std::to_string(to),
        "every edge needs two triangles that run along it in opposite directions");
}

// Numbers the edges; each must occur once in each direction.
class EdgeNumbers
{
public:
    explicit EdgeNumbers(KernelMesh& mesh) : mesh_(mesh) {}

    void add(int from, int to)
    {
        const bool forwards = from < to;
        const auto key = forwards ? std::make_pair(from, to) : std::make_pair(to, from);
        const auto [found, is_new] = edges_.try_emplace(key, Uses{mesh_.edge_count(), 0, 0});
        if (is_new)
            mesh_.edge_ends.insert(mesh_.edge_ends.end(), {key.first, key.second});
        int& uses = forwards ? found->second.forwards : found->second.backwards;
        if (++uses > 1 || from == to)
            refuse_edge(from, to);
        mesh_.triangle_edges.push_back(found->second.edge);
        mesh_.edge_signs.push_back(forwards ? 1.0 : -1.0);
    }

    void check_closed() const
    {
        for (const auto& [ends, uses] : edges_)
            if (uses.forwards != uses.backwards)
                refuse_edge(ends.first, ends.second);
    }

private:
    struct Uses
    {
        int edge, forwards, backwards;
    };
    KernelMesh& mesh_;
    std::map<std::pair<int, int>, Uses> edges_;
};

}  // namespace

KernelMesh kernel_mesh(const Points& vertices, const Triangles& triangles)
{
    KernelMesh mesh;
    mesh.vertices.assign(vertices.data(), vertices.data() + vertices.size());
    mesh.triangle_vertices.assign(triangles.data(), triangles.data() + triangles.size());
    EdgeNumbers table(mesh);
    for (Eigen::Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k)
            table.add(triangles(t, (k + 1) % 3), triangles(t, (k + 2) % 3));
    table.check_closed();
    for (int e = 0; e < mesh.edge_count(); ++e)
        for (int a = 0; a < 3; ++a)
            mesh.edge_vectors.push_back(vertices(mesh.edge_ends[2 * e + 1], a)
                                        - vertices(mesh.edge_ends[2 * e], a));
    return mesh;
}

KernelBlock::KernelBlock(const KernelMesh& mesh)
    : points(1),
      unit(mesh.vertex_count()),
      cross(mesh.edge_count()),
      inverse_distance(mesh.vertex_count()),
      half_angle_ratio(mesh.edge_count()),
      weights(mesh.vertex_count())
{
}

}  // namespace sheetmorph::volume
