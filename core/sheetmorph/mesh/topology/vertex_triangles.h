// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

namespace sheetmorph::mesh
{

//! The triangles at every vertex of a mesh.
class VertexTriangles
{
public:
    explicit VertexTriangles(const TriangleMesh& mesh);

    //! A sequence of triangles, ascending.
    struct Range
    {
        const int* first;
        const int* last;

        const int* begin() const { return first; }
        const int* end() const { return last; }
        bool is_empty() const { return first == last; }
    };

    //! A triangle that repeats the vertex is listed as often.
    Range at(int vertex) const
    {
        return {triangles_.data() + starts_[vertex], triangles_.data() + starts_[vertex + 1]};
    }

    //! The triangles that contain at least one of the vertices, ascending without repetitions.
    std::vector<int> around(const VertexIds& vertices) const;

private:
    std::vector<int> starts_;  // by vertex: its first entry in triangles_, and the end
    std::vector<int> triangles_;
};

}  // namespace sheetmorph::mesh
