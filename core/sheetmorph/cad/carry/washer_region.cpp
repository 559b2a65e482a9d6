// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/carry/washer_region.h"

#include <TopoDS_Iterator.hxx>
#include <algorithm>

namespace sheetmorph::cad
{

namespace
{

std::pair<int, int> ascending(int a, int b)
{
    return {std::min(a, b), std::max(a, b)};
}

// The vertices in order; empty unless they form a single loop.
VertexIds loop_of(const std::map<int, int>& next)
{
    VertexIds loop;
    for (auto at = next.begin(); at != next.end() && loop.size() < next.size();
         at = next.find(at->second))
    {
        if (!loop.empty() && at->first == loop.front())
            return {};
        loop.push_back(at->first);
    }
    return loop.size() == next.size() ? loop : VertexIds();
}

double area(const Vector2& a, const Vector2& b, const Vector2& c)
{
    return (b(0) - a(0)) * (c(1) - a(1)) - (b(1) - a(1)) * (c(0) - a(0));
}

}  // namespace

FaceTriangles::FaceTriangles(const ShapeMesh& mesh, int face, const std::vector<int>& triangles)
{
    const VerticesOnFace& known = mesh.on_face[static_cast<std::size_t>(face)];
    std::set<int> twice;
    for (std::size_t i = 0; i < known.vertices.size(); ++i)
        if (!parameters_.emplace(known.vertices[i], known.parameters[i]).second)
            twice.insert(known.vertices[i]);
    for (const int vertex : twice)
        parameters_.erase(vertex);
    for (const int t : triangles)
    {
        std::array<int, 3> corners = {mesh.triangles(t, 0), mesh.triangles(t, 1),
                                      mesh.triangles(t, 2)};
        const auto end = parameters_.end();
        const auto a = parameters_.find(corners[0]), b = parameters_.find(corners[1]),
                   c = parameters_.find(corners[2]);
        if (a != end && b != end && c != end && area(a->second, b->second, c->second) < 0.0)
            std::swap(corners[1], corners[2]);
        corners_[t] = corners;
        for (std::size_t k = 0; k < 3; ++k)
            triangle_[{corners[k], corners[(k + 1) % 3]}] = t;
    }
    int wire = 0;
    for (TopoDS_Iterator wires(mesh.faces(face + 1)); wires.More(); wires.Next(), ++wire)
        for (TopoDS_Iterator it(wires.Value()); it.More(); it.Next())
        {
            const int edge = mesh.edges.FindIndex(it.Value()) - 1;
            if (edge < 0)
                continue;
            const VertexIds& along = mesh.on_edge[static_cast<std::size_t>(edge)].vertices;
            for (std::size_t i = 0; i + 1 < along.size(); ++i)
                if (wire_.emplace(ascending(along[i], along[i + 1]), wire).second)
                    ++length_[wire];
            border_.insert(along.begin(), along.end());
        }
}

// The triangles connected to those at `seeds`.
std::set<int> FaceTriangles::connected(const std::set<int>& allowed, const VertexIds& seeds) const
{
    const std::set<int> first(seeds.begin(), seeds.end());
    std::vector<int> next;
    for (const int t : allowed)
        for (const int corner : corners_.at(t))
            if (first.count(corner) > 0)
                next.push_back(t);
    std::set<int> found(next.begin(), next.end());
    while (!next.empty())
    {
        const std::array<int, 3>& corners = corners_.at(next.back());
        next.pop_back();
        for (std::size_t k = 0; k < 3; ++k)
            if (const auto other = left_of({corners[(k + 1) % 3], corners[k]}, allowed))
                if (const int t = triangle_.at(*other); found.insert(t).second)
                    next.push_back(t);
    }
    return found;
}

// The side, if one of some triangles lies to its left.
std::optional<FaceTriangles::Side> FaceTriangles::left_of(const Side& side,
                                                          const std::set<int>& triangles) const
{
    const auto found = triangle_.find(side);
    if (found == triangle_.end() || triangles.count(found->second) == 0)
        return {};
    return side;
}

// Finds wires and outline of a region. Returns the vertices where it touches itself, touches a
// border that is not its own, or runs along only a part of a wire.
std::set<int> FaceTriangles::faults(WasherRegion& region) const
{
    std::set<int> bad;
    std::map<int, std::vector<Side>> along;  // by wire
    std::map<int, int> next;
    for (const int t : region.triangles)
        for (std::size_t k = 0; k < 3; ++k)
        {
            const auto& corners = corners_.at(t);
            const int a = corners[k], b = corners[(k + 1) % 3];
            if (left_of({b, a}, region.triangles))
                continue;
            if (const auto wire = wire_.find(ascending(a, b)); wire != wire_.end())
                along[wire->second].push_back({a, b});
            else if (triangle_.count({b, a}) == 0 || border_.count(a) > 0
                     || !next.emplace(a, b).second)
                bad.insert({a, b});
        }
    region.wires.clear();
    for (const auto& [wire, sides] : along)
        if (static_cast<int>(sides.size()) == length_.at(wire))
            region.wires.insert(wire);
        else
            for (const auto& [a, b] : sides)
                bad.insert({a, b});
    region.outline = bad.empty() ? loop_of(next) : VertexIds();
    return bad;
}

std::optional<WasherRegion> FaceTriangles::around(const VertexIds& seeds,
                                                  const std::set<int>& moved) const
{
    std::set<int> allowed;
    for (const auto& [t, corners] : corners_)
        if (std::all_of(corners.begin(), corners.end(),
                        [&](int v) { return moved.count(v) > 0 && parameters_.count(v) > 0; }))
            allowed.insert(t);
    WasherRegion found;
    for (;;)
    {
        found.triangles = connected(allowed, seeds);
        if (found.triangles.empty())
            return {};
        const std::set<int> bad = faults(found);
        if (bad.empty())
            break;
        for (const int t : found.triangles)
            for (const int corner : corners_.at(t))
                if (bad.count(corner) > 0)
                    allowed.erase(t);
    }
    if (found.wires.empty() || found.outline.size() < 3)
        return {};
    return found;
}

bool FaceTriangles::take(const std::set<int>& triangles)
{
    std::set<int> rest;
    for (const auto& [t, corners] : corners_)
        if (triangles.count(t) == 0)
            rest.insert(rest.end(), t);
    if (rest.empty())
        return false;
    const auto& one = corners_.at(*rest.begin());
    if (connected(rest, {one.begin(), one.end()}).size() != rest.size())
        return false;
    for (const int t : triangles)
    {
        for (std::size_t k = 0; k < 3; ++k)
            triangle_.erase({corners_.at(t)[k], corners_.at(t)[(k + 1) % 3]});
        corners_.erase(t);
    }
    return true;
}

}  // namespace sheetmorph::cad
