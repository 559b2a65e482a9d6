// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/thin/thin_part.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/mesh/geometry/areas.h"

#include <Eigen/Dense>
#include <algorithm>

namespace sheetmorph::assembly
{

using mesh::Anchor;

namespace
{

constexpr Eigen::Index least_searches = 50;  // fewest for a thread; chosen, not measured

// A corner with a smaller weight does not count. From rounding: weights in a triangle with a height
// of 1e-5 of its length (thinnest_triangle) are exact to 1e-11; chosen far above.
constexpr double no_weight = 1e-6;

std::vector<int> all_on(const recognise::ThinSolid& solid, recognise::SolidSide side)
{
    std::vector<int> found;
    for (std::size_t t = 0; t < solid.facets.size(); ++t)
        if (solid.facets[t] == side)
            found.push_back(static_cast<int>(t));
    return found;
}

std::vector<Anchor> anchors_at(const std::vector<mesh::Hit>& places, const Triangles& triangles)
{
    std::vector<Anchor> found;
    for (const mesh::Hit& place : places)
        found.push_back(Anchor::at(place, triangles));
    return found;
}

// The inverse, restricted to directions of at least a twentieth of the facets' normals. Chosen:
// every fold and wall has more, and rounding less.
Matrix3 strong_inverse(const Matrix3& moments)
{
    const Eigen::SelfAdjointEigenSolver<Matrix3> solver(moments);
    const Vector3 values = solver.eigenvalues();
    Matrix3 inverse = Matrix3::Zero();
    for (int k = 0; k < 3; ++k)
        if (values(k) > 0.05 * values(2) && values(2) > 0.0)
            inverse +=
                solver.eigenvectors().col(k) * solver.eigenvectors().col(k).transpose() / values(k);
    return inverse;
}

void each_in_parallel(std::size_t count, const std::function<void(int)>& work)
{
    parallel_ranges(static_cast<Eigen::Index>(count), least_searches,
                    [&](Eigen::Index begin, Eigen::Index end)
                    {
                        for (auto k = static_cast<int>(begin); k < end; ++k)
                            work(k);
                    });
}

}  // namespace

ThinPart::ThinPart(mesh::TriangleMesh mesh, recognise::ThinSolid solid)
    : mesh_(std::move(mesh)),
      solid_(std::move(solid)),
      skin_(mesh::submesh(mesh_, all_on(solid_, recognise::SolidSide::main)))
{
    const recognise::AcrossSheet across(mesh_, solid_);
    hang_on_skin(across);
    find_feet(across);
    find_middle();
    for (std::size_t wall = 0; wall < solid_.walls.size(); ++wall)
        for (const recognise::SolidSide side :
             {recognise::SolidSide::main, recognise::SolidSide::opposite})
        {
            rims_.emplace_back();
            wall_of_rim_.push_back(static_cast<int>(wall));
            for (const int vertex : solid_.walls[wall])
                if (solid_.vertices[at(vertex)] == side)
                    rims_.back().push_back(vertex);
        }
}

void ThinPart::hang_on_skin(const recognise::AcrossSheet& across)
{
    anchors_.resize(at(mesh_.vertex_count()));
    const auto hang = [&](int v)
    {
        if (const int own = skin_.index_of[at(v)]; own >= 0)
        {
            anchors_[at(v)] = {Anchor::at_vertex(own)};
            return;
        }
        anchors_[at(v)] =
            anchors_at(across.places(v, recognise::SolidSide::main), mesh_.triangles());
        for (Anchor& anchor : anchors_[at(v)])
            for (int& corner : anchor.corners)
                corner = skin_.index_of[at(corner)];
    };
    each_in_parallel(anchors_.size(), hang);
}

void ThinPart::find_feet(const recognise::AcrossSheet& across)
{
    feet_.resize(skin_.vertices.size());
    const auto find = [&](int s)
    {
        const int v = skin_.vertices[at(s)];
        const std::vector<mesh::Hit> places = across.places(v, recognise::SolidSide::opposite);
        if (!places.empty()
            && places.front().distance <= recognise::farthest_skin * across.thickness(v))
            feet_[at(s)] = anchors_at(places, mesh_.triangles());
    };
    each_in_parallel(feet_.size(), find);
    above_.resize(at(mesh_.vertex_count()));
    for (std::size_t s = 0; s < feet_.size(); ++s)
        for (const Anchor& foot : feet_[s])
            for (std::size_t k = 0; k < 3; ++k)
                if (foot.weights(static_cast<Eigen::Index>(k)) >= no_weight)
                    above_[at(foot.corners[k])].push_back(static_cast<int>(s));
}

// Moves every skin vertex half way to the other skin, so that all facets around it move by the same
// distance. At a fold that is more than half the thickness.
void ThinPart::find_middle()
{
    const mesh::TriangleMesh& skin = skin_.mesh;
    std::vector<Matrix3> moments(skin_.vertices.size(), Matrix3::Zero());
    Points pushed = Points::Zero(skin.vertex_count(), 3);
    for (int t = 0; t < skin.triangle_count(); ++t)
    {
        const Vector3 product = mesh::doubled_area(skin, t);
        const Vector3 normal = product.stableNormalized();
        for (int k = 0; k < 3; ++k)
        {
            const int corner = skin.triangles()(t, k);
            moments[at(corner)] += product.norm() * normal * normal.transpose();
            pushed.row(corner) += product.transpose();
        }
    }
    Points middle = skin.points();
    for (int s = 0; s < skin.vertex_count(); ++s)
    {
        if (feet_[at(s)].empty())
            continue;
        const Vector3 foot = feet_[at(s)].front().on(mesh_.points());
        const Vector3 way = foot - skin.points().row(s).transpose();
        const Vector3 push = strong_inverse(moments[at(s)]) * pushed.row(s).transpose();
        const double sign = push.dot(way) < 0.0 ? -1.0 : 1.0;
        middle.row(s) += (0.5 * sign * way.norm() * push).transpose();
    }
    middle_ = mesh::TriangleMesh(std::move(middle), skin.triangles());
}

SkinRegion ThinPart::on_skin(const VertexIds& region) const
{
    std::vector<char> is_in(at(mesh_.vertex_count()), 0);
    VertexIds candidates;
    for (const int vertex : region)
    {
        is_in[at(vertex)] = 1;
        if (const int own = skin_.index_of[at(vertex)]; own >= 0)
            candidates.push_back(own);
        candidates.insert(candidates.end(), above_[at(vertex)].begin(), above_[at(vertex)].end());
    }
    make_set(candidates);
    SkinRegion found;
    std::vector<char> is_covered(skin_.vertices.size(), 0);
    const auto lies_on = [&](const Anchor& foot)
    {
        bool all = true;
        for (std::size_t k = 0; k < 3; ++k)
            all = all
                  && (is_in[at(foot.corners[k])]
                      || foot.weights(static_cast<Eigen::Index>(k)) < no_weight);
        return all;
    };
    for (const int s : candidates)
    {
        const std::vector<Anchor>& feet = feet_[at(s)];
        const bool is_own = is_in[at(skin_.vertices[at(s)])] != 0;
        is_covered[at(s)] = is_own || std::any_of(feet.begin(), feet.end(), lies_on);
        if (is_covered[at(s)])
            (is_own ? found.own : found.below).push_back(s);
    }
    add_below(region, is_covered, found);
    return found;
}

// A vertex of the region that lies over no skin vertex adds the nearest one.
void ThinPart::add_below(const VertexIds& region, const std::vector<char>& is_covered,
                         SkinRegion& found) const
{
    const auto has_covered = [&](const Anchor& anchor)
    {
        bool any = false;
        for (std::size_t k = 0; k < 3; ++k)
            any = any
                  || (is_covered[at(anchor.corners[k])]
                      && anchor.weights(static_cast<Eigen::Index>(k)) >= no_weight);
        return any;
    };
    for (const int vertex : region)
    {
        const Anchors& anchors = anchors_[at(vertex)];
        if (std::any_of(anchors.begin(), anchors.end(), has_covered))
            continue;
        for (const Anchor& anchor : anchors)
            for (std::size_t k = 0; k < 3; ++k)
                if (anchor.weights(static_cast<Eigen::Index>(k))
                    > anchor.weights.maxCoeff() - no_weight)
                    found.below.push_back(anchor.corners[k]);
    }
    make_set(found.below);
}

VertexIds ThinPart::with_walls(const VertexIds& feature) const
{
    VertexIds whole = feature;
    make_set(whole);
    const VertexIds given = whole;
    for (std::size_t k = 0; k < rims_.size(); ++k)
    {
        if (rims_[k].empty()
            || !std::includes(given.begin(), given.end(), rims_[k].begin(), rims_[k].end()))
            continue;
        const VertexIds& wall = solid_.walls[at(wall_of_rim_[k])];
        whole.insert(whole.end(), wall.begin(), wall.end());
    }
    make_set(whole);
    return whole;
}

}  // namespace sheetmorph::assembly
