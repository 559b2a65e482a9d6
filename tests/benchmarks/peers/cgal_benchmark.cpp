// SPDX-License-Identifier: LGPL-2.1-or-later
// CGAL's Surface_mesh_deformation on the same panels: the same fixed strip and handle, the 20
// holes as holes of the mesh (it has no rigid features), the same drag. All vertices are its
// region of interest; a frame is one iteration, as little as it can do.
#include "panel_cases.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_deformation.h>
#include <CGAL/version.h>
#include <cstdlib>
#include <optional>

namespace sheetmorph::benchmarks
{

namespace
{

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

Mesh mesh_of(const Panel& panel)
{
    Mesh mesh;
    const auto index = [](Eigen::Index vertex)
    { return Mesh::Vertex_index(static_cast<Mesh::size_type>(vertex)); };
    for (const auto& point : panel.mesh.points().rowwise())
        mesh.add_vertex(Point(point(0), point(1), point(2)));
    for (const auto& triangle : panel.mesh.triangles().rowwise())
        mesh.add_face(index(triangle(0)), index(triangle(1)), index(triangle(2)));
    return mesh;
}

template <CGAL::Deformation_algorithm_tag algorithm>
using Deformer = CGAL::Surface_mesh_deformation<Mesh, CGAL::Default, CGAL::Default, algorithm>;

template <typename Peer>
void constrain(Peer& peer, const Mesh& mesh, const Panel& panel)
{
    for (const Mesh::Vertex_index vertex : mesh.vertices())
        peer.insert_roi_vertex(vertex);
    for (const auto* known : {&panel.constraints.fixed, &panel.constraints.handles})
        for (const surface::KnownRegion& region : *known)
            for (const int vertex : region.vertices)
                peer.insert_control_vertex(
                    Mesh::Vertex_index(static_cast<Mesh::size_type>(vertex)));
}

//! A peer that is ready, kept for the iterations that follow: at 1e6 it takes minutes.
template <CGAL::Deformation_algorithm_tag algorithm>
struct Ready
{
    Mesh mesh;
    std::optional<Deformer<algorithm>> peer;
    int size = 0;

    void make(const Panel& panel)
    {
        peer.reset();
        mesh = mesh_of(panel);
        peer.emplace(mesh);
        constrain(*peer, mesh, panel);
        size = 0;
    }
};

template <CGAL::Deformation_algorithm_tag algorithm>
Ready<algorithm>& ready()
{
    static Ready<algorithm> kept;
    return kept;
}

template <CGAL::Deformation_algorithm_tag algorithm>
void preprocess(benchmark::State& state)
{
    const Panel& panel = panel_of(static_cast<int>(state.range(0)));
    Ready<algorithm>& made = ready<algorithm>();
    for (auto step : state)
    {
        (void)step;
        state.PauseTiming();
        made.make(panel);
        state.ResumeTiming();
        if (!made.peer->preprocess())
            state.SkipWithError("CGAL could not preprocess the panel");
    }
    made.size = static_cast<int>(state.range(0));
    state.counters["vertices"] = panel.mesh.vertex_count();
    state.counters["peak_memory_mib"] = peak_memory_mib();
    state.SetLabel("CGAL " CGAL_VERSION_STR);
}

template <CGAL::Deformation_algorithm_tag algorithm>
void iteration(benchmark::State& state)
{
    const Panel& panel = panel_of(static_cast<int>(state.range(0)));
    Ready<algorithm>& made = ready<algorithm>();
    if (made.size != state.range(0))
    {
        made.make(panel);
        if (!made.peer->preprocess())
            state.SkipWithError("CGAL could not preprocess the panel");
        made.size = static_cast<int>(state.range(0));
    }
    Deformer<algorithm>& peer = *made.peer;
    int step = 0;
    for (auto pass : state)
    {
        (void)pass;
        const RigidMotion motion = drag_motion(panel, step++);
        for (const int vertex : panel.constraints.handles[0].vertices)
        {
            const Vector3 place = motion.apply(Vector3(panel.mesh.points().row(vertex)));
            peer.set_target_position(Mesh::Vertex_index(static_cast<Mesh::size_type>(vertex)),
                                     Point(place.x(), place.y(), place.z()));
        }
        peer.deform(1, 0.0);
    }
    state.counters["vertices"] = panel.mesh.vertex_count();
}

void cgal_sre_arap_set_up(benchmark::State& state)
{
    preprocess<CGAL::SRE_ARAP>(state);
}

void cgal_sre_arap_iteration(benchmark::State& state)
{
    iteration<CGAL::SRE_ARAP>(state);
}

void cgal_arap_set_up(benchmark::State& state)
{
    preprocess<CGAL::ORIGINAL_ARAP>(state);
}

void cgal_arap_iteration(benchmark::State& state)
{
    iteration<CGAL::ORIGINAL_ARAP>(state);
}

// Size by size, so that a set-up serves the iterations after it.
[[maybe_unused]] const bool are_registered = []
{
    for (const int size : {1000, 10000, 100000, 1000000})
    {
        const bool is_large = size > 100000;
        if (is_large && std::getenv("SHEETMORPH_BENCH_LARGE") == nullptr)
            continue;
        const auto add = [&](const char* name, void (*run)(benchmark::State&))
        {
            benchmark::RegisterBenchmark(name, run)
                ->Arg(size)
                ->Unit(benchmark::kMillisecond)
                ->UseRealTime()
                ->MeasureProcessCPUTime();
        };
        add("cgal_sre_arap_set_up", cgal_sre_arap_set_up);
        add("cgal_sre_arap_iteration", cgal_sre_arap_iteration);
        if (is_large)
            continue;
        add("cgal_arap_set_up", cgal_arap_set_up);
        add("cgal_arap_iteration", cgal_arap_iteration);
    }
    return true;
}();

}  // namespace

}  // namespace sheetmorph::benchmarks
