// SPDX-License-Identifier: LGPL-2.1-or-later
// Twenty panels of 50,000 vertices in a grid of four by five, thirty rigid welds between
// neighbours: twelve of them are driven by two welds, which close loops.
#include "panel_cases.h"

#include "sheetmorph/assembly/session/live_drag.h"
#include "sheetmorph/base/rotation.h"

#include <algorithm>
#include <numeric>

namespace sheetmorph::benchmarks
{

using namespace assembly;

namespace
{

constexpr int across = 5;
constexpr int along = 4;
constexpr int weld_vertices = 48;

// The vertices nearest to a place that no hole has.
VertexIds nearest(const mesh::TriangleMesh& mesh, const std::vector<char>& is_taken,
                  const Vector3& place)
{
    std::vector<std::pair<double, int>> order;
    for (int i = 0; i < mesh.vertex_count(); ++i)
        if (!is_taken[static_cast<std::size_t>(i)])
            order.emplace_back((mesh.points().row(i) - place.transpose()).squaredNorm(), i);
    std::partial_sort(order.begin(), order.begin() + weld_vertices, order.end());
    VertexIds ids;
    for (int k = 0; k < weld_vertices; ++k)
        ids.push_back(order[static_cast<std::size_t>(k)].second);
    std::sort(ids.begin(), ids.end());
    return ids;
}

// Middle of the right (0), upper (1), left (2) or lower (3) edge.
Vector3 edge_middle(const mesh::TriangleMesh& mesh, int edge)
{
    const Eigen::RowVector3d low = mesh.points().colwise().minCoeff();
    const Eigen::RowVector3d high = mesh.points().colwise().maxCoeff();
    Vector3 place = 0.5 * (low + high).transpose();
    const int axis = edge % 2;
    place(axis) = edge < 2 ? high(axis) : low(axis);
    return place;
}

void add_panels(const Panel& panel, Assembly& assembly)
{
    const double step = panel.mesh.size();
    for (int k = 0; k < across * along; ++k)
    {
        const Eigen::RowVector3d shift(step * (k % across), step * (k / across), 0.0);
        const std::string name = "panel" + std::to_string(k);
        assembly.parts.push_back(
            {name,
             mesh::TriangleMesh(panel.mesh.points().rowwise() + shift, panel.mesh.triangles()),
             {},
             Mode::automatic});
        for (const surface::FormFeature& hole : panel.constraints.features)
            assembly.features.push_back(
                {name + " " + hole.name, k, hole.vertices, hole.rotation, {}, {}, false});
    }
}

Assembly grid_of_panels(int vertices, ContactType type)
{
    const Panel& panel = panel_of(vertices);
    std::vector<char> is_taken(static_cast<std::size_t>(panel.mesh.vertex_count()), 0);
    for (const surface::FormFeature& hole : panel.constraints.features)
        for (const int vertex : hole.vertices)
            is_taken[static_cast<std::size_t>(vertex)] = 1;
    VertexIds patches[4];
    for (int edge = 0; edge < 4; ++edge)
        patches[edge] = nearest(panel.mesh, is_taken, edge_middle(panel.mesh, edge));
    Assembly assembly;
    add_panels(panel, assembly);
    const auto join = [&](int a, int b, int edge)
    {
        if (a == 0 && b == across)
            return;  // one of 31, so that there are 30
        const std::string name = "weld" + std::to_string(assembly.contacts.size());
        assembly.contacts.push_back(
            {name, type, {"a", a, patches[edge]}, {"b", b, patches[edge + 2]}});
    };
    for (int k = 0; k < across * along; ++k)
    {
        if (k % across + 1 < across)
            join(k, k + 1, 0);
        if (k / across + 1 < along)
            join(k, k + across, 1);
    }
    assembly.fixed = {{"root", 0, panel.constraints.fixed[0].vertices}};
    assembly.handles = {{"tip", 0, panel.constraints.handles[0].vertices}};
    return assembly;
}

Pose pose_of(const Panel& panel, int step)
{
    Pose pose;
    pose.handles["tip"] = drag_motion(panel, step);
    return pose;
}

int vertices_of(const Assembly& assembly)
{
    return std::accumulate(assembly.parts.begin(), assembly.parts.end(), 0,
                           [](int sum, const Part& part)
                           { return sum + part.mesh.vertex_count(); });
}

void drag_frames(benchmark::State& state, ContactType type)
{
    const auto size = static_cast<int>(state.range(0));
    const DeformationSession session(grid_of_panels(size, type));
    const auto drag = session.begin_drag({"tip"});
    drag->wait();
    drag->frame(pose_of(panel_of(size), 0));
    std::vector<Pose> poses;
    for (int step = 0; step < 10; ++step)
        poses.push_back(pose_of(panel_of(size), step));
    std::size_t step = 0;
    for (auto pass : state)
    {
        (void)pass;
        benchmark::DoNotOptimize(drag->frame(poses[step++ % poses.size()]).get());
    }
    state.counters["vertices"] = vertices_of(session.assembly());
    const std::vector<char> answered = drag->answered();
    state.counters["parts_by_response"] = std::count(answered.begin(), answered.end(), 1);
    state.counters["peak_memory_mib"] = peak_memory_mib();
}

void assembly_frame_rigid_welds(benchmark::State& state)
{
    drag_frames(state, ContactType::rigid);
}

void assembly_frame_control_meshes(benchmark::State& state)
{
    drag_frames(state, ContactType::control_mesh);
}

void assembly_set_up(benchmark::State& state)
{
    const Assembly assembly = grid_of_panels(static_cast<int>(state.range(0)), ContactType::rigid);
    for (auto pass : state)
    {
        (void)pass;
        const DeformationSession session(assembly);
        benchmark::DoNotOptimize(&session);
    }
    state.counters["vertices"] = vertices_of(assembly);
}

void each_panel(benchmark::internal::Benchmark* family)
{
    family->Arg(1000)->Arg(50000);
    family->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
}

BENCHMARK(assembly_set_up)->Apply(each_panel);
BENCHMARK(assembly_frame_rigid_welds)->Apply(each_panel);
BENCHMARK(assembly_frame_control_meshes)->Apply(each_panel);

}  // namespace

}  // namespace sheetmorph::benchmarks
