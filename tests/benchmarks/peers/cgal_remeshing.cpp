// SPDX-License-Identifier: LGPL-2.1-or-later
// CGAL's isotropic remeshing of the same sheet: the same edge length, rims and borders kept as ours
// are. Its mesh processing is under the GPL: it is linked into the benchmarks alone.
#include "sliver_sheet.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

namespace sheetmorph::benchmarks
{

namespace
{

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

constexpr unsigned rounds = 10;  // of splits, collapses, flips and relaxation

Mesh mesh_of(const mesh::TriangleMesh& sheet)
{
    Mesh mesh;
    const auto index = [](int vertex)
    { return Mesh::Vertex_index(static_cast<Mesh::size_type>(vertex)); };
    for (const auto& point : sheet.points().rowwise())
        mesh.add_vertex(Point(point(0), point(1), point(2)));
    for (const auto& triangle : sheet.triangles().rowwise())
        mesh.add_face(index(triangle(0)), index(triangle(1)), index(triangle(2)));
    return mesh;
}

mesh::TriangleMesh ours(Mesh mesh)
{
    mesh.collect_garbage();
    Points points(static_cast<Eigen::Index>(mesh.number_of_vertices()), 3);
    for (const Mesh::Vertex_index vertex : mesh.vertices())
        for (int axis = 0; axis < 3; ++axis)
            points(vertex.idx(), axis) = mesh.point(vertex)[axis];
    Triangles triangles(static_cast<Eigen::Index>(mesh.number_of_faces()), 3);
    for (const Mesh::Face_index face : mesh.faces())
    {
        int corner = 0;
        for (const Mesh::Vertex_index vertex : mesh.vertices_around_face(mesh.halfedge(face)))
            triangles(face.idx(), corner++) = static_cast<int>(vertex.idx());
    }
    return mesh::TriangleMesh(std::move(points), std::move(triangles));
}

void cgal_sheet_remeshing(benchmark::State& state)
{
    namespace processing = CGAL::Polygon_mesh_processing;
    const Mesh given = mesh_of(sliver_sheet());
    Mesh made;
    for (auto step : state)
    {
        (void)step;
        made = given;
        auto is_kept = made.add_property_map<Mesh::Edge_index, bool>("e:kept", false).first;
        for (const Mesh::Edge_index edge : made.edges())
            is_kept[edge] = made.is_border(edge);
        processing::isotropic_remeshing(made.faces(), wanted_edge, made,
                                        CGAL::parameters::number_of_iterations(rounds)
                                            .edge_is_constrained_map(is_kept)
                                            .protect_constraints(true));
    }
    count_remeshed(ours(std::move(made)), state);
}

BENCHMARK(cgal_sheet_remeshing)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

}  // namespace

}  // namespace sheetmorph::benchmarks
