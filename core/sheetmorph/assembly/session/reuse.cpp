// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/session/reuse.h"

namespace sheetmorph::assembly
{

namespace
{

template <typename Matrix>
bool same(const Matrix& a, const Matrix& b)
{
    return a.rows() == b.rows() && a == b;
}

template <typename Region>
bool same_regions(const std::vector<Region>& a, const std::vector<Region>& b)
{
    const auto equal = [](const Region& x, const Region& y)
    { return x.name == y.name && x.vertices == y.vertices && x.kind == y.kind; };
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), equal);
}

bool same_features(const std::vector<surface::FormFeature>& a,
                   const std::vector<surface::FormFeature>& b)
{
    const auto equal = [](const surface::FormFeature& x, const surface::FormFeature& y)
    {
        return x.rotation == y.rotation && x.motion.type == y.motion.type
               && x.motion.point == y.motion.point && x.motion.direction == y.motion.direction
               && x.is_resizable == y.is_resizable;
    };
    return same_regions(a, b) && std::equal(a.begin(), a.end(), b.begin(), equal);
}

bool same_handles(const std::vector<surface::KnownRegion>& a,
                  const std::vector<surface::KnownRegion>& b)
{
    const auto equal = [](const surface::KnownRegion& x, const surface::KnownRegion& y)
    { return x.is_rotation_free == y.is_rotation_free; };
    return same_regions(a, b) && std::equal(a.begin(), a.end(), b.begin(), equal);
}

bool same_points(const std::vector<surface::PointConstraint>& a,
                 const std::vector<surface::PointConstraint>& b)
{
    const auto equal = [](const surface::PointConstraint& x, const surface::PointConstraint& y)
    {
        return x.name == y.name && x.triangle == y.triangle && x.barycentric == y.barycentric
               && x.is_turned == y.is_turned && x.is_rotation_free == y.is_rotation_free;
    };
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), equal);
}

bool same_links(const std::vector<surface::FeatureLink>& a,
                const std::vector<surface::FeatureLink>& b)
{
    const auto equal = [](const surface::FeatureLink& x, const surface::FeatureLink& y)
    {
        return x.name == y.name && x.type == y.type && x.follower == y.follower
               && x.leader == y.leader && x.centre == y.centre && x.direction == y.direction;
    };
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), equal);
}

bool same_ties(const std::vector<surface::Tie>& a, const std::vector<surface::Tie>& b)
{
    const auto equal = [](const surface::Tie& x, const surface::Tie& y)
    {
        return x.vertex == y.vertex && x.place.corners == y.place.corners
               && x.place.weights == y.place.weights;
    };
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), equal);
}

bool same_constraints(const surface::SurfaceConstraints& a, const surface::SurfaceConstraints& b)
{
    return a.energy == b.energy && a.laplacian == b.laplacian && a.is_refined == b.is_refined
           && a.thickness == b.thickness && a.poisson == b.poisson && same_regions(a.fixed, b.fixed)
           && same_handles(a.handles, b.handles) && same_features(a.features, b.features)
           && same_regions(a.propagated, b.propagated) && same_points(a.points, b.points)
           && a.groups == b.groups && same_links(a.links, b.links)
           && same_regions(a.stitches, b.stitches) && same_ties(a.ties, b.ties);
}

bool same_box(const volume::OrientedBox& a, const volume::OrientedBox& b)
{
    return a.axes == b.axes && a.centre == b.centre && a.half_extents == b.half_extents;
}

}  // namespace

std::shared_ptr<const surface::SurfaceDeformer> earlier_deformer(const PreparedAssembly* previous,
                                                                 const Sheet& sheet)
{
    for (std::size_t k = 0; previous != nullptr && k < previous->deformers.size(); ++k)
        if (previous->system.sheets[k].name == sheet.name)
            return previous->deformers[k];
    return nullptr;
}

bool is_deformer_of(const surface::SurfaceDeformer& deformer, const mesh::TriangleMesh& mesh,
                    const surface::SurfaceConstraints& constraints)
{
    return deformer.rest() == mesh && same_constraints(deformer.constraints(), constraints);
}

std::shared_ptr<const MotionLink> reusable_link(const PreparedAssembly* previous,
                                                const Part& source, const PreparedLink& wanted)
{
    if (previous == nullptr)
        return nullptr;
    for (std::size_t k = 0; k < previous->links.size(); ++k)
    {
        const PreparedLink& old = previous->links[k];
        const Part& old_source =
            previous->assembly
                .parts[static_cast<std::size_t>(previous->system.links[k].source_part)];
        if (old.type == wanted.type && old.source == wanted.source
            && same(old.targets, wanted.targets) && same_box(old.options.box, wanted.options.box)
            && old.options.levels == wanted.options.levels
            && old.options.smoothness == wanted.options.smoothness
            && old_source.mesh == source.mesh)
            return old.link;
    }
    return nullptr;
}

}  // namespace sheetmorph::assembly
