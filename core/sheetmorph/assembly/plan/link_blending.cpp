// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/plan/link_blending.h"

#include "sheetmorph/base/vertex_sets.h"

#include <algorithm>
#include <limits>
#include <map>

namespace sheetmorph::assembly
{

namespace
{

// Reach of the blending, relative to the diagonal of the smaller region. Chosen: contacts that are
// a tenth of their size apart are one joint for the sheet between them.
constexpr double reach_of_region = 0.1;

//! The vertices that a link prescribes, before blending.
struct Region
{
    PlannedLink* link;
    int part;
    VertexIds vertices;  // ascending
    Points points;
    Eigen::RowVector3d low, high;

    double size() const { return (high - low).norm(); }
};

Region region_of(const Assembly& assembly, PlannedLink& link)
{
    const LinkTarget& target = link.targets.front();
    const mesh::TriangleMesh& mesh = assembly.parts[static_cast<std::size_t>(target.part)].mesh;
    Region region{&link, target.part, target.vertices, {}, {}, {}};
    make_set(region.vertices);
    region.points = rows_of(mesh.points(), region.vertices);
    region.low = region.points.colwise().minCoeff();
    region.high = region.points.colwise().maxCoeff();
    return region;
}

// Rows of `points` within the reach of the region's box.
std::vector<Eigen::Index> rows_near(const Points& points, const Region& region, double reach)
{
    std::vector<Eigen::Index> rows;
    for (Eigen::Index row = 0; row < points.rows(); ++row)
        if (((points.row(row) - region.low).array() > -reach).all()
            && ((region.high - points.row(row)).array() > -reach).all())
            rows.push_back(row);
    return rows;
}

// Adds the vertices of the other region near its own, with their weights.
void add_beside(const Region& own, const Region& other, std::map<int, double>& beside)
{
    const double reach = reach_of_region * std::min(own.size(), other.size());
    const std::vector<Eigen::Index> near = rows_near(own.points, other, reach);
    for (const Eigen::Index row : rows_near(other.points, own, reach))
    {
        const int vertex = other.vertices[static_cast<std::size_t>(row)];
        if (std::binary_search(own.vertices.begin(), own.vertices.end(), vertex))
            continue;
        double distance = std::numeric_limits<double>::infinity();
        for (const Eigen::Index of_own : near)
            distance = std::min(distance, (own.points.row(of_own) - other.points.row(row)).norm());
        if (distance < reach)
            beside[vertex] = std::max(beside[vertex], 1.0 - distance / reach);
    }
}

}  // namespace

void blend_neighbours(const Assembly& assembly, std::vector<PlannedLink>& links)
{
    std::vector<Region> regions;
    for (PlannedLink& link : links)
        if (link.contact >= 0)
            regions.push_back(region_of(assembly, link));
    for (const Region& own : regions)
    {
        LinkTarget& target = own.link->targets.front();
        std::map<int, double> beside;
        for (const Region& other : regions)
            if (&other != &own && other.link->type == own.link->type && other.part == own.part)
                add_beside(own, other, beside);
        target.weights.assign(target.vertices.size(), 1.0);
        for (const auto& [vertex, weight] : beside)
        {
            target.vertices.push_back(vertex);
            target.weights.push_back(weight);
        }
    }
}

}  // namespace sheetmorph::assembly
