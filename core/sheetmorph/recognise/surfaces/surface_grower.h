// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/surfaces/surfaces.h"

#include <optional>

namespace sheetmorph::recognise
{

//! Region growing over the triangles of a part. It fits a surface to a patch around a seed, grows
//! the patch over all near triangles with a similar normal, and repeats. Flat seeds come first,
//! then the seeds with the best curved fit. This order keeps a surface from spanning a bend.
class SurfaceGrower
{
public:
    //! Keeps references to its arguments.
    SurfaceGrower(const FacetGraph& graph, const FeatureTolerances& tolerances);

    std::vector<SurfaceRegion> found();

private:
    struct Seed
    {
        int triangle;
        double misfit;  // of the best curved fit, relative to the radius; < 0: flat
    };

    std::vector<Seed> seeds();
    std::vector<int> patch_around(int seed);
    std::vector<int> patch_around(int seed, double sharpest);
    bool turns(const std::vector<int>& patch) const;
    std::optional<SurfaceRegion> curved_at(int seed);
    std::optional<SurfaceRegion> curved_at(int seed, const std::vector<int>& patch,
                                           fitting::Surface::Kind kind);
    SurfaceRegion plane_at(int seed);
    void better(std::optional<SurfaceRegion> region, std::optional<SurfaceRegion>& best) const;
    double bulge(const SurfaceRegion& region) const;
    std::vector<int> grown(int seed, const fitting::Surface& surface);
    bool is_near(const fitting::Surface& surface, int triangle) const;
    bool is_curved(const fitting::Surface& surface, const std::vector<int>& triangles) const;
    void keep(SurfaceRegion region);
    void give_up(const std::vector<int>& triangles);
    double area_of(const std::vector<int>& triangles) const;
    bool is_open(int triangle) const { return !is_taken_[triangle] && !graph_.is_thin(triangle); }

    const FacetGraph& graph_;
    const FeatureTolerances& tolerances_;
    double size_;
    std::vector<char> is_taken_;
    std::vector<char> is_tried_;  // part of a patch whose seed led to no surface
    std::vector<int> stamp_;      // by triangle: the last search that reached it
    int search_ = 0;
    std::vector<SurfaceRegion> regions_;
};

}  // namespace sheetmorph::recognise
