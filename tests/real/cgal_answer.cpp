// SPDX-License-Identifier: LGPL-2.1-or-later
// CGAL's smooth ARAP of one mesh: cgal_answer IN.off TARGETS OUT.xyz; a line of TARGETS is a vertex
// and where it goes (mm). Compiled by against_cgal.py; no part of the product.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/Surface_mesh_deformation.h>
#include <fstream>
#include <iomanip>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Deformer = CGAL::Surface_mesh_deformation<Mesh, CGAL::Default, CGAL::Default, CGAL::SRE_ARAP>;

int main(int count, char** arguments)
{
    Mesh mesh;
    if (count != 4 || !CGAL::IO::read_OFF(arguments[1], mesh))
        return 2;
    Deformer deformer(mesh);
    for (const Mesh::Vertex_index vertex : mesh.vertices())
        deformer.insert_roi_vertex(vertex);
    std::ifstream file(arguments[2]);
    std::vector<std::pair<Mesh::Vertex_index, Point>> targets;
    unsigned vertex = 0;
    double x = 0.0, y = 0.0, z = 0.0;
    while (file >> vertex >> x >> y >> z)
        targets.emplace_back(Mesh::Vertex_index(vertex), Point(x, y, z));
    for (const auto& [known, target] : targets)
        deformer.insert_control_vertex(known);
    if (!deformer.preprocess())
        return 3;
    for (const auto& [known, target] : targets)
        deformer.set_target_position(known, target);
    deformer.deform(200, 1e-6);
    std::ofstream out(arguments[3]);
    out << std::setprecision(17);
    for (const Mesh::Vertex_index each : mesh.vertices())
        out << mesh.point(each) << '\n';
    return 0;
}
