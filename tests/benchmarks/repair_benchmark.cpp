// SPDX-License-Identifier: LGPL-2.1-or-later
// Diagnosis, cures and remeshing of a dirty mesh: a closed sheet of two curved skins with 20 holes,
// 300,000 triangles, a third of them slivers, every hundredth vertex cut apart as CAD does where
// faces meet. Single answers; medians by --benchmark_repetitions.
#include "sheetmorph/mesh/quality/diagnosis.h"
#include "sheetmorph/repair/cures.h"
#include "sheetmorph/repair/remeshing/remeshing.h"
#include "panel.h"
#include "sliver_sheet.h"

#include <benchmark/benchmark.h>

namespace sheetmorph::benchmarks
{

using namespace mesh;
using namespace repair;

namespace
{

constexpr double thickness = 2.0;

// Both skins; they stay open at the rims, for the wall adds hardly a triangle.
TriangleMesh both_skins(const TriangleMesh& sheet)
{
    const int count = sheet.vertex_count();
    Points points(2 * count, 3);
    points << sheet.points(), sheet.points().rowwise() - Eigen::RowVector3d(0, 0, thickness);
    Triangles triangles(2 * sheet.triangle_count(), 3);
    triangles << sheet.triangles(), sheet.triangles().rowwise().reverse().array() + count;
    return TriangleMesh(std::move(points), std::move(triangles));
}

// Every hundredth corner of a triangle is a vertex of its own, a hair beside the one it was.
TriangleMesh cut_apart(const TriangleMesh& mesh)
{
    constexpr Eigen::Index every = 100;
    Triangles triangles = mesh.triangles();
    const Eigen::Index more = (triangles.size() + every - 1) / every;
    Points points(mesh.points().rows() + more, 3);
    points.topRows(mesh.points().rows()) = mesh.points();
    for (Eigen::Index k = 0; k < triangles.size(); k += every)
    {
        const Eigen::Index vertex = mesh.points().rows() + k / every;
        points.row(vertex) = mesh.points().row(triangles.data()[k]).array() + 1e-6;
        triangles.data()[k] = static_cast<int>(vertex);
    }
    return TriangleMesh(std::move(points), std::move(triangles));
}

const TriangleMesh& dirty_mesh()
{
    static const TriangleMesh made = cut_apart(with_slivers(both_skins(curved_panel(46000).mesh)));
    return made;
}

void diagnosis(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(diagnose(dirty_mesh(), 1e-4));
    state.counters["triangles"] = dirty_mesh().triangle_count();
    state.counters["slivers"] = diagnose(dirty_mesh(), 1e-4).slivers;
}

void cures(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(cured(dirty_mesh(), 1e-4));
}

void remeshing(benchmark::State& state)
{
    const TriangleMesh whole = cured(dirty_mesh(), 1e-4).mesh;
    RemeshOptions options;
    options.edge = wanted_edge;
    double made = 0.0, deviation = 0.0;
    for (auto _ : state)
    {
        const RemeshedMesh found = remeshed(whole, options);
        made = found.mesh.triangle_count();
        deviation = found.deviation;
    }
    state.counters["triangles"] = whole.triangle_count();
    state.counters["triangles_made"] = made;
    state.counters["deviation_um"] = 1e3 * deviation;
}

void sheet_remeshing(benchmark::State& state)
{
    RemeshOptions options;
    options.edge = wanted_edge;
    TriangleMesh made;
    for (auto _ : state)
        made = remeshed(sliver_sheet(), options).mesh;
    count_remeshed(made, state);
}

BENCHMARK(diagnosis)->Arg(300000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(cures)->Arg(300000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(sheet_remeshing)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK(remeshing)->Arg(300000)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

}  // namespace

}  // namespace sheetmorph::benchmarks
