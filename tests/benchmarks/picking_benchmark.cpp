// SPDX-License-Identifier: LGPL-2.1-or-later
// What happens while the mouse moves over two curved sheets of together about 1,000,000 facets, one
// before the other, and when a lasso around all of it is closed. Single answers; medians by
// --benchmark_repetitions.
#include "sheetmorph/pick/neighbourhood.h"
#include "sheetmorph/pick/sight.h"
#include "panel.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace sheetmorph::benchmarks
{

using namespace mesh;
using namespace pick;

namespace
{

constexpr double width = 1600.0, height = 900.0;  // px

// Seen from above with a tilt, filling the view.
struct Scene
{
    TriangleMesh front = curved_panel(250000).mesh;
    TriangleMesh back =
        TriangleMesh(front.points().rowwise() + Eigen::RowVector3d(20, 30, -40), front.triangles());
    PickingTree front_tree{front};
    PickingTree back_tree{back};
    Neighbourhood near{back};
    Eigen::RowVector3d centre = front.points().colwise().mean();
    double scale = 2.0 / (front.points().colwise().maxCoeff() - centre).norm();

    Screen screen() const
    {
        Matrix4 to_clip = Matrix4::Identity();
        to_clip.topLeftCorner<3, 3>() << 0.5 * scale, 0, 0, 0, 0.6 * scale, 0.2 * scale, 0,
            0.05 * scale, -0.1 * scale;
        to_clip.topRightCorner<3, 1>() = -to_clip.topLeftCorner<3, 3>() * centre.transpose();
        return Screen(to_clip, width, height);
    }
};

const Scene& scene()
{
    static const Scene made;
    return made;
}

ScreenOutline circle(double radius)
{
    ScreenPoints corners(48, 2);
    for (int k = 0; k < 48; ++k)
        corners.row(k) << 0.5 * width + radius * std::cos(0.1309 * k),
            0.5 * height + radius * std::sin(0.1309 * k);
    return ScreenOutline(corners);
}

// Runs work(), which returns ids, and tells how many they were.
template <typename Work>
void measure(benchmark::State& state, Work work)
{
    scene();  // made before the clock runs
    std::size_t count = 0;
    for (auto pass : state)
    {
        (void)pass;
        count = work().size();
    }
    state.counters["ids"] = static_cast<double>(count);
}

void pick_hover_ray(benchmark::State& state)
{
    double place = 0.0;
    measure(state,
            [&]
            {
                place = std::fmod(place + 7.3, 500.0);
                const Vector3 origin = scene().centre.transpose() + Vector3(place, place, 1000);
                return std::vector<bool>(scene().back_tree.nearest_hit(origin, {0, 0, -1}) ? 1 : 0);
            });
}

void pick_outline(benchmark::State& state)
{
    const ScreenOutline outline = circle(static_cast<double>(state.range(0)));
    measure(state, [&] { return vertices_inside(scene().back_tree, scene().screen(), outline); });
}

void pick_visible_in_outline(benchmark::State& state)
{
    const ScreenOutline outline = circle(static_cast<double>(state.range(0)));
    measure(state,
            [&]
            {
                const Screen screen = scene().screen();
                return visible_vertices(scene().back_tree,
                                        vertices_inside(scene().back_tree, screen, outline), screen,
                                        {&scene().back_tree, &scene().front_tree});
            });
}

void pick_face(benchmark::State& state)
{
    measure(state, [&] { return scene().near.face(1000, 0.5); });
}

void pick_grow(benchmark::State& state)
{
    const VertexIds start = scene().near.grown({1000}, 30);
    measure(state, [&] { return scene().near.grown(start, 1); });
}

void pick_set_up(benchmark::State& state)
{
    measure(state,
            [&]
            {
                benchmark::DoNotOptimize(PickingTree(scene().back));
                benchmark::DoNotOptimize(Neighbourhood(scene().back));
                return VertexIds(1);
            });
}

BENCHMARK(pick_hover_ray)->Unit(benchmark::kMicrosecond);
BENCHMARK(pick_outline)->Arg(30)->Arg(2000)->Unit(benchmark::kMillisecond);
BENCHMARK(pick_visible_in_outline)->Arg(30)->Arg(2000)->Unit(benchmark::kMillisecond);
BENCHMARK(pick_face)->Unit(benchmark::kMillisecond);
BENCHMARK(pick_grow)->Unit(benchmark::kMillisecond);
BENCHMARK(pick_set_up)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace sheetmorph::benchmarks
