// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/meshing/face_mesh.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>

namespace sheetmorph::cad
{

//! The gap between an edge and a surface below it, by the parameter of the edge.
class EdgeGap
{
public:
    EdgeGap(const Handle(Geom_Curve) & curve, const Handle(Geom_Surface) & surface, double low,
            double high);

    //! Vector from the edge to the surface at the same parameter, mm.
    Vector3 at(const Handle(Geom2d_Curve) & beneath, double t) const;

    //! The length of the largest gap, mm.
    double largest(const Handle(Geom2d_Curve) & beneath) const;

    //! A STEP file stores no tolerances. OpenCASCADE's reader measures the gap at 23 evenly spaced
    //! places and takes the largest one as the tolerance of the edge. If the gap is larger between
    //! these places, its Boolean check reports the edge. A small wave across the edge makes the gap
    //! largest at one of these places.
    //! \param beneath  the edge in the parameters of the surface, a cubic spline
    //! \param largest  largest gap with the wave, mm; larger than before
    //! \returns        `beneath` itself if no such wave exists
    Handle(Geom2d_BSplineCurve)
        with_wave(const Handle(Geom2d_BSplineCurve) & beneath, double largest) const;

private:
    struct Wave;
    Handle(Geom2d_BSplineCurve)
        added(const Handle(Geom2d_BSplineCurve) & beneath, const Wave& wave) const;
    Handle(Geom2d_BSplineCurve)
        fitted(const Handle(Geom2d_BSplineCurve) & beneath, Wave wave, double largest) const;
    Vector2 across(const Vector2& uv, double t) const;

    Handle(Geom_Curve) curve_;
    Handle(Geom_Surface) surface_;
    double low_, high_;
};

}  // namespace sheetmorph::cad
