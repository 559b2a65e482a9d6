// SPDX-License-Identifier: LGPL-2.1-or-later
#include "panel_cases.h"

#include "sheetmorph/base/rotation.h"

#include <cstdlib>
#include <map>
#include <sys/resource.h>

namespace sheetmorph::benchmarks
{

using namespace surface;

namespace
{

std::map<int, SurfaceDeformer>& deformers()
{
    static std::map<int, SurfaceDeformer> made;
    return made;
}

}  // namespace

const Panel& panel_of(int vertices)
{
    static std::map<int, Panel> panels;
    const auto found = panels.find(vertices);
    return found != panels.end() ? found->second
                                 : panels.emplace(vertices, curved_panel(vertices)).first->second;
}

const SurfaceDeformer& deformer_of(int vertices)
{
    const auto found = deformers().find(vertices);
    if (found != deformers().end())
        return found->second;
    const Panel& panel = panel_of(vertices);
    return deformers()
        .emplace(vertices, SurfaceDeformer(panel.mesh, panel.constraints))
        .first->second;
}

void forget_deformers()
{
    deformers().clear();
}

RigidMotion drag_motion(const Panel& panel, int step)
{
    const double part = 0.1 * (1 + step % 10);
    RigidMotion motion;
    motion.translation = part * 0.1 * panel.mesh.size() * Vector3(0.0, 0.2, 1.0);
    motion.rotation_log = rotation_log(Vector3(0.0, 1.0, 0.0), part * M_PI / 3.0);
    motion.pivot = panel.mesh.points().row(panel.constraints.handles[0].vertices[0]).transpose();
    return motion;
}

SurfaceTargets drag(const Panel& panel, int step)
{
    SurfaceTargets targets;
    targets.handles.assign(panel.constraints.handles.size(), RigidMotion{});
    targets.handles[0] = drag_motion(panel, step);
    targets.feature_logs.assign(panel.constraints.features.size(), Vector3::Zero());
    return targets;
}

double peak_memory_mib()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void small_panel_sizes(benchmark::internal::Benchmark* family)
{
    family->Arg(1000)->Arg(10000)->Arg(100000);
    family->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
}

void panel_sizes(benchmark::internal::Benchmark* family)
{
    small_panel_sizes(family);
    if (std::getenv("SHEETMORPH_BENCH_LARGE") != nullptr)
        family->Arg(1000000);
}

}  // namespace sheetmorph::benchmarks
