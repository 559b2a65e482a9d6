// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/plan/propagation_plan.h"
#include "sheetmorph/surface/solve/deformation.h"

namespace sheetmorph::assembly
{

//! Fidelity of one contact in a pose.
struct ContactFidelity
{
    int contact = 0;  //!< index into Assembly::contacts
    int source_part = 0;
    int target_part = 0;
    //! Largest distance of a driven vertex from the best rigid motion of the source side, mm.
    //! Includes bending.
    double deviation = 0.0;
    double region_size = 0.0;  //!< mm: diagonal of both sides at rest, for comparison
};

//! Measures the fidelity of one contact.
class ContactGauge
{
public:
    ContactGauge(const Assembly& assembly, const DirectedContact& contact);

    //! \param source  the whole source part in one pose
    //! \param target  (n, 3) positions of the whole target part, mm
    ContactFidelity measure(const surface::Deformation& source, const Points& target) const;

private:
    ContactFidelity blank_;
    VertexIds source_, target_;
    Points source_rest_, target_rest_;  // rows of the two sides
};

}  // namespace sheetmorph::assembly
