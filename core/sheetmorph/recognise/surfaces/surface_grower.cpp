// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/surfaces/surface_grower.h"

#include "sheetmorph/base/angles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace sheetmorph::recognise
{

using fitting::Surface;

namespace
{

constexpr int none = -1;
// Triangles of the patch around a seed, of a drawn and of a measured mesh; fewest triangles to
// which a curved surface is fitted. From geometry: in a regular mesh, a triangle and all that touch
// its corners are 13. Measured: with 7, Features.ABendHasItsTurnItsRadiusAndItsThickness finds no
// bend; with 28, Surfaces.AConeIsExactHoweverSlenderAndFine no exact cone. A measured mesh needs
// three times as many, because noise falls with the root of their number. A cone has six unknowns.
constexpr std::size_t patch_size = 14;
constexpr std::size_t measured_patch_size = 40;
constexpr std::size_t fewest_triangles = 6;
constexpr Surface::Kind curved[] = {Surface::Kind::cylinder, Surface::Kind::sphere,
                                    Surface::Kind::cone};

// Mean square difference of normals from which a patch is curved. From the fit of surfaces.
// Measured: twice as much loses the bend of Features.ABendHasItsTurnItsRadiusAndItsThickness.
constexpr double turning = fitting::SpreadLimits{}.turning;

// Share of the scatter that remains in smoothed normals. Chosen: as much as an average over a
// triangle and its three neighbours leaves. More smoothing is correlated and cannot be relied on.
constexpr double left_over = 0.5;

// Limit on the alternation of fitting and growing. Chosen, not measured; the result says whether it
// converged.
constexpr int most_rounds = 8;
const Convergence growth{"the triangles of a surface", false, 0, 0.0, "triangles"};

// Replaces the triangles of a region and records how many triangles changed.
void take(SurfaceRegion& region, std::vector<int> triangles)
{
    const auto sorted = [](std::vector<int> list)
    {
        std::sort(list.begin(), list.end());
        return list;
    };
    std::vector<int> changed;
    const std::vector<int> before = sorted(region.triangles), after = sorted(triangles);
    std::set_symmetric_difference(before.begin(), before.end(), after.begin(), after.end(),
                                  std::back_inserter(changed));
    region.triangles = std::move(triangles);
    region.convergence.miss = static_cast<double>(changed.size());
    region.convergence.is_converged = changed.empty();
}

// A curved region must cover this many of 36 directions around its axis. From geometry: a
// right-angled bend with three rows of facets covers three, 30 degrees between its first and last
// row at least. Measured: with six directions, or 18 in all, the bend of
// Features.ABendHasItsTurnItsRadiusAndItsThickness is lost.
constexpr int directions = 36;
constexpr int fewest_directions = 3;

// Largest distance of measured vertices from a surface, relative to the scatter. From the normal
// distribution: one vertex of 16,000 is farther.
constexpr double within_scatter = 4.0;

// Largest distance from a plane, relative to the size of the part. Chosen: sheets are flat to 1 mm
// per metre (EN 10131 and EN 10029 allow more for rolled sheet).
constexpr double flatness = 1e-3;

// Two fits of similar size: the second replaces the first only if its mean distance at centroids is
// below this share. Chosen: a more general surface always fits a little better.
constexpr double clearly_closer = 0.7;

// A curved region replaces the plane at the same seed only if its area exceeds that of the plane by
// this factor. Chosen: a slightly bent plane also fits a cylinder that is a little larger.
constexpr double clearly_larger = 1.3;

}  // namespace

SurfaceGrower::SurfaceGrower(const FacetGraph& graph, const FeatureTolerances& tolerances)
    : graph_(graph),
      tolerances_(tolerances),
      size_(graph.mesh().size()),
      is_taken_(static_cast<std::size_t>(graph.triangle_count()), 0),
      is_tried_(is_taken_),
      stamp_(is_taken_.size(), none)
{
}

std::vector<SurfaceRegion> SurfaceGrower::found()
{
    const double smallest = tolerances_.smallest_area * graph_.total_area();
    for (const Seed& seed : seeds())
    {
        if (!is_open(seed.triangle) || is_tried_[seed.triangle])
            continue;
        SurfaceRegion plane = plane_at(seed.triangle);
        std::optional<SurfaceRegion> region;
        if (seed.misfit >= 0.0)
            region = curved_at(seed.triangle);
        // Chosen: bends are narrow, so a quarter of the smallest area of a plane is enough.
        if (region && region->area >= clearly_larger * plane.area
            && region->area >= 0.25 * smallest)
            keep(std::move(*region));
        else if (plane.area >= smallest)
            keep(std::move(plane));
        else if (seed.misfit < 0.0)
            give_up(plane.triangles);
        else
            give_up(patch_around(seed.triangle));
    }
    return std::move(regions_);
}

std::vector<SurfaceGrower::Seed> SurfaceGrower::seeds()
{
    std::vector<Seed> seeds;
    for (int t = 0; t < graph_.triangle_count(); ++t)
    {
        if (!is_open(t))
            continue;
        const std::vector<int> patch = patch_around(t);
        Seed seed{t, -1.0};
        if (patch.size() >= fewest_triangles && turns(patch))
        {
            seed.misfit = 1.0;
            const fitting::FacetSample facets = sample_of(graph_, patch);
            for (const Surface::Kind kind : curved)
                if (const auto surface = fitting::fit_surface(facets, kind))
                    seed.misfit =
                        std::min(seed.misfit, fitting::misfit_of(facets.corners, *surface));
        }
        seeds.push_back(seed);
    }
    std::stable_sort(seeds.begin(), seeds.end(),
                     [&](const Seed& a, const Seed& b)
                     {
                         const bool are_flat = a.misfit < 0.0 && b.misfit < 0.0;
                         return are_flat ? graph_.area(a.triangle) > graph_.area(b.triangle)
                                         : a.misfit < b.misfit;
                     });
    return seeds;
}

// Uses the patch within creases if it is curved, else a patch across the sharper edges of a coarse
// mesh.
std::vector<int> SurfaceGrower::patch_around(int seed)
{
    std::vector<int> patch = patch_around(seed, tolerances_.crease_angle);
    if (patch.size() >= fewest_triangles && turns(patch))
        return patch;
    return patch_around(seed, tolerances_.smooth_angle);
}

std::vector<int> SurfaceGrower::patch_around(int seed, double sharpest)
{
    const std::size_t most = graph_.scatter() > 0.0 ? measured_patch_size : patch_size;
    std::vector<int> patch = {seed};
    stamp_[seed] = ++search_;
    for (std::size_t i = 0; i < patch.size() && patch.size() < most; ++i)
        for (int k = 0; k < 3; ++k)
        {
            const int other = graph_.across(patch[i], k);
            if (other == none || is_taken_[other] || stamp_[other] == search_
                || graph_.bend(patch[i], k) > sharpest || graph_.is_thin(other))
                continue;
            stamp_[other] = search_;
            patch.push_back(other);
        }
    return patch;
}

bool SurfaceGrower::turns(const std::vector<int>& patch) const
{
    const Vector3 first = graph_.normal(patch.front());
    Vector3 mean = Vector3::Zero();
    double unsure = 0.0;
    for (const int t : patch)
    {
        const Vector3 normal = graph_.normal(t);
        mean += normal.dot(first) < 0.0 ? Vector3(-normal) : normal;
        unsure += std::pow(left_over * graph_.unsure(t), 2);
    }
    const double count = static_cast<double>(patch.size());
    return 1.0 - (mean / count).squaredNorm() > turning + unsure / count;
}

double SurfaceGrower::area_of(const std::vector<int>& triangles) const
{
    double area = 0.0;
    for (const int t : triangles)
        area += graph_.area(t);
    return area;
}

bool SurfaceGrower::is_near(const Surface& surface, int triangle) const
{
    const bool is_plane = surface.kind == Surface::Kind::plane;
    const Vector3 middle = graph_.centroid(triangle);
    const double reach =
        (is_plane ? flatness * size_ : tolerances_.surface * surface.radius_at(middle))
        + within_scatter * graph_.scatter();
    const double along =
        is_plane ? std::cos(tolerances_.plane_angle + left_over * graph_.unsure(triangle))
                 : along_surface;
    if (std::abs(surface.normal(middle).dot(graph_.normal(triangle))) < along)
        return false;
    for (int k = 0; k < 3; ++k)
        if (surface.distance(graph_.point(graph_.mesh().triangles()(triangle, k))) > reach)
            return false;
    return true;
}

std::vector<int> SurfaceGrower::grown(int seed, const Surface& surface)
{
    std::vector<int> region = {seed};
    stamp_[seed] = ++search_;
    for (std::size_t i = 0; i < region.size(); ++i)
        for (int k = 0; k < 3; ++k)
        {
            const int other = graph_.across(region[i], k);
            if (other == none || is_taken_[other] || stamp_[other] == search_
                || graph_.bend(region[i], k) > tolerances_.smooth_angle)
                continue;
            stamp_[other] = search_;
            if (graph_.is_thin(other) || is_near(surface, other))
                region.push_back(other);
        }
    return region;
}

bool SurfaceGrower::is_curved(const Surface& surface, const std::vector<int>& triangles) const
{
    if (surface.kind == Surface::Kind::sphere)
        return triangles.size() >= 2 * fewest_triangles;
    const Vector3 u = surface.axis.unitOrthogonal();
    const Vector3 v = surface.axis.cross(u);
    std::set<int> seen;
    for (const int t : triangles)
    {
        const Vector3 normal = surface.normal(graph_.centroid(t));
        const double turn = std::atan2(normal.dot(v), normal.dot(u)) / (2.0 * pi) + 0.5;
        seen.insert(static_cast<int>(turn * directions));
    }
    return static_cast<int>(seen.size()) >= fewest_directions;
}

void SurfaceGrower::give_up(const std::vector<int>& triangles)
{
    for (const int t : triangles)
        is_tried_[t] = 1;
}

void SurfaceGrower::keep(SurfaceRegion region)
{
    for (const int t : region.triangles)
        is_taken_[t] = 1;
    std::sort(region.triangles.begin(), region.triangles.end());
    regions_.push_back(std::move(region));
}

std::optional<SurfaceRegion> SurfaceGrower::curved_at(int seed, const std::vector<int>& patch,
                                                      Surface::Kind kind)
{
    std::optional<Surface> surface = fitting::fit_surface(sample_of(graph_, patch), kind);
    SurfaceRegion region{{}, patch, 0.0, growth};
    for (Convergence& of = region.convergence;
         surface && !of.is_converged && of.rounds < most_rounds; ++of.rounds)
    {
        *surface = fitting::refined(some_corners(graph_, region.triangles), *surface);
        if (surface->radius > 2.0 * size_ || !is_near(*surface, seed))
            return std::nullopt;
        take(region, grown(seed, *surface));
        if (region.triangles.size() < fewest_triangles || !is_curved(*surface, region.triangles))
            return std::nullopt;
        surface = fitting::fit_surface(sample_of(graph_, region.triangles), kind);
    }
    if (!surface)
        return std::nullopt;
    region.surface = fitting::refined(some_corners(graph_, region.triangles), *surface);
    if (!is_near(region.surface, seed) || !is_curved(region.surface, region.triangles))
        return std::nullopt;
    region.area = area_of(region.triangles);
    return region;
}

std::optional<SurfaceRegion> SurfaceGrower::curved_at(int seed)
{
    const std::vector<int> patch = patch_around(seed);
    if (patch.size() < fewest_triangles)
        return std::nullopt;
    std::optional<SurfaceRegion> best;
    for (const Surface::Kind kind : curved)
        better(curved_at(seed, patch, kind), best);
    // A small patch does not show the taper of a slender cone.
    if (best && best->surface.kind != Surface::Kind::cone)
        better(curved_at(seed, best->triangles, Surface::Kind::cone), best);
    return best;
}

// Keeps the larger region. If both have a similar size, the later one wins only if it clearly fits
// better inside its triangles; simpler kinds come first.
void SurfaceGrower::better(std::optional<SurfaceRegion> region,
                           std::optional<SurfaceRegion>& best) const
{
    if (!region)
        return;
    const double size = best ? static_cast<double>(region->triangles.size())
                                   / static_cast<double>(best->triangles.size())
                             : 2.0;
    // Chosen: sizes within 5 to 10 % are similar.
    if (size > 1.1 || (size > 0.95 && bulge(*region) < clearly_closer * bulge(*best)))
        best = std::move(region);
}

double SurfaceGrower::bulge(const SurfaceRegion& region) const
{
    double sum = 0.0;
    for (const int t : region.triangles)
        sum += region.surface.distance(graph_.centroid(t));
    return sum / static_cast<double>(region.triangles.size());
}

SurfaceRegion SurfaceGrower::plane_at(int seed)
{
    SurfaceRegion region{{}, {}, 0.0, growth};
    region.surface.axis = graph_.normal(seed);
    region.surface.point = graph_.centroid(seed);
    region.triangles = grown(seed, region.surface);
    for (Convergence& of = region.convergence; !of.is_converged && of.rounds < most_rounds;
         ++of.rounds)
    {
        const auto fitted =
            fitting::fit_surface(sample_of(graph_, region.triangles), Surface::Kind::plane);
        of.is_converged = !fitted || !is_near(*fitted, seed);
        if (of.is_converged)
            break;
        region.surface = *fitted;
        take(region, grown(seed, region.surface));
    }
    region.area = area_of(region.triangles);
    return region;
}

}  // namespace sheetmorph::recognise
