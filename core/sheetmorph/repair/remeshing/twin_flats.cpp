// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/repair/remeshing/twin_flats.h"

#include "sheetmorph/mesh/geometry/areas.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

namespace sheetmorph::repair
{

namespace
{

constexpr double same_place = 1e-6;  // relative to the size; from files with seven digits

// Relative to the area. From geometry: a circle of 25 chords lacks 1.05 %, so an arc may have one
// more chord than its twin.
constexpr double same_area = 0.01;

// Largest distance between twins, relative to the square root of the area. Chosen: skins are
// thinner than half their width; two flats farther apart are two faces of a block.
constexpr double farthest = 0.5;
// Relative to the edge's length: largest distance of an inserted vertex from it. Chosen: on an arc
// of 20 degrees per chord, the vertex of the twin is 4 % of the chord away (tan(20 / 4) / 2).
constexpr double beside = 0.05;

// The border of a flat, in the direction of its triangles.
struct Outline
{
    Vector3 area = Vector3::Zero();  // along the normal, mm^2
    std::map<int, int> next, before;
    bool is_simple = true;  // whether it passes every vertex once
};

std::map<int, Outline> outlines(const PatchedMesh& given, const std::vector<int>& wanted)
{
    std::map<int, Outline> found;
    for (const int patch : wanted)
        found.emplace(patch, Outline());
    const Triangles& triangles = given.mesh.triangles();
    for (int t = 0; t < given.mesh.triangle_count(); ++t)
    {
        const auto own = found.find(given.patch[static_cast<std::size_t>(t)]);
        if (own == found.end())
            continue;
        Outline& outline = own->second;
        outline.area += 0.5 * mesh::doubled_area(given.mesh, t);
        for (int k = 0; k < 3; ++k)
        {
            const int from = triangles(t, k), to = triangles(t, (k + 1) % 3);
            if (!std::binary_search(given.ridges.begin(), given.ridges.end(),
                                    std::pair<int, int>(std::minmax(from, to))))
                continue;
            outline.is_simple =
                outline.is_simple && !outline.next.count(from) && !outline.before.count(to);
            outline.next[from] = to;
            outline.before[to] = from;
        }
    }
    return found;
}

Vector3 centre(const Points& points, const Outline& outline)
{
    Vector3 sum = Vector3::Zero();
    for (const auto& [vertex, next] : outline.next)
        sum += points.row(vertex).transpose();
    return sum / static_cast<double>(std::max<std::size_t>(1, outline.next.size()));
}

// Vertices sorted along a generic direction, along which few vertices of a model coincide.
class Places
{
public:
    Places(const Points& points, const Outline& outline) : points_(points)
    {
        for (const auto& [vertex, next] : outline.next)
            order_.emplace_back(points.row(vertex).dot(across_), vertex);
        std::sort(order_.begin(), order_.end());
    }

    // The vertex nearest to a point within a distance; -1 if there is none.
    int at(const Vector3& place, double reach) const
    {
        const double key = across_.dot(place.transpose());
        auto next = std::lower_bound(order_.begin(), order_.end(), std::pair(key - reach, -1));
        int found = -1;
        for (double least = reach; next != order_.end() && next->first <= key + reach; ++next)
        {
            const double distance = (points_.row(next->second).transpose() - place).norm();
            if (distance > least)
                continue;
            least = distance;
            found = next->second;
        }
        return found;
    }

private:
    const Points& points_;
    const Eigen::RowVector3d across_{0.5377, 0.6231, 0.5680};
    std::vector<std::pair<double, int>> order_;
};

// Follows two outlines simultaneously, one forwards and the other backwards.
class SideBySide
{
public:
    SideBySide(const Points& points, const Outline& one, const Outline& other)
        : points_(points), one_(one), other_(other)
    {
    }

    //! The offset from one flat to the other; nothing if areas and orientation rule out twins.
    std::optional<Vector3> way() const
    {
        const double area = one_.area.norm();
        if (!one_.is_simple || !other_.is_simple || one_.next.empty() || other_.next.empty()
            || (one_.area + other_.area).norm() > same_area * area)
            return std::nullopt;
        const Vector3 normal = one_.area / area;
        const Vector3 way = normal * normal.dot(centre(points_, other_) - centre(points_, one_));
        if (way.norm() > farthest * std::sqrt(area) || way.dot(normal) >= 0.0)
            return std::nullopt;
        return way;
    }

    //! Pairs all vertices, starting from those that coincide. Returns whether every loop has such a
    //! start and the outlines agree.
    bool pair_up(const std::map<int, int>& same, const Vector3& way)
    {
        // An outline that visits a vertex twice could be followed endlessly.
        if (!one_.is_simple || !other_.is_simple)
            return false;
        way_ = way;
        for (const auto& [a, b] : same)
            twin_of_[b] = a;
        for (const auto& [a, b] : same)
            if (!pairs_.count(a) && !follow(a, b, same))
                return false;
        std::size_t stops_in_one = 0;
        for (const TwinStop& stop : stops_)
            stops_in_one += one_.next.count(stop.from);
        return pairs_.size() + (stops_.size() - stops_in_one) == one_.next.size()
               && pairs_.size() + stops_in_one == other_.next.size();
    }

    const std::map<int, int>& pairs() const { return pairs_; }
    const std::vector<TwinStop>& stops() const { return stops_; }

private:
    bool follow(int start, int twin, const std::map<int, int>& same)
    {
        int a = start, b = twin;
        do
        {
            pairs_[a] = b;
            const int from_a = a, from_b = b;
            VertexIds extra_a, extra_b;
            const auto step = [](const std::map<int, int>& way, int vertex)
            {
                const auto found = way.find(vertex);
                return found == way.end() ? -1 : found->second;
            };
            for (a = step(one_.next, a); a >= 0 && !same.count(a); a = step(one_.next, a))
                extra_a.push_back(a);
            for (b = step(other_.before, b); b >= 0 && !twin_of_.count(b);
                 b = step(other_.before, b))
                extra_b.push_back(b);
            if (a < 0 || b < 0 || same.at(a) != b)
                return false;
            if (extra_a.size() == extra_b.size())
                for (std::size_t k = 0; k < extra_a.size(); ++k)
                    pairs_[extra_a[k]] = extra_b[k];
            else if (!extra_a.empty() && !extra_b.empty())
                return false;
            else if (!stop_at(extra_a, {from_b, b}, way_) || !stop_at(extra_b, {from_a, a}, -way_))
                return false;
        } while (a != start);
        return true;
    }

    // Inserts vertices of one outline into the matching edge of the other.
    bool stop_at(const VertexIds& vertices, const std::pair<int, int>& edge, const Vector3& way)
    {
        const auto [from, to] = std::minmax(edge.first, edge.second);
        const Vector3 start = points_.row(from), along = points_.row(to).transpose() - start;
        for (const int vertex : vertices)
        {
            const Vector3 arm = points_.row(vertex).transpose() + way - start;
            const double share = arm.dot(along) / along.squaredNorm();
            if (!(share > 0.0 && share < 1.0)
                || (arm - share * along).norm() > beside * along.norm())
                return false;
            stops_.push_back({from, to, share, vertex});
        }
        return true;
    }

    const Points& points_;
    const Outline& one_;
    const Outline& other_;
    Vector3 way_ = Vector3::Zero();
    std::map<int, int> twin_of_, pairs_;
    std::vector<TwinStop> stops_;
};

struct Match
{
    TwinFlats twins;
    std::vector<TwinStop> stops;
};

std::optional<Match> matched(const Points& points, const Outline& one, const Outline& other,
                             double tolerance)
{
    SideBySide both(points, one, other);
    const std::optional<Vector3> way = both.way();
    if (!way)
        return std::nullopt;
    const Places places(points, other);
    std::map<int, int> same;
    for (const auto& [vertex, next] : one.next)
        if (const int twin = places.at(points.row(vertex).transpose() + *way, tolerance); twin >= 0)
            same[vertex] = twin;
    if (same.empty() || !both.pair_up(same, *way))
        return std::nullopt;
    return Match{{-1, -1, *way, both.pairs()}, both.stops()};
}

}  // namespace

FoundTwins find_twin_flats(const PatchedMesh& given, const std::vector<char>& is_flat,
                           double least_area)
{
    std::vector<int> flats;
    for (std::size_t patch = 0; patch < is_flat.size(); ++patch)
        if (is_flat[patch])
            flats.push_back(static_cast<int>(patch));
    std::vector<std::pair<int, Outline>> large;
    for (auto& [patch, outline] : outlines(given, flats))
        if (outline.area.norm() > least_area)
            large.emplace_back(patch, outline);
    FoundTwins found;
    const double tolerance = same_place * given.mesh.size();
    for (std::size_t i = 0; i < large.size(); ++i)
    {
        std::vector<Match> matches;
        for (std::size_t j = i + 1; j < large.size(); ++j)
            if (auto match =
                    matched(given.mesh.points(), large[i].second, large[j].second, tolerance))
            {
                match->twins.flat = large[i].first;
                match->twins.twin = large[j].first;
                matches.push_back(std::move(*match));
            }
        const auto nearest =
            std::min_element(matches.begin(), matches.end(),
                             [](const Match& a, const Match& b)
                             { return a.twins.way.squaredNorm() < b.twins.way.squaredNorm(); });
        if (nearest == matches.end())
            continue;
        large.erase(std::find_if(large.begin(), large.end(),
                                 [&](const auto& entry)
                                 { return entry.first == nearest->twins.twin; }));
        found.stops.insert(found.stops.end(), nearest->stops.begin(), nearest->stops.end());
        found.twins.push_back(std::move(nearest->twins));
    }
    return found;
}

std::vector<TwinFlats> twins_after_cuts(const std::vector<TwinFlats>& twins, const PatchedMesh& cut)
{
    std::vector<int> wanted;
    for (const TwinFlats& pair : twins)
        wanted.insert(wanted.end(), {pair.flat, pair.twin});
    const std::map<int, Outline> found = outlines(cut, wanted);
    std::vector<TwinFlats> kept;
    for (const TwinFlats& pair : twins)
    {
        SideBySide both(cut.mesh.points(), found.at(pair.flat), found.at(pair.twin));
        if (both.pair_up(pair.vertex_of, pair.way) && both.stops().empty())
            kept.push_back({pair.flat, pair.twin, pair.way, both.pairs()});
    }
    return kept;
}

std::vector<double> evened(std::vector<double> sizes, const std::vector<TwinFlats>& twins)
{
    const auto at = [&](int vertex) -> double& { return sizes[static_cast<std::size_t>(vertex)]; };
    for (const TwinFlats& pair : twins)
        for (const auto& [vertex, twin] : pair.vertex_of)
            at(vertex) = at(twin) = std::min(at(vertex), at(twin));
    return sizes;
}

}  // namespace sheetmorph::repair
