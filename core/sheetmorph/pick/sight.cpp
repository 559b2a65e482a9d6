// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/pick/sight.h"

#include "sheetmorph/base/limits.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/mesh/regions/flags.h"
#include "sheetmorph/pick/vertex_cells.h"

#include <algorithm>

namespace sheetmorph::pick
{

namespace
{

// Vertices on one thread. Chosen, not measured: estimated at 20 ns a vertex, they take 100
// microseconds, three times as long as waking a thread.
constexpr std::size_t few = 5000;

// Screen points of the vertices of one shape, computed on first use.
class Picture
{
public:
    Picture(const mesh::PickingTree& tree, const Screen& screen)
        : points_(tree.points()),
          screen_(screen),
          seen_(tree.points().rows(), 3),
          is_known_(static_cast<std::size_t>(tree.points().rows()), 0)
    {
    }

    Vector3 operator()(int vertex)
    {
        if (!is_known_[static_cast<std::size_t>(vertex)])
        {
            seen_.row(vertex) = screen_.seen(points_.row(vertex));
            is_known_[static_cast<std::size_t>(vertex)] = 1;
        }
        return seen_.row(vertex);
    }

private:
    const Points& points_;
    const Screen& screen_;
    Points seen_;
    std::vector<char> is_known_;
};

VertexIds not_hidden(const std::vector<Seen>& seen, const Screen& screen,
                     const std::vector<const mesh::PickingTree*>& shapes)
{
    if (seen.empty())
        return {};
    VertexCells cells(seen);
    const mesh::Planes planes = screen.planes_around(cells.low(), cells.high());
    for (const mesh::PickingTree* shape : shapes)
    {
        Picture picture(*shape, screen);
        for (const int t : shape->triangles_between(planes))
        {
            const auto corners = shape->triangles().row(t);
            cells.hide_behind({picture(corners(0)), picture(corners(1)), picture(corners(2))});
        }
    }
    return cells.left();
}

}  // namespace

VertexIds vertices_inside(const mesh::PickingTree& tree, const Screen& screen,
                          const ScreenOutline& outline)
{
    mesh::Flags is_near(static_cast<std::size_t>(tree.points().rows()), 0);
    for (const int t : tree.triangles_between(screen.planes_around(outline.low(), outline.high())))
        for (int k = 0; k < 3; ++k)
            is_near[static_cast<std::size_t>(tree.triangles()(t, k))] = 1;
    VertexIds inside;
    for (const int vertex : mesh::ids_of(is_near))
        if (const Vector3 place = screen.seen(tree.points().row(vertex));
            outline.contains(place.x(), place.y()))
            inside.push_back(vertex);
    return inside;
}

VertexIds visible_vertices(const mesh::PickingTree& tree, const VertexIds& vertices,
                           const Screen& screen,
                           const std::vector<const mesh::PickingTree*>& shapes)
{
    std::vector<Seen> seen;
    const int count = static_cast<int>(tree.points().rows());
    for (const int vertex : mesh::ids_of(mesh::flags_of(vertices, count, "vertices")))
        if (const Vector3 place = screen.seen(tree.points().row(vertex)); are_numbers(place))
            seen.push_back({place, vertex});
    // Two bands of the screen, one per thread, each with its own cells.
    const auto middle = seen.begin() + static_cast<std::ptrdiff_t>(seen.size() / 2);
    std::nth_element(seen.begin(), middle, seen.end(),
                     [](const Seen& a, const Seen& b) { return a.place.y() < b.place.y(); });
    VertexIds visible, upper;
    if (seen.size() > few)
        parallel_pair(
            [&] {
                visible = not_hidden({seen.begin(), middle}, screen, shapes);
            },
            [&] {
                upper = not_hidden({middle, seen.end()}, screen, shapes);
            });
    else
        visible = not_hidden(seen, screen, shapes);
    visible.insert(visible.end(), upper.begin(), upper.end());
    std::sort(visible.begin(), visible.end());
    return visible;
}

}  // namespace sheetmorph::pick
