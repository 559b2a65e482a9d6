// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/thin/solid_facets.h"

#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/mesh/geometry/thinness.h"
#include "sheetmorph/mesh/topology/edges.h"

#include <Eigen/Geometry>

namespace sheetmorph
{

namespace
{

Vector3 corner(const TriangleMesh& mesh, int triangle, int k)
{
    return mesh.points().row(mesh.triangles()(triangle, k)).transpose();
}

void measure_facets(const TriangleMesh& mesh, SolidFacets& graph)
{
    const int count = mesh.triangle_count();
    graph.normals.resize(count, 3);
    graph.centres.resize(count, 3);
    graph.areas.resize(count);
    graph.is_thin.resize(at(count));
    for (int t = 0; t < count; ++t)
    {
        const Vector3 a = corner(mesh, t, 0), b = corner(mesh, t, 1), c = corner(mesh, t, 2);
        const Vector3 product = (b - a).cross(c - a);
        graph.areas(t) = 0.5 * product.norm();
        graph.normals.row(t) = product.stableNormalized().transpose();
        graph.centres.row(t) = (a + (b - a) / 3.0 + (c - a) / 3.0).transpose();
        graph.is_thin[at(t)] = is_thin(mesh.points(), mesh.triangles(), t);
    }
}

bool is_balanced(const EdgeUses& uses)
{
    int sum = 0;
    for (const EdgeUse& use : uses)
        sum += use.from < use.to ? 1 : -1;
    return sum == 0;
}

// Joins facets; returns the facets at edges that are open or torn.
std::vector<int> join_facets(const TriangleMesh& mesh, SolidFacets& graph)
{
    const EdgeTable table(mesh);
    std::vector<int> torn;
    for (int edge = 0; edge < table.count(); ++edge)
    {
        const EdgeUses uses = table.uses(edge);
        if (!is_balanced(uses))
            for (const EdgeUse& use : uses)
                torn.push_back(use.triangle);
        if (uses.count() != 2 || !is_balanced(uses))
            continue;
        const EdgeUse &one = *uses.begin(), &other = *(uses.begin() + 1);
        const bool has_planes =
            !graph.is_thin[at(one.triangle)] && !graph.is_thin[at(other.triangle)];
        const double bend = has_planes ? bend_angle(mesh.points(), one, other) : 0.0;
        const double length = (mesh.points().row(one.from) - mesh.points().row(one.to)).norm();
        graph.joints.push_back({one.triangle, other.triangle, bend, length});
    }
    return torn;
}

void number_components(SolidFacets& graph)
{
    const int count = graph.facet_count();
    DisjointSets sets(count);
    for (const FacetJoint& joint : graph.joints)
        sets.join(joint.one, joint.other);
    std::vector<int> number(at(count), -1);
    graph.component.resize(at(count));
    for (int t = 0; t < count; ++t)
    {
        int& of_root = number[at(sets.root(t))];
        if (of_root < 0)
        {
            of_root = graph.component_count();
            graph.is_closed.push_back(1);
        }
        graph.component[at(t)] = of_root;
    }
}

// Six times the volume each component encloses; its sign tells inside from outside.
std::vector<double> volumes(const TriangleMesh& mesh, const SolidFacets& graph)
{
    std::vector<double> sums(graph.is_closed.size(), 0.0);
    std::vector<Vector3> origin(graph.is_closed.size());
    std::vector<char> is_seen(graph.is_closed.size(), 0);
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        const std::size_t component = at(graph.component[at(t)]);
        if (!is_seen[component])
            origin[component] = corner(mesh, t, 0);
        is_seen[component] = 1;
        const Vector3 a = corner(mesh, t, 0) - origin[component];
        const Vector3 b = corner(mesh, t, 1) - origin[component];
        const Vector3 c = corner(mesh, t, 2) - origin[component];
        sums[component] += a.dot(b.cross(c));
    }
    return sums;
}

}  // namespace

SolidFacets solid_facets(const TriangleMesh& mesh)
{
    SolidFacets graph;
    measure_facets(mesh, graph);
    const std::vector<int> torn = join_facets(mesh, graph);
    number_components(graph);
    for (const int facet : torn)
        graph.is_closed[at(graph.component[at(facet)])] = 0;
    const std::vector<double> enclosed = volumes(mesh, graph);
    for (int t = 0; t < graph.facet_count(); ++t)
        if (enclosed[at(graph.component[at(t)])] < 0.0)
            graph.normals.row(t) *= -1.0;
    return graph;
}

}  // namespace sheetmorph
