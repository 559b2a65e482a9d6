// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/topology/boundary.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/mesh/topology/edges.h"

#include <algorithm>
#include <map>

namespace sheetmorph::mesh
{

namespace
{

constexpr int none = -1;

// End 2k of boundary edge k is at its `from`, end 2k + 1 at its `to`. The ends at every vertex are
// joined in pairs. Following these joints from edge to edge gives the loops.
class LoopTracer
{
public:
    explicit LoopTracer(const TriangleMesh& mesh);

    std::vector<VertexIds> loops();

private:
    int vertex_of(int end) const { return end % 2 ? edges_[end / 2].to : edges_[end / 2].from; }
    Vector3 direction(int end) const;
    void join(int a, int b);
    void join_ends_at(int vertex, const std::vector<int>& ends);
    int end_across_fan(int end) const;
    int next_side(int triangle, int vertex, int edge) const;
    void join_straightest(std::vector<int> ends);
    void trace(int end);
    void close_loop(std::size_t from);

    const TriangleMesh& mesh_;
    EdgeTable table_;
    std::vector<BoundaryEdge> edges_;
    std::vector<int> boundary_index_;  // by edge of the table; or none
    std::vector<int> joint_;           // by end: the end it is joined to, or none
    std::vector<char> is_traced_;      // by boundary edge
    std::vector<int> place_in_path_;   // by vertex; or none
    VertexIds path_;
    std::vector<int> agreement_;  // by step from path_[i]: +1 along its triangle, -1 against it
    std::vector<VertexIds> loops_;
};

LoopTracer::LoopTracer(const TriangleMesh& mesh)
    : mesh_(mesh),
      table_(mesh),
      boundary_index_(table_.count(), none),
      place_in_path_(mesh.vertex_count(), none)
{
    for (int edge = 0; edge < table_.count(); ++edge)
        if (table_.uses(edge).count() == 1)
        {
            const EdgeUse& use = *table_.uses(edge).begin();
            boundary_index_[edge] = static_cast<int>(edges_.size());
            edges_.push_back({use.from, use.to, use.triangle});
        }
    joint_.assign(2 * edges_.size(), none);
    is_traced_.assign(edges_.size(), 0);
    std::map<int, std::vector<int>> ends_at;
    for (int end = 0; end < static_cast<int>(joint_.size()); ++end)
        ends_at[vertex_of(end)].push_back(end);
    for (const auto& [vertex, ends] : ends_at)
        join_ends_at(vertex, ends);
}

void LoopTracer::join(int a, int b)
{
    joint_[a] = b;
    joint_[b] = a;
}

// Joins two ends that bound the same fan of triangles around the vertex. If a fan stops at an edge
// of three sheets, it joins the ends that continue straightest.
void LoopTracer::join_ends_at(int vertex, const std::vector<int>& ends)
{
    if (ends.size() == 2)
        return join(ends[0], ends[1]);
    std::vector<int> left_over;
    for (const int end : ends)
    {
        const int across = joint_[end] == none ? end_across_fan(end) : none;
        if (across != none && vertex_of(across) == vertex)
            join(end, across);
    }
    for (const int end : ends)
        if (joint_[end] == none)
            left_over.push_back(end);
    join_straightest(left_over);
}

// The other side of a triangle at a vertex.
int LoopTracer::next_side(int triangle, int vertex, int edge) const
{
    for (int k = 0; k < 3; ++k)
    {
        const bool is_at_vertex = mesh_.triangles()(triangle, k) == vertex
                                  || mesh_.triangles()(triangle, (k + 1) % 3) == vertex;
        if (is_at_vertex && table_.edge_of(triangle, k) != edge)
            return table_.edge_of(triangle, k);
    }
    return none;
}

int LoopTracer::end_across_fan(int end) const
{
    const int vertex = vertex_of(end);
    int triangle = edges_[end / 2].triangle;
    int edge = none;
    for (int k = 0; k < 3; ++k)
        if (boundary_index_[table_.edge_of(triangle, k)] == end / 2)
            edge = table_.edge_of(triangle, k);
    while (true)
    {
        edge = next_side(triangle, vertex, edge);
        const EdgeUses uses = table_.uses(edge);
        if (uses.count() == 1)
            break;
        if (uses.count() > 2)
            return none;
        triangle =
            uses.begin()->triangle == triangle ? uses.begin()[1].triangle : uses.begin()->triangle;
    }
    const int other = boundary_index_[edge];
    return edges_[other].from == vertex ? 2 * other : 2 * other + 1;
}

Vector3 LoopTracer::direction(int end) const
{
    return (mesh_.points().row(vertex_of(end ^ 1)) - mesh_.points().row(vertex_of(end)))
        .normalized()
        .transpose();
}

void LoopTracer::join_straightest(std::vector<int> ends)
{
    while (ends.size() >= 2)
    {
        std::size_t best_a = 0;
        std::size_t best_b = 1;
        for (std::size_t a = 0; a < ends.size(); ++a)
            for (std::size_t b = a + 1; b < ends.size(); ++b)
                if (direction(ends[a]).dot(direction(ends[b]))
                    < direction(ends[best_a]).dot(direction(ends[best_b])))
                {
                    best_a = a;
                    best_b = b;
                }
        join(ends[best_a], ends[best_b]);
        ends.erase(ends.begin() + static_cast<std::ptrdiff_t>(best_b));
        ends.erase(ends.begin() + static_cast<std::ptrdiff_t>(best_a));
    }
}

std::vector<VertexIds> LoopTracer::loops()
{
    for (int end = 0; end < static_cast<int>(joint_.size()); ++end)
        if (joint_[end] == none && !is_traced_[end / 2])
            trace(end);
    for (int edge = 0; edge < static_cast<int>(edges_.size()); ++edge)
        if (!is_traced_[edge])
            trace(2 * edge);
    std::sort(loops_.begin(), loops_.end());
    return loops_;
}

// Follows the joints. Whenever the path meets itself, it cuts off the closed part as a loop.
void LoopTracer::trace(int end)
{
    path_.assign(1, vertex_of(end));
    agreement_.clear();
    place_in_path_[path_.front()] = 0;
    while (end != none && !is_traced_[end / 2])
    {
        is_traced_[end / 2] = 1;
        agreement_.push_back(end % 2 ? -1 : 1);
        const int reached = vertex_of(end ^ 1);
        if (place_in_path_[reached] != none)
            close_loop(static_cast<std::size_t>(place_in_path_[reached]));
        else
        {
            place_in_path_[reached] = static_cast<int>(path_.size());
            path_.push_back(reached);
        }
        end = joint_[end ^ 1];
    }
    for (const int vertex : path_)
        place_in_path_[vertex] = none;
}

void LoopTracer::close_loop(std::size_t from)
{
    VertexIds loop(path_.begin() + static_cast<std::ptrdiff_t>(from), path_.end());
    int agreement = 0;
    for (std::size_t k = from; k < agreement_.size(); ++k)
        agreement += agreement_[k];
    for (std::size_t k = from + 1; k < path_.size(); ++k)
        place_in_path_[path_[k]] = none;
    path_.resize(from + 1);
    agreement_.resize(from);
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    if (agreement < 0 || (agreement == 0 && loop.back() < loop[1]))
        std::reverse(loop.begin() + 1, loop.end());
    loops_.push_back(loop);
}

}  // namespace

std::vector<BoundaryEdge> boundary_edges(const TriangleMesh& mesh)
{
    const EdgeTable table(mesh);
    std::vector<BoundaryEdge> edges;
    for (int edge = 0; edge < table.count(); ++edge)
        if (table.uses(edge).count() == 1)
        {
            const EdgeUse& use = *table.uses(edge).begin();
            edges.push_back({use.from, use.to, use.triangle});
        }
    return edges;
}

std::vector<VertexIds> boundary_loops(const TriangleMesh& mesh)
{
    return LoopTracer(mesh).loops();
}

VertexIds boundary_loop_at(const TriangleMesh& mesh, int vertex)
{
    if (vertex < 0 || vertex >= mesh.vertex_count())
        throw InvalidInput("vertex " + std::to_string(vertex) + " does not exist",
                           "the mesh has " + std::to_string(mesh.vertex_count()) + " vertices");
    VertexIds smallest;
    for (const VertexIds& loop : boundary_loops(mesh))
        if (std::find(loop.begin(), loop.end(), vertex) != loop.end()
            && (smallest.empty() || loop.size() < smallest.size()))
            smallest = loop;
    if (smallest.empty())
        throw InvalidInput("vertex " + std::to_string(vertex) + " is not on a closed rim",
                           "pick one at a hole, or at a border that does "
                           "not end where three sheets meet");
    return smallest;
}

}  // namespace sheetmorph::mesh
