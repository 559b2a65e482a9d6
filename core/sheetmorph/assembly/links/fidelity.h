// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/links/patch_anchors.h"
#include "sheetmorph/assembly/plan/propagation_plan.h"
#include "sheetmorph/surface/surface_deformer.h"

namespace sheetmorph
{

//! How well one contact was kept in a pose.
struct ContactFidelity
{
    int contact = 0;  //!< index into Assembly::contacts
    int source_part = 0;
    int target_part = 0;
    double deviation = 0.0;    //!< mm: farthest a driven vertex is from the source side's own best
                               //!< rigid motion; bending of the region counts
    double gap_change = 0.0;   //!< mm: worst change of the distance of a driven vertex to the
                               //!< nearest point of the source side at rest
    double region_size = 0.0;  //!< mm: diagonal of both sides at rest, to compare with
};

//! Measures one contact; the constructor finds, for every driven vertex, its place on the source.
class ContactGauge
{
public:
    //! \param is_source_wide  what it touches may be triangles that the side has not whole
    ContactGauge(const Assembly& assembly, const DirectedContact& contact,
                 const PartGeometry& source, bool is_source_wide);

    //! \param source  the whole source part in one pose
    //! \param target  (n, 3) positions of the whole target part, mm
    ContactFidelity measure(const Deformation& source, const Points& target) const;

private:
    ContactFidelity blank_;
    VertexIds source_, target_;
    Points source_rest_, target_rest_;  // rows of the two sides
    std::vector<Anchor> anchors_;
    Eigen::VectorXd rest_gaps_;
};

}  // namespace sheetmorph
