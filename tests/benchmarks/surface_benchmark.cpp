// SPDX-License-Identifier: LGPL-2.1-or-later
#include "panel_cases.h"

namespace sheetmorph::benchmarks
{

namespace
{

void set_up(benchmark::State& state)
{
    const Panel& panel = panel_of(static_cast<int>(state.range(0)));
    forget_deformers();
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
    const auto size = static_cast<int>(state.range(0));
    const Panel& panel = panel_of(size);
    const SurfaceDeformer& deformer = deformer_of(size);
    int step = 0;
    for (auto pass : state)
    {
        (void)pass;
        benchmark::DoNotOptimize(deformer.deform(drag(panel, step++), exactness));
    }
    state.counters["vertices"] = panel.mesh.vertex_count();
}

void substituted_frame(benchmark::State& state)
{
    frame(state, Exactness::live);
}

void exact_frame(benchmark::State& state)
{
    frame(state, Exactness::exact);
}

BENCHMARK(set_up)->Apply(panel_sizes);
BENCHMARK(substituted_frame)->Apply(panel_sizes);
BENCHMARK(exact_frame)->Apply(panel_sizes);

}  // namespace

}  // namespace sheetmorph::benchmarks

BENCHMARK_MAIN();
