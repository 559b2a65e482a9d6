// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/live/drawn_motions.h"
#include "sheetmorph/surface/live/response.h"
#include "panel_cases.h"

#include <numeric>

namespace sheetmorph::benchmarks
{

using namespace surface;

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

void edit(benchmark::State& state, const Panel& panel, const SurfaceConstraints& before,
          const SurfaceConstraints& after)
{
    const SurfaceDeformer earlier(panel.mesh, before);
    for (auto step : state)
    {
        (void)step;
        const SurfaceDeformer edited(panel.mesh, after, {}, &earlier);
        benchmark::DoNotOptimize(edited.factor_entries());
    }
    state.counters["vertices"] = panel.mesh.vertex_count();
}

// The user marks one more hole as a feature: the part as it was before is at hand.
void one_more_feature(benchmark::State& state)
{
    const Panel& panel = panel_of(static_cast<int>(state.range(0)));
    SurfaceConstraints before = panel.constraints;
    before.features.pop_back();
    edit(state, panel, before, panel.constraints);
}

// A strip across the panel is fixed as well.
void one_more_fixed_region(benchmark::State& state)
{
    const Panel& panel = panel_of(static_cast<int>(state.range(0)));
    SurfaceConstraints more = panel.constraints;
    const Points& points = panel.mesh.points();
    const double width = points.col(0).maxCoeff();
    more.fixed.push_back({"second strip", {}});
    for (int vertex = 0; vertex < panel.mesh.vertex_count(); ++vertex)
        if (points(vertex, 0) > 0.02 * width && points(vertex, 0) < 0.03 * width)
            more.fixed.back().vertices.push_back(vertex);
    edit(state, panel, panel.constraints, more);
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

std::unique_ptr<Response> learnt(const SurfaceDeformer& deformer, SurfaceTargets start,
                                 const std::vector<int>& turning)
{
    for (const int handle : turning)
        start.handles[static_cast<std::size_t>(handle)] = {};
    return deformer.response(own_poses(deformer.rest(), deformer.constraints(), start, turning),
                             {});
}

// Into one buffer, as a drag does; the response was built when the drag began.
void run_live(benchmark::State& state, const SurfaceDeformer& deformer,
              const std::vector<SurfaceTargets>& poses)
{
    std::vector<int> turning(poses.front().handles.size());
    std::iota(turning.begin(), turning.end(), 0);
    const auto response = learnt(deformer, poses.front(), turning);
    Deformation shape;
    std::size_t step = 0;
    for (auto pass : state)
    {
        (void)pass;
        response->place(response->frame(poses[step++ % poses.size()]).value(), shape);
        benchmark::DoNotOptimize(shape.positions.data());
    }
    const int vertices = deformer.rest().vertex_count();
    state.counters["vertices"] = vertices;
    state.counters["bytes_a_vertex"] = response->bytes() / vertices;
    state.counters["fields"] = static_cast<double>(response->fields());
}

std::vector<SurfaceTargets> drags(const Panel& panel)
{
    std::vector<SurfaceTargets> poses;
    for (int step = 0; step < 10; ++step)
        poses.push_back(drag(panel, step));
    return poses;
}

void live_frame(benchmark::State& state)
{
    const auto size = static_cast<int>(state.range(0));
    run_live(state, deformer_of(size), drags(panel_of(size)));
}

// The same panel with so many free features: its holes cut into pieces.
Panel with_free_features(const Panel& panel, std::size_t count)
{
    Panel made = panel;
    made.constraints.features.clear();
    const std::size_t parts =
        (count + panel.constraints.features.size() - 1) / panel.constraints.features.size();
    for (const FormFeature& hole : panel.constraints.features)
        for (std::size_t k = 0; k < parts && made.constraints.features.size() < count; ++k)
        {
            FormFeature piece = hole;
            piece.rotation = FeatureRotation::free;
            piece.name += " " + std::to_string(k);
            const auto at = [&](std::size_t part)
            {
                return hole.vertices.begin()
                       + static_cast<std::ptrdiff_t>(part * hole.vertices.size() / parts);
            };
            piece.vertices.assign(at(k), at(k + 1));
            made.constraints.features.push_back(piece);
        }
    return made;
}

void live_frame_50_free_features(benchmark::State& state)
{
    const Panel panel = with_free_features(panel_of(static_cast<int>(state.range(0))), 50);
    const SurfaceDeformer deformer(panel.mesh, panel.constraints);
    run_live(state, deformer, drags(panel));
}

// The same panel with its handle cut into three that turn about different axes.
void three_handles_frame(benchmark::State& state)
{
    const Panel& panel = panel_of(static_cast<int>(state.range(0)));
    SurfaceConstraints constraints = panel.constraints;
    const VertexIds whole = constraints.handles[0].vertices;
    constraints.handles.clear();
    const auto third = static_cast<std::ptrdiff_t>(whole.size() / 3);
    std::vector<SurfaceTargets> poses = drags(panel);
    for (SurfaceTargets& pose : poses)
        pose.handles.assign(3, pose.handles.front());
    for (int k = 0; k < 3; ++k)
    {
        const auto first = whole.begin() + k * third;
        constraints.handles.push_back({"handle " + std::to_string(k), {first, first + third}});
        for (std::size_t step = 0; step < poses.size(); ++step)
            poses[step].handles[static_cast<std::size_t>(k)].rotation_log =
                0.01 * static_cast<double>(step + 1) * Vector3::Unit(k);
    }
    const SurfaceDeformer deformer(panel.mesh, constraints);
    run_live(state, deformer, poses);
}

void response_set_up(benchmark::State& state)
{
    const SurfaceDeformer& deformer = deformer_of(static_cast<int>(state.range(0)));
    const SurfaceTargets start = drag(panel_of(static_cast<int>(state.range(0))), 0);
    for (auto pass : state)
    {
        (void)pass;
        benchmark::DoNotOptimize(learnt(deformer, start, {0}));
    }
    state.counters["vertices"] = panel_of(static_cast<int>(state.range(0))).mesh.vertex_count();
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
BENCHMARK(one_more_feature)->Apply(small_panel_sizes);
BENCHMARK(one_more_fixed_region)->Apply(small_panel_sizes);
BENCHMARK(live_frame)->Apply(panel_sizes);
BENCHMARK(live_frame_50_free_features)->Apply(small_panel_sizes);
BENCHMARK(three_handles_frame)->Apply(panel_sizes);
BENCHMARK(response_set_up)->Apply(panel_sizes);
BENCHMARK(substituted_frame)->Apply(panel_sizes);
BENCHMARK(exact_frame)->Apply(panel_sizes);

}  // namespace

}  // namespace sheetmorph::benchmarks

BENCHMARK_MAIN();
