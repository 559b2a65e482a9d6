// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/symmetry/mirror.h"
#include "sheetmorph/mesh/search/picking.h"
#include "sheetmorph/mesh/search/point_grid.h"

#include <map>

namespace sheetmorph::assembly
{

//! Finds mirrored counterparts by position: on the same part, else on another one. Positions may
//! differ by 1e-6 of the assembly's size.
class MirrorFinder
{
public:
    //! \param assembly  with a symmetry; kept by reference
    explicit MirrorFinder(const Assembly& assembly);

    //! The mirrored vertices of a region, ascending.
    //! \returns nothing unless every vertex has a counterpart, all on one part; then `missing` of
    //!     the last call lists those without one on the same part
    std::optional<PartRegion> region(int part, const VertexIds& vertices);
    const VertexIds& missing() const { return missing_; }

    //! The mirrored point on a triangle; nothing if there is no triangle.
    std::optional<PartPoint> point(const PartPoint& given);

    //! The position of a point on a triangle at rest, mm.
    Vector3 position(const PartPoint& point) const;

    bool is_near(const Vector3& a, const Vector3& b) const { return (a - b).norm() <= tolerance_; }

private:
    VertexIds vertices_at(int part, const Vector3& position);
    std::optional<PartPoint> on_part(int part, const Vector3& position);
    std::vector<int> parts_from(int part) const;

    const Assembly& assembly_;
    Mirror mirror_;
    double tolerance_ = 0.0;
    std::map<int, mesh::PointGrid> grids_;
    std::map<int, mesh::PickingTree> trees_;
    VertexIds missing_;
};

}  // namespace sheetmorph::assembly
