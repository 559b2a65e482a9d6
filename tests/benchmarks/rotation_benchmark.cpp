// SPDX-License-Identifier: LGPL-2.1-or-later
// Sheets that many rotations turn: every vertex driven by a control mesh (mode 1), and a grid of
// rigid patches, one for 90 vertices. Set-up, frame and memory grow with the sheet.
#include "panel_cases.h"

#include "sheetmorph/base/rotation.h"

#include <algorithm>
#include <cmath>

namespace sheetmorph::benchmarks
{

using namespace surface;

namespace
{

int side_of(benchmark::State& state)
{
    return static_cast<int>(std::lround(std::sqrt(static_cast<double>(state.range(0)))));
}

mesh::TriangleMesh square_sheet(int side)
{
    Points points(side * side, 3);
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j)
            points.row(i * side + j) << i, j, 3.0 * std::sin(0.1 * i) * std::cos(0.07 * j);
    Triangles triangles(2 * (side - 1) * (side - 1), 3);
    int row = 0;
    for (int i = 0; i + 1 < side; ++i)
        for (int j = 0; j + 1 < side; ++j)
        {
            const int corner = i * side + j;
            triangles.row(row++) << corner, corner + side, corner + side + 1;
            triangles.row(row++) << corner, corner + side + 1, corner + 1;
        }
    return {points, triangles};
}

// How a bent sheet moves a vertex.
RigidMotion bent(const Vector3& point, int side, double amount)
{
    RigidMotion motion;
    motion.pivot = point;
    const double s = point.x() / side;
    motion.rotation_log = Vector3(0.0, 0.5 * amount * s, 0.05 * amount);
    motion.translation = amount * side * Vector3(0.0, 0.05 * s, 0.2 * s * s);
    return motion;
}

void count(benchmark::State& state, const mesh::TriangleMesh& mesh)
{
    state.counters["vertices"] = mesh.vertex_count();
    state.counters["peak_memory_mib"] = peak_memory_mib();
}

//! A sheet whose every vertex another part drives.
struct DrivenSheet
{
    explicit DrivenSheet(int side) : mesh(square_sheet(side))
    {
        constraints.propagated = {{"all", {}}};
        for (int i = 0; i < mesh.vertex_count(); ++i)
            constraints.propagated[0].vertices.push_back(i);
    }

    SurfaceTargets targets(int side, double amount) const
    {
        SurfaceTargets found;
        found.propagated = {{mesh.points(), mesh.points(), {}}};
        for (int i = 0; i < mesh.vertex_count(); ++i)
        {
            const Vector3 point = mesh.points().row(i).transpose();
            const RigidMotion motion = bent(point, side, amount);
            found.propagated[0].positions.row(i) = motion.apply(point).transpose();
            found.propagated[0].rotation_logs.row(i) = motion.rotation_log.transpose();
        }
        return found;
    }

    mesh::TriangleMesh mesh;
    SurfaceConstraints constraints;
};

//! A sheet with a grid of patches that move as rigid bodies.
struct PatchedSheet
{
    explicit PatchedSheet(int side) : mesh(square_sheet(side))
    {
        const int each = side / std::max(1, static_cast<int>(std::lround(side / 9.5)));
        for (int i = each / 2; i + 1 < side; i += each)
            for (int j = each / 2; j + 1 < side; j += each)
            {
                const int corner = i * side + j;
                constraints.handles.push_back(
                    {"patch" + std::to_string(constraints.handles.size()),
                     {corner, corner + 1, corner + side, corner + side + 1}});
            }
    }

    SurfaceTargets targets(int side, double amount) const
    {
        SurfaceTargets found;
        for (const KnownRegion& patch : constraints.handles)
            found.handles.push_back(
                bent(mesh.points().row(patch.vertices.front()).transpose(), side, amount));
        return found;
    }

    mesh::TriangleMesh mesh;
    SurfaceConstraints constraints;
};

template <typename Sheet>
void set_up_sheet(benchmark::State& state)
{
    const Sheet sheet(side_of(state));
    for (auto pass : state)
    {
        (void)pass;
        const SurfaceDeformer deformer(sheet.mesh, sheet.constraints);
        benchmark::DoNotOptimize(&deformer);
    }
    count(state, sheet.mesh);
}

template <typename Sheet>
void frame_of_sheet(benchmark::State& state)
{
    const int side = side_of(state);
    const Sheet sheet(side);
    const SurfaceDeformer deformer(sheet.mesh, sheet.constraints);
    std::vector<SurfaceTargets> poses;
    for (int step = 1; step <= 5; ++step)
        poses.push_back(sheet.targets(side, 0.1 * step));
    std::size_t step = 0;
    for (auto pass : state)
    {
        (void)pass;
        benchmark::DoNotOptimize(deformer.deform(poses[step++ % poses.size()], Exactness::live));
    }
    count(state, sheet.mesh);
}

void driven_sheet_set_up(benchmark::State& state)
{
    set_up_sheet<DrivenSheet>(state);
}

void driven_sheet_frame(benchmark::State& state)
{
    frame_of_sheet<DrivenSheet>(state);
}

void patched_sheet_set_up(benchmark::State& state)
{
    set_up_sheet<PatchedSheet>(state);
}

void patched_sheet_frame(benchmark::State& state)
{
    frame_of_sheet<PatchedSheet>(state);
}

void sheet_sizes(benchmark::internal::Benchmark* family)
{
    family->Arg(10000)->Arg(28900)->Arg(90000);
    family->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
}

BENCHMARK(driven_sheet_set_up)->Apply(sheet_sizes);
BENCHMARK(driven_sheet_frame)->Apply(sheet_sizes);
BENCHMARK(patched_sheet_set_up)->Apply(sheet_sizes);
BENCHMARK(patched_sheet_frame)->Apply(sheet_sizes);

}  // namespace

}  // namespace sheetmorph::benchmarks
