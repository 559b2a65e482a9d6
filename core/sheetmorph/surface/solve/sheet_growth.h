// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/bodies/sizes.h"
#include "sheetmorph/surface/operators/unknowns.h"
#include "sheetmorph/surface/rotation/rotation_field.h"
#include "sheetmorph/surface/solve/deformation.h"

#include <optional>

namespace sheetmorph::surface
{

//! How the sheet makes room for the sizes of a pose. At rest, a sized rim moves to its circle
//! (slot, cylinder); borders, other rims and all that is known stay, and between them the sheet
//! follows by harmonic functions. Laid on the deformed sheet this turns with it: p_i + R_i g_i. So
//! a size moves nothing but the sheet around it.
class SheetGrowth
{
public:
    //! \param shapes  of the resizable form features; without any the class holds nothing
    SheetGrowth(const RotationFieldInput& input, const FeatureShapes& shapes);

    //! (n, 3) mm: what a size adds to the rest shape.
    Points field(const SizeChanges& sizes) const;

    //! Whether the size of a feature moves a vertex that is no feature's.
    bool moves(int vertex) const;

    //! Adds the sizes to a pose solved without them; vertices of no triangle are not placed anew.
    void lay(const SizeChanges& sizes, Deformation& deformation) const;

private:
    void find_unknowns(const std::vector<char>& is_held);
    Points spread(Points moves) const;

    const mesh::TriangleMesh& mesh_;
    const SurfaceConstraints& constraints_;
    const VertexRoles& roles_;
    const FeatureShapes& shapes_;
    std::shared_ptr<const numerics::SparseMatrix> stiffness_;  // (n, n)
    Unknowns unknowns_;
    std::optional<numerics::SparseCholesky> factor_;
};

}  // namespace sheetmorph::surface
