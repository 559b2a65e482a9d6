// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/meshing/face_refinement.h"
#include "sheetmorph/cad/meshing/face_refiner.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>
#include <queue>

namespace sheetmorph::cad
{

namespace
{

constexpr auto edges_of_face = "the edges of CAD faces";

// The vertices beside every vertex, each as often as a triangle has both.
class Neighbours
{
public:
    explicit Neighbours(const FaceMesh& mesh) : start_(mesh.vertices().size() + 1, 0)
    {
        for_each_pair(mesh, [&](int a, int) { ++start_[static_cast<std::size_t>(a) + 1]; });
        std::partial_sum(start_.begin(), start_.end(), start_.begin());
        vertices_.resize(static_cast<std::size_t>(start_.back()));
        std::vector<int> filled(start_.begin(), start_.end() - 1);
        for_each_pair(mesh,
                      [&](int a, int b)
                      {
                          int& place = filled[static_cast<std::size_t>(a)];
                          vertices_[static_cast<std::size_t>(place++)] = b;
                      });
    }

    Eigen::Map<const Eigen::VectorXi> of(int v) const
    {
        const int first = start_[static_cast<std::size_t>(v)];
        return {vertices_.data() + first, start_[static_cast<std::size_t>(v) + 1] - first};
    }

private:
    template <typename Work>
    static void for_each_pair(const FaceMesh& mesh, Work&& work)
    {
        for (const FaceMesh::Triangle& triangle : mesh.triangles())
            for (std::size_t k = 0; k < 3 && triangle.is_alive(); ++k)
            {
                work(triangle.corner[k], triangle.corner[(k + 1) % 3]);
                work(triangle.corner[(k + 1) % 3], triangle.corner[k]);
            }
    }

    std::vector<int> start_, vertices_;
};

}  // namespace

FaceRefiner::FaceRefiner(FaceMesh& mesh, const FaceSurface& surface, const FaceSizes& sizes)
    : mesh_(mesh), surface_(surface), sizes_(sizes)
{
    double shortest = sizes.edge;
    for (const FaceVertex& vertex : mesh.vertices())
        shortest = vertex.is_fixed ? std::min(shortest, vertex.size) : shortest;
    shortest_ = std::max(0.05 * shortest, 1e-4 * sizes.edge);
}

// A given number of rounds, as the method has it; the splits and exchanges of the last must end.
Convergence FaceRefiner::run()
{
    flip_all();
    Convergence found = split_all();
    // Chosen, not measured: Botsch and Kobbelt, A Remeshing Approach to Multiresolution Modeling,
    // 2004, take 5 to 10; here the first mesh is already of the right size.
    constexpr int rounds = 4;
    for (int round = 0; round < rounds; ++round)
    {
        collapse_all();
        smooth_all();
        flip_all();
        found = split_all();
    }
    smooth_all();
    found.join(flip_all());
    return found;
}

// By how much a side is too long; above 1 it should be split.
double FaceRefiner::length_excess(const FaceVertex& a, const FaceVertex& b) const
{
    const double length = (b.point - a.point).norm();
    // From Botsch and Kobbelt 2004: halves of a side this long are as near to the size as the side.
    constexpr double tolerated = 4.0 / 3.0;
    const double wanted = std::min(0.5 * (a.size + b.size), sizes_.edge / tolerated);
    return length < shortest_ ? 0.0 : length / (tolerated * wanted);
}

// By how much the surface bends too much along a side; above 1 it should be split.
double FaceRefiner::bend_excess(const FaceVertex& a, const FaceVertex& b) const
{
    if (surface_.is_plane() || (b.point - a.point).norm() < shortest_)
        return 0.0;
    const double gap = gap_at(surface_, 0.5 * (a.uv + b.uv), 0.5 * (a.point + b.point));
    double found = gap / sizes_.deflection;
    if (!a.normal.isZero() && !b.normal.isZero())
    {
        const double turn = std::atan2(a.normal.cross(b.normal).norm(), a.normal.dot(b.normal));
        found = std::max(found, turn / (1.05 * sizes_.angle));
    }
    return found;
}

// Sizes grow from the border inwards, along the sides (Dijkstra).
void FaceRefiner::spread_sizes()
{
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (int v = 0; v < mesh_.vertex_count(); ++v)
        if (mesh_.vertex(v).is_fixed)
            queue.emplace(mesh_.vertex(v).size, v);
        else
            mesh_.vertex(v).size = sizes_.edge;
    const Neighbours near(mesh_);
    while (!queue.empty())
    {
        stop_if(sizes_.stop);
        const auto [size, v] = queue.top();
        queue.pop();
        if (size > mesh_.vertex(v).size)
            continue;
        for (const int w : near.of(v))
        {
            const double length = (mesh_.vertex(w).point - mesh_.vertex(v).point).norm();
            const double grown = size + sizes_.growth * length;
            if (grown >= mesh_.vertex(w).size)
                continue;
            mesh_.vertex(w).size = grown;
            queue.emplace(grown, w);
        }
    }
}

Convergence FaceRefiner::split_all()
{
    // A round halves the sides that are too long. Chosen: 40 halvings divide a side by 1e12.
    constexpr int most_rounds = 40;
    Convergence found{edges_of_face, false, 0, 0.0, "edges"};
    while (found.rounds < most_rounds && !found.is_converged)
    {
        spread_sizes();
        const int split = split_round();
        ++found.rounds;
        found.miss = split;
        found.is_converged = split == 0;
        if (mesh_.vertex_count() >= sizes_.most_vertices)
            break;
    }
    return found;
}

// How many sides were split.
int FaceRefiner::split_round()
{
    std::vector<Side> sides;
    for_each_side(
        [&](int t, int k)
        {
            const double found = excess(corner(t, k), corner(t, k + 1));
            if (found > 1.0)
                sides.push_back({found, t, k, mesh_.corner(t, k), mesh_.corner(t, k + 1)});
        });
    std::stable_sort(sides.begin(), sides.end(),
                     [](const Side& one, const Side& other) { return one.excess > other.excess; });
    int count = 0;
    for (const Side& side : sides)
        count += try_split(side);
    return count;
}

bool FaceRefiner::try_split(const Side& side)
{
    stop_if(sizes_.stop);
    if (mesh_.corner(side.t, side.k) != side.a || mesh_.corner(side.t, side.k + 1) != side.b)
        return false;  // gone since the list was made
    const FaceVertex &a = mesh_.vertex(side.a), &b = mesh_.vertex(side.b);
    const FaceVertex& c = corner(side.t, side.k + 2);
    const FaceVertex& d = mesh_.vertex(mesh_.opposite(side.t, side.k));
    FaceVertex middle = vertex_at(0.5 * (a.uv + b.uv));
    middle.size = 0.5 * (a.size + b.size);
    const double after = std::min(
        {worth(a, middle, c), worth(middle, b, c), worth(b, middle, d), worth(middle, a, d)});
    if (after < 0)
        return false;
    // Beside a long side that stays, shorter and shorter ones would make thinner and thinner
    // triangles.
    constexpr double thin = 0.03;  // from geometry: worth() is the squared sine of 10 degrees
    const double before = std::min(worth(a, b, c), worth(b, a, d));
    if (after < thin && after < 0.9 * before && bend_excess(a, b) <= 1.0)
        return false;
    legalise(mesh_.split(side.t, side.k, middle));
    return true;
}

// Exchanges a side whose two opposite corners sum up to more than pi, and one that is far from
// the surface, as long as no triangle turns over.
bool FaceRefiner::flip_if_better(int t, int k)
{
    stop_if(sizes_.stop);
    if (!mesh_.is_free_side(t, k))
        return false;
    const FaceVertex &a = corner(t, k), &b = corner(t, k + 1), &c = corner(t, k + 2);
    const FaceVertex& d = mesh_.vertex(mesh_.opposite(t, k));
    const Vector3 ca = a.point - c.point, cb = b.point - c.point;
    const Vector3 da = a.point - d.point, db = b.point - d.point;
    const double at_c = std::atan2(ca.cross(cb).norm(), ca.dot(cb));
    const double at_d = std::atan2(da.cross(db).norm(), da.dot(db));
    if (at_c + at_d <= M_PI + 1e-7)
        return false;
    const double after = std::min(worth(c, a, d), worth(d, b, c));
    if (after < 0)
        return false;
    if (!surface_.is_plane() && excess(c, d) > std::max(1.0, excess(a, b)))
        return false;
    mesh_.flip(t, k);
    return true;
}

Convergence FaceRefiner::flip_all()
{
    // Chosen, not measured: a limit for rounding that would flip the same side again and again.
    constexpr int most_rounds = 30;
    Convergence found{edges_of_face, false, 0, 0.0, "edges"};
    for (; found.rounds < most_rounds && !found.is_converged; ++found.rounds)
    {
        int count = 0;
        for_each_side([&](int t, int k) { count += flip_if_better(t, k); });
        found.miss = count;
        found.is_converged = count == 0;
    }
    return found;
}

// Flips outwards from a new vertex (Lawson); what is left beyond `most` flip_all() finds.
void FaceRefiner::legalise(int v)
{
    std::vector<int> open = mesh_.around(v);
    constexpr std::size_t most = 200;  // chosen: a new vertex changes some ten sides
    for (std::size_t done = 0; done < open.size() && done < most; ++done)
    {
        const int t = open[done];
        if (mesh_.corner_of(t, v) < 0)
            continue;
        const int k = (mesh_.corner_of(t, v) + 1) % 3;
        const int other = mesh_.across(t, k);
        if (flip_if_better(t, k))
        {
            open.push_back(t);
            open.push_back(other);
        }
    }
}

Convergence refine_face(FaceMesh& mesh, const FaceSurface& surface, const FaceSizes& sizes)
{
    return FaceRefiner(mesh, surface, sizes).run();
}

}  // namespace sheetmorph::cad
