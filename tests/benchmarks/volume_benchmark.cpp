// SPDX-License-Identifier: LGPL-2.1-or-later
// Mean value coordinates of points inside and around the paper's control mesh (386 vertices, 768
// triangles), on one core.
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/volume/control_mesh.h"
#include "sheetmorph/volume/mean_value_coordinates.h"

#include <benchmark/benchmark.h>

namespace sheetmorph::benchmarks
{

namespace
{

void mean_value_coordinates(benchmark::State& state)
{
    const volume::ControlShape shape;
    const volume::MeanValueCoordinates coordinates(shape.vertices(), shape.triangles());
    const Points points =
        Points::NullaryExpr(state.range(0), 3,
                            [](Eigen::Index row, Eigen::Index axis)
                            { return 0.9 * std::sin(1.3 * (row + 1) * (axis + 1.7)); });
    const ThreadCount one(1);
    for (auto pass : state)
    {
        (void)pass;
        benchmark::DoNotOptimize(coordinates.weights(points).data());
    }
    const std::int64_t pairs = state.range(0) * shape.triangles().rows();
    state.counters["million_pairs_a_second"] = benchmark::Counter(
        1e-6 * static_cast<double>(pairs * state.iterations()), benchmark::Counter::kIsRate);
}

BENCHMARK(mean_value_coordinates)
    ->Arg(4000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

}  // namespace

}  // namespace sheetmorph::benchmarks
