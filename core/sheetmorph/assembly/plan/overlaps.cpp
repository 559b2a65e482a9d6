// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/plan/overlaps.h"

#include "sheetmorph/assembly/labels.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"

#include <algorithm>
#include <sstream>

namespace sheetmorph::assembly
{

namespace
{

VertexIds shared_vertices(const PartRegion& fixed, const PartHandle& handle, int count)
{
    if (fixed.part != handle.part)
        return {};
    std::vector<char> is_fixed(at(count), 0);
    for (const int vertex : fixed.vertices)
        is_fixed[at(vertex)] = 1;
    VertexIds shared;
    for (const int vertex : handle.vertices)
        if (is_fixed[at(vertex)])
            shared.push_back(vertex);
    return shared;
}

[[noreturn]] void refuse(const Assembly& assembly, const Overlap& overlap, const VertexIds& moved,
                         double farthest)
{
    const PartHandle& handle = assembly.handles[at(overlap.handle)];
    const Part& part = assembly.parts[at(handle.part)];
    const bool is_one = moved.size() == 1;
    std::ostringstream after;
    after << ", which the handle moves by " << (is_one ? "" : "up to ") << farthest << " mm";
    throw in_part(
        {label_of("fixed region", assembly.fixed[at(overlap.fixed)]) + " and "
             + label_of("handle", handle) + " share " + Text::counted(moved) + after.str(),
         is_one ? "remove it from one of the two" : "remove them from one of the two",
         FaultCode::overlap},
        part);
}

}  // namespace

std::vector<Overlap> overlaps_of(const Assembly& assembly)
{
    std::vector<Overlap> found;
    for (std::size_t f = 0; f < assembly.fixed.size(); ++f)
        for (std::size_t h = 0; h < assembly.handles.size(); ++h)
        {
            const PartRegion& fixed = assembly.fixed[f];
            const int count = assembly.parts[at(fixed.part)].mesh.vertex_count();
            VertexIds shared = shared_vertices(fixed, assembly.handles[h], count);
            if (!shared.empty())
                found.push_back({static_cast<int>(f), static_cast<int>(h), std::move(shared)});
        }
    return found;
}

void check_overlaps(const Assembly& assembly, const std::vector<Overlap>& overlaps,
                    const Pose& pose)
{
    for (const Overlap& overlap : overlaps)
    {
        const PartHandle& handle = assembly.handles[at(overlap.handle)];
        const auto motion = pose.handles.find(handle.name);
        if (motion == pose.handles.end())
            continue;
        const Part& part = assembly.parts[at(handle.part)];
        const Points rest = part.mesh.points()(overlap.vertices, Eigen::indexing::all);
        const Eigen::VectorXd way = (motion->second.apply(rest) - rest).rowwise().norm();
        const double tolerance = mesh::exactness(part.mesh.points(), part.mesh.size());
        VertexIds moved;
        for (std::size_t k = 0; k < overlap.vertices.size(); ++k)
            if (!(way(static_cast<Eigen::Index>(k)) <= tolerance))
                moved.push_back(overlap.vertices[k]);
        if (!moved.empty())
            refuse(assembly, overlap, moved, way.maxCoeff());
    }
}

}  // namespace sheetmorph::assembly
