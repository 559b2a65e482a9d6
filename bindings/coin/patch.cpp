// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patch.h"

#include <Inventor/nodes/SoIndexedFaceSet.h>
#include <Inventor/nodes/SoIndexedLineSet.h>
#include <Inventor/nodes/SoIndexedPointSet.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "node_at.h"

namespace sheetmorph::coin
{

namespace
{

constexpr char chosen = 1;
constexpr char drawn = 2;

// Edges as (smaller vertex, 2 * larger one), the last bit set where a facet is drawn at them.
using HalfEdges = std::vector<std::pair<int, int>>;

void add_edge(HalfEdges& edges, int a, int b, bool is_drawn)
{
    edges.emplace_back(std::min(a, b), 2 * std::max(a, b) + static_cast<int>(is_drawn));
}

// The second numbers of the edges by their first one, each group ascending.
class ByVertex
{
public:
    ByVertex(const HalfEdges& edges, std::size_t count) : starts_(count + 1, 0), ends_(edges.size())
    {
        for (const auto& edge : edges)
            ++starts_[static_cast<std::size_t>(edge.first) + 1];
        std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
        std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
        for (const auto& edge : edges)
            ends_[next[static_cast<std::size_t>(edge.first)]++] = edge.second;
        for (std::size_t v = 0; v < count; ++v)
            std::sort(begin(v), end(v));
    }

    std::vector<int>::iterator begin(std::size_t vertex) { return at(starts_[vertex]); }
    std::vector<int>::iterator end(std::size_t vertex) { return at(starts_[vertex + 1]); }

private:
    std::vector<int>::iterator at(std::size_t place)
    {
        return ends_.begin() + static_cast<std::ptrdiff_t>(place);
    }

    std::vector<std::size_t> starts_;
    std::vector<int> ends_;
};

std::vector<char> flags_of(const Eigen::Ref<const Triangles>& triangles,
                           const Eigen::Ref<const Eigen::VectorXi>& vertices)
{
    int last = -1;
    for (Eigen::Index k = 0; k < vertices.size(); ++k)
        last = std::max(last, vertices[k]);
    if (triangles.size() > 0)
        last = std::max(last, triangles.maxCoeff());
    const bool has_negative = (vertices.size() > 0 && vertices.minCoeff() < 0)
                              || (triangles.size() > 0 && triangles.minCoeff() < 0);
    if (has_negative)
        throw std::invalid_argument("a patch has no vertex of a negative number");
    std::vector<char> flags(static_cast<std::size_t>(last) + 1, 0);
    for (Eigen::Index k = 0; k < vertices.size(); ++k)
        flags[static_cast<std::size_t>(vertices[k])] = chosen;
    return flags;
}

// Draws the facets and lists the edges that may outline them.
HalfEdges take_facets(const Eigen::Ref<const Triangles>& triangles, std::vector<char>& flags,
                      std::vector<std::int32_t>& faces)
{
    const auto flag = [&](int vertex) -> char& { return flags[static_cast<std::size_t>(vertex)]; };
    HalfEdges edges;
    for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    {
        const int* const corners = triangles.data() + 3 * t;
        const auto is_in = [&](int k) { return flag(corners[k % 3]) != 0; };
        const int inside = is_in(0) + is_in(1) + is_in(2);
        if (inside < 2)
            continue;
        for (int k = 0; k < 3; ++k)
            if (is_in(k) && is_in(k + 1))
                add_edge(edges, corners[k], corners[(k + 1) % 3], inside == 3);
        if (inside < 3)
            continue;
        faces.insert(faces.end(), {corners[0], corners[1], corners[2], -1});
        for (int k = 0; k < 3; ++k)
            flag(corners[k]) = drawn;
    }
    return edges;
}

// An edge is drawn where a facet beside it is not, or where there is none beside it.
void take_outline(const HalfEdges& edges, std::vector<char>& flags,
                  std::vector<std::int32_t>& lines)
{
    ByVertex ends(edges, flags.size());
    for (std::size_t v = 0; v < flags.size(); ++v)
        for (auto first = ends.begin(v); first != ends.end(v);)
        {
            const int other = *first / 2;
            const auto next =
                std::find_if(first, ends.end(v), [other](int end) { return end / 2 != other; });
            if (next - first == 1 || *first % 2 == 0)
            {
                lines.insert(lines.end(), {static_cast<std::int32_t>(v), other, -1});
                flags[v] = flags[static_cast<std::size_t>(other)] = drawn;
            }
            first = next;
        }
}

template <typename Field>
void write(Field& field, const std::vector<std::int32_t>& values)
{
    field.setNum(static_cast<int>(values.size()));
    if (!values.empty())
        field.setValues(0, static_cast<int>(values.size()), values.data());
}

}  // namespace

PatchPieces patch_pieces(const Eigen::Ref<const Triangles>& triangles,
                         const Eigen::Ref<const Eigen::VectorXi>& vertices)
{
    PatchPieces pieces;
    std::vector<char> flags = flags_of(triangles, vertices);
    const HalfEdges edges = take_facets(triangles, flags, pieces.faces);
    take_outline(edges, flags, pieces.lines);
    for (std::size_t v = 0; v < flags.size(); ++v)
        if (flags[v] == chosen)
            pieces.points.push_back(static_cast<std::int32_t>(v));
    return pieces;
}

bool show_patch(const PatchAddresses& nodes, const PatchPieces& pieces)
{
    write(node_at<SoIndexedFaceSet>(nodes.faces)->coordIndex, pieces.faces);
    write(node_at<SoIndexedLineSet>(nodes.lines)->coordIndex, pieces.lines);
    write(node_at<SoIndexedPointSet>(nodes.points)->coordIndex, pieces.points);
    return !(pieces.faces.empty() && pieces.lines.empty() && pieces.points.empty());
}

}  // namespace sheetmorph::coin
