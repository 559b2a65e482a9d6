// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/splines/face_spline.h"

namespace sheetmorph::cad
{

//! Selects spans of a FaceSpline that are too long for its conditions.
class SpanChoice
{
public:
    SpanChoice(const FaceSpline& spline, const std::vector<SurfacePlace>& places,
               const std::vector<SurfaceNormal>& normals, double tolerance);

    bool is_any() const { return is_any_; }

    //! Whether all places and normals are met.
    bool is_met() const { return is_met_; }
    const std::vector<bool>& in_u() const { return chosen_[0]; }
    const std::vector<bool>& in_v() const { return chosen_[1]; }

private:
    void choose_at(const Vector2& uv, double spacing);
    void choose_by_surface(double tolerance);
    double change(const Vector2& uv, int direction) const;
    double length(int direction, int span) const;

    const FaceSpline& spline_;
    std::array<std::vector<bool>, 2> chosen_;
    bool is_any_ = false, is_met_ = true;
};

}  // namespace sheetmorph::cad
