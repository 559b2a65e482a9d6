// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/assembly.h"
#include "sheetmorph/volume/oriented_box.h"

namespace sheetmorph::assembly
{

//! Rows `ids` of points.
Points rows_of(const Points& points, const VertexIds& ids);

//! The rows of both, those of a first.
Points stacked(const Points& a, const Points& b);

//! Builds the boxes of control meshes. Axes that the points leave undetermined come from the part,
//! then from the assembly, then from the positions of parts, handles and fixed regions. So a
//! rotated model gives rotated boxes.
class ControlBoxes
{
public:
    explicit ControlBoxes(const Assembly& assembly);

    //! The box around the whole assembly.
    volume::OrientedBox around_everything() const;

    //! The box around points of a contact whose source is `part`.
    volume::OrientedBox around(const Points& points, int part) const;

private:
    Points everything_;
    Matrix3 axes_;
    std::vector<Matrix3> part_axes_;
    volume::BoxOptions options_;
};

//! Whether each row of `points` lies in the box.
std::vector<char> inside(const volume::OrientedBox& box, const Points& points);

}  // namespace sheetmorph::assembly
