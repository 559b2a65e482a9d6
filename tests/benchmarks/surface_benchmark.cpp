// SPDX-License-Identifier: LGPL-2.1-or-later
#include "panel.h"

#include "sheetmorph/base/rotation.h"
#include "sheetmorph/surface/surface_deformer.h"

#include <benchmark/benchmark.h>
#include <sys/resource.h>

namespace sheetmorph::benchmarks
{

namespace
{

// Another pose at every call, as a drag gives them: up to 60 degrees and a tenth of the panel.
SurfaceTargets drag(const Panel& panel, int step)
{
    const double part = 0.1 * (1 + step % 10);
    RigidMotion motion;
    motion.translation = part * 0.1 * panel.mesh.size() * Vector3(0.0, 0.2, 1.0);
    motion.rotation_log = rotation_log(Vector3(0.0, 1.0, 0.0), part * M_PI / 3.0);
    motion.pivot = panel.mesh.points().row(panel.constraints.handles[0].vertices[0]).transpose();
    SurfaceTargets targets;
    targets.handles = {motion};
    targets.feature_logs.assign(panel.constraints.features.size(), Vector3::Zero());
    return targets;
}

double peak_memory_mib()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void set_up(benchmark::State& state)
{
    const Panel panel = curved_panel(static_cast<int>(state.range(0)));
    double entries = 0.0;
    for (auto step : state)
    {
        (void)step;
        const SurfaceDeformer deformer(panel.mesh, panel.constraints);
        entries = deformer.factor_entries();
    }
    state.counters["vertices"] = panel.mesh.vertex_count();
    state.counters["factor_entries"] = entries;
    state.counters["peak_memory_mib"] = peak_memory_mib();
}

void frame(benchmark::State& state, Exactness exactness)
{
    const Panel panel = curved_panel(static_cast<int>(state.range(0)));
    const SurfaceDeformer deformer(panel.mesh, panel.constraints);
    int step = 0;
    for (auto pass : state)
    {
        (void)pass;
        benchmark::DoNotOptimize(deformer.deform(drag(panel, step++), exactness));
    }
    state.counters["vertices"] = panel.mesh.vertex_count();
}

void live_frame(benchmark::State& state)
{
    frame(state, Exactness::live);
}

void exact_frame(benchmark::State& state)
{
    frame(state, Exactness::exact);
}

// Smallest first, so that the peak memory of a size is its own.
void sizes(benchmark::internal::Benchmark* family)
{
    family->Arg(1000)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK(set_up)->Apply(sizes);
BENCHMARK(live_frame)->Apply(sizes);
BENCHMARK(exact_frame)->Apply(sizes);

}  // namespace

}  // namespace sheetmorph::benchmarks

BENCHMARK_MAIN();
