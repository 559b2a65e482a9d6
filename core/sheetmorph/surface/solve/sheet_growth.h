// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/bodies/sizes.h"
#include "sheetmorph/surface/operators/unknowns.h"
#include "sheetmorph/surface/rotation/rotation_field.h"
#include "sheetmorph/surface/solve/deformation.h"

#include <optional>

namespace sheetmorph::surface
{

//! Adapts the sheet to the sizes of a pose. At rest, a rim with a size moves to its circle (slot,
//! cylinder). Borders, other rims and all prescribed vertices stay, and harmonic functions
//! interpolate between them. On the deformed sheet the displacement g rotates with the sheet: p_i +
//! R_i g_i. A size therefore only moves the sheet around it.
class SheetGrowth
{
public:
    //! \param shapes  of the resizable form features; without any, the class has no effect
    SheetGrowth(const RotationFieldInput& input, const FeatureShapes& shapes);

    //! (n, 3) mm: change of the rest shape by sizes.
    Points field(const SizeChanges& sizes) const;

    //! Whether sizes can move a vertex that belongs to no feature.
    bool moves(int vertex) const;

    //! Adds the sizes to a pose solved without them; unused vertices stay unchanged.
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
