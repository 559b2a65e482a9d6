// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sliver_sheet.h"

#include "sheetmorph/mesh/search/picking.h"
#include "panel.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace sheetmorph::benchmarks
{

using namespace mesh;

TriangleMesh with_slivers(const TriangleMesh& mesh)
{
    const int count = mesh.triangle_count();
    Points points(mesh.vertex_count() + (count + 2) / 3, 3);
    points.topRows(mesh.vertex_count()) = mesh.points();
    Triangles triangles(count + 2 * ((count + 2) / 3), 3);
    int vertex = mesh.vertex_count(), row = 0;
    for (int t = 0; t < count; ++t)
    {
        const int a = mesh.triangles()(t, 0), b = mesh.triangles()(t, 1),
                  c = mesh.triangles()(t, 2);
        if (t % 3 != 0)
        {
            triangles.row(row++) << a, b, c;
            continue;
        }
        points.row(vertex) =
            0.49 * mesh.points().row(a) + 0.49 * mesh.points().row(b) + 0.02 * mesh.points().row(c);
        triangles.row(row++) << a, b, vertex;
        triangles.row(row++) << b, c, vertex;
        triangles.row(row++) << c, a, vertex++;
    }
    return TriangleMesh(std::move(points), std::move(triangles));
}

const TriangleMesh& sliver_sheet()
{
    static const TriangleMesh made = with_slivers(curved_panel(46000).mesh);
    return made;
}

void count_remeshed(const TriangleMesh& made, benchmark::State& state)
{
    const PickingTree given(sliver_sheet());
    double farthest = 0.0;
    std::vector<double> smallest;
    for (int t = 0; t < made.triangle_count(); ++t)
    {
        double angle = M_PI;
        for (int k = 0; k < 3; ++k)
        {
            const auto corner = [&](int step)
            { return Vector3(made.points().row(made.triangles()(t, (k + step) % 3))); };
            const Vector3 one = corner(1) - corner(0), other = corner(2) - corner(0);
            angle = std::min(angle, std::atan2(one.cross(other).norm(), one.dot(other)));
            for (const Vector3& place : {corner(0), Vector3(0.5 * (corner(0) + corner(1)))})
                farthest = std::max(farthest, given.nearest_point(place)->distance);
        }
        smallest.push_back(angle * 180.0 / M_PI);
    }
    std::sort(smallest.begin(), smallest.end());
    state.counters["triangles_made"] = made.triangle_count();
    state.counters["worst_degrees"] = smallest.front();
    state.counters["hundredth_degrees"] = smallest[smallest.size() / 100];
    state.counters["median_degrees"] = smallest[smallest.size() / 2];
    state.counters["deviation_um"] = 1e3 * farthest;
}

}  // namespace sheetmorph::benchmarks
