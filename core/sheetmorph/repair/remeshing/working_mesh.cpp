// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/repair/remeshing/working_mesh.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/repair/soup.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace sheetmorph
{

WorkingMesh::WorkingMesh(const WorkingInput& input)
    : is_flat_(input.is_flat), largest_(input.largest)
{
    origin = surface.add_property_map<Vertex, int>("v:origin", -1).first;
    is_frozen = surface.add_property_map<Vertex, bool>("v:is_frozen", false).first;
    size = surface.add_property_map<Vertex, double>("v:size", 0.0).first;
    is_ridge = surface.add_property_map<Edge, bool>("e:is_ridge", false).first;
    patch = surface.add_property_map<Face, int>("f:patch", -1).first;
    const OrientedSoup soup = oriented(input.mesh);
    for (const int vertex : soup.original)
    {
        const Vector3 place = input.mesh.points().row(vertex);
        const Vertex v = surface.add_vertex({place.x(), place.y(), place.z()});
        origin[v] = vertex;
        size[v] = input.sizes[vertex];
    }
    for (int t = 0; t < soup.manifold_triangles.rows(); ++t)
    {
        const auto corner = [&](int k)
        { return Vertex(static_cast<std::uint32_t>(soup.manifold_triangles(t, k))); };
        const Face face = surface.add_face(corner(0), corner(1), corner(2));
        if (face == SurfaceMesh::null_face())
            throw SolverError("triangle " + std::to_string(t) + " fits in no manifold mesh");
        patch[face] = input.patch[t];
    }
    mark_ridges(input.ridges);
    freeze_vertices(soup.original);
}

void WorkingMesh::mark_ridges(const std::vector<std::pair<int, int>>& ridges)
{
    for (const Edge e : surface.edges())
    {
        const int a = origin[surface.vertex(e, 0)], b = origin[surface.vertex(e, 1)];
        is_ridge[e] = surface.is_border(e)
                      || std::binary_search(ridges.begin(), ridges.end(),
                                            std::pair(std::min(a, b), std::max(a, b)));
    }
}

// A vertex that had to be copied holds pieces together in one place: it stays there too.
void WorkingMesh::freeze_vertices(const std::vector<int>& original)
{
    std::vector<int> copies(original.size(), 0);
    for (const int vertex : original)
        ++copies[vertex];
    for (const Vertex v : surface.vertices())
        is_frozen[v] = copies[origin[v]] > 1 || surface.is_isolated(v);
    for (const Edge e : surface.edges())
        if (is_ridge[e])
            is_frozen[surface.vertex(e, 0)] = is_frozen[surface.vertex(e, 1)] = true;
}

Vector3 WorkingMesh::point(Vertex v) const
{
    const auto& p = surface.point(v);
    return Vector3(p.x(), p.y(), p.z());
}

void WorkingMesh::move(Vertex v, const Vector3& place)
{
    surface.point(v) = {place.x(), place.y(), place.z()};
}

Vector3 WorkingMesh::area_vector(const Vector3& a, const Vector3& b, const Vector3& c)
{
    return (b - a).cross(c - a);
}

Vector3 WorkingMesh::area_vector(Face face) const
{
    const Halfedge h = surface.halfedge(face);
    return area_vector(point(surface.source(h)), point(surface.target(h)),
                       point(surface.target(surface.next(h))));
}

double WorkingMesh::length(Edge e) const
{
    return (point(surface.vertex(e, 0)) - point(surface.vertex(e, 1))).norm();
}

double WorkingMesh::largest_size(Edge e) const
{
    for (const Halfedge h : {surface.halfedge(e), surface.opposite(surface.halfedge(e))})
        if (!surface.is_border(h) && !is_flat_[patch[surface.face(h)]])
            return std::max(size[surface.vertex(e, 0)], size[surface.vertex(e, 1)]);
    return largest_;
}

double WorkingMesh::wanted_length(Edge e) const
{
    return 0.5 * (size[surface.vertex(e, 0)] + size[surface.vertex(e, 1)]);
}

}  // namespace sheetmorph
