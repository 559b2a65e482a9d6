// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/meshing/face_refiner.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <limits>

namespace sheetmorph::cad
{

double FaceRefiner::worth_around(int v, const FaceVertex& moved, int without) const
{
    double least = std::numeric_limits<double>::infinity();
    for (const int t : mesh_.around(v))
    {
        const auto& c = mesh_.triangle(t).corner;
        if (std::find(c.begin(), c.end(), without) != c.end())
            continue;
        const auto with = [&](int k) -> const FaceVertex&
        { return c[static_cast<std::size_t>(k)] == v ? moved : corner(t, k); };
        least = std::min(least, worth(with(0), with(1), with(2)));
    }
    return least;
}

void FaceRefiner::collapse_all()
{
    for (int v = 0; v < mesh_.vertex_count(); ++v)
        if (!mesh_.vertex(v).is_fixed && mesh_.triangle_at(v) >= 0)
            try_collapse(v);
}

// Removes a vertex that is too near to a neighbour, if nothing gets too long, bent or thin by it.
bool FaceRefiner::try_collapse(int v)
{
    stop_if(sizes_.stop);
    // Relative to the wanted size. Chosen below the 4/5 of Botsch and Kobbelt 2004, because
    // vertices on borders stay and growing sizes need shorter sides beside them.
    constexpr double too_near = 0.7;
    const FaceVertex here = mesh_.vertex(v);
    std::vector<std::pair<double, int>> near;
    std::vector<int> ring;
    for (const int t : mesh_.around(v))
        for (const int w : mesh_.triangle(t).corner)
            if (w != v && std::find(ring.begin(), ring.end(), w) == ring.end())
                ring.push_back(w);
    for (const int w : ring)
    {
        const FaceVertex& other = mesh_.vertex(w);
        const double length = (other.point - here.point).norm();
        if (length < too_near * 0.5 * (here.size + other.size))
            near.emplace_back(length, w);
    }
    std::sort(near.begin(), near.end());
    const double before = worth_around(v, here, -1);
    for (const auto& [length, to] : near)
    {
        const double after = worth_around(v, mesh_.vertex(to), to);
        const bool is_sound = after > 0 && after >= std::min(before, 0.15);
        const auto is_short = [&, target = to](int w)
        { return w == target || excess(mesh_.vertex(target), mesh_.vertex(w)) <= 1.0; };
        if (is_sound && std::all_of(ring.begin(), ring.end(), is_short))
        {
            mesh_.collapse(v, to);
            return true;
        }
    }
    return false;
}

void FaceRefiner::smooth_all()
{
    constexpr int sweeps = 3;  // chosen, not measured: later sweeps move vertices little
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (int v = 0; v < mesh_.vertex_count(); ++v, stop_if(sizes_.stop))
            if (!mesh_.vertex(v).is_fixed && mesh_.triangle_at(v) >= 0)
                smooth(v);
}

// Moves a vertex along the surface towards the middle of its neighbours, if that shapes the
// triangles better or leaves them good.
void FaceRefiner::smooth(int v)
{
    const FaceVertex here = mesh_.vertex(v);
    Vector3 sum = Vector3::Zero();
    int count = 0;
    for (const int t : mesh_.around(v))
    {
        sum += corner(t, mesh_.corner_of(t, v) + 1).point;
        ++count;
    }
    const Vector3 step = sum / count - here.point;
    const auto tangents = surface_.tangents(here.uv);
    const Eigen::Matrix2d metric = tangents.transpose() * tangents;
    if (!(metric.determinant() > 1e-12 * metric.squaredNorm()))
        return;
    const Vector2 shift = metric.inverse() * (tangents.transpose() * step);
    const double before = worth_around(v, here, -1);
    for (const double part : {1.0, 0.5, 0.25})
    {
        FaceVertex moved = vertex_at(here.uv + part * shift);
        moved.size = here.size;
        constexpr double good = 0.25;  // from geometry: worth() is the squared sine of 30 degrees
        if (worth_around(v, moved, -1) < std::min(before, good) + 1e-9)
            continue;
        mesh_.vertex(v) = moved;
        return;
    }
}

}  // namespace sheetmorph::cad
