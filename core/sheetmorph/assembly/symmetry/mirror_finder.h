// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/symmetry/mirror.h"
#include "sheetmorph/mesh/search/picking.h"
#include "sheetmorph/mesh/search/point_grid.h"

#include <map>

namespace sheetmorph::assembly
{

//! Finds by position what lies on the other side of a plane of symmetry: on the same part, else on
//! another one. Positions may be off by 1e-6 of the assembly's size.
class MirrorFinder
{
public:
    //! \param assembly  with a symmetry; referred to, not copied
    explicit MirrorFinder(const Assembly& assembly);

    //! The vertices that mirror those of a region, ascending.
    //! \returns nothing unless every vertex has one, all on one part; then `missing` of the last
    //! call names those that have none on the same part
    std::optional<PartRegion> region(int part, const VertexIds& vertices);
    const VertexIds& missing() const { return missing_; }

    //! The place that mirrors a point on a triangle; nothing if no triangle is there.
    std::optional<PartPoint> point(const PartPoint& given);

    //! Where a point on a triangle is at rest, mm.
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
