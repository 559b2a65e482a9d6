// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/carry/shape_carrier.h"
#include "sheetmorph/cad/splines/edge_gap.h"
#include "sheetmorph/cad/splines/parameter_curve.h"

#include <BRep_Tool.hxx>
#include <algorithm>

namespace sheetmorph::cad
{

// Recomputes the parameter curves of an edge on fitted faces, and makes its largest gap visible to
// a reader. The seam of a closed face becomes a border of the face.
void ShapeCarrier::lay_on_faces(CarriedEdge& edge)
{
    if (edge.is_degenerated)
        return;
    // From OpenCASCADE, mm: no reader gives an edge a smaller tolerance. A wave is 3 % higher than
    // the gap, chosen as in measure_edge(), and at least two grains of a file (CarryTolerances)
    // high.
    constexpr double exact = 1e-7, more = 1.03;
    constexpr double unseen = 0.9e-7, least = 2e-6;
    double largest = 0.0;
    EdgeOnFace* worst = nullptr;
    for (EdgeOnFace& use : edge.uses)
    {
        const CarriedFace& face = faces_[static_cast<std::size_t>(use.face)];
        if (!face.spline)
            continue;
        if (BRep_Tool::IsClosed(edge.edge, face.face))  // no other face shares the seam
        {
            const auto surface = Handle(Geom_BSplineSurface)::DownCast(face.surface);
            if (const auto seam = border_above(use.curve, surface, edge.low, edge.high);
                !seam.IsNull())
                edge.curve = seam;
            continue;
        }
        use.written =
            curve_beneath(edge.curve, face.surface, use.written, edge.low, edge.high, exact);
        const double gap =
            EdgeGap(edge.curve, face.surface, edge.low, edge.high).largest(use.written);
        if (gap <= largest)
            continue;
        largest = gap;
        worst = &use;
    }
    const auto spline = worst ? Handle(Geom2d_BSplineCurve)::DownCast(worst->written)
                              : Handle(Geom2d_BSplineCurve)();
    if (largest > unseen && !spline.IsNull() && spline->Degree() <= 3)
        worst->written = EdgeGap(edge.curve, faces_[static_cast<std::size_t>(worst->face)].surface,
                                 edge.low, edge.high)
                             .with_wave(spline, std::max(least, more * largest));
}

}  // namespace sheetmorph::cad
