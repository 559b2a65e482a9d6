// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/mesh/topology/editable_triangles.h"

#include <algorithm>

namespace sheetmorph::repair
{

//! The input of a WorkingMesh.
struct WorkingInput
{
    const mesh::TriangleMesh& mesh;  //!< without duplicate triangles or repeated corners
    const std::vector<std::pair<int, int>>& ridges;  //!< (smaller, larger) vertex, sorted
    const std::vector<int>& patch;                   //!< (m)
    const std::vector<double>& sizes;                //!< (n) target edge length, mm
    const std::vector<char>& is_flat;                //!< by patch
    double largest = 0.0;                            //!< target edge length far from all ridges, mm
    std::size_t most_triangles = static_cast<std::size_t>(-1);  //!< upper limit for splits
};

//! A consistently oriented copy of a mesh whose edges can be flipped, split and collapsed. Ridges,
//! vertices on ridges and non-manifold vertices stay unchanged.
class WorkingMesh : public mesh::EditableTriangles
{
public:
    explicit WorkingMesh(const WorkingInput& input);

    //! Twice the area of a triangle along its normal, mm^2; of the triangle t or of three points.
    Vector3 area_vector(int t) const;
    static Vector3 area_vector(const Vector3& a, const Vector3& b, const Vector3& c);

    double length(int t, int k) const { return (at(t, k) - at(t, k + 1)).norm(); }
    double wanted_length(int t, int k) const
    {
        return 0.5 * (size[corner(t, k)] + size[corner(t, k + 1)]);
    }

    //! The position of a corner of a triangle.
    const Vector3& at(int t, int k) const { return point[corner(t, k)]; }

    bool is_movable(int v) const { return triangle_at(v) >= 0 && !is_frozen[v]; }

    //! Inserts a vertex in the middle of a free side.
    void split(int t, int k);

    //! Raises the shortest target edge lengths, up to the largest of all.
    //! \returns whether any target changed
    bool raise_least_size(double factor);

    std::size_t most_triangles;
    double least_size = 0.0;  //!< mm, the raised lower limit; 0 if never raised

    std::vector<Vector3> point;   //!< (n) mm
    std::vector<int> origin;      //!< (n) vertex of the input, -1 if it is new
    std::vector<char> is_frozen;  //!< (n)
    std::vector<double> size;     //!< (n) target edge length, mm
    std::vector<int> patch;       //!< (m)

private:
    void freeze_vertices();

    std::vector<char> is_flat_;
    double largest_;
};

//! Flips edges that are not ridges until every pair of triangles is Delaunay (the two angles
//! opposite an edge add up to at most pi), for at most `most_rounds` rounds. A fan of n triangles
//! takes n / 4 rounds. Bent pairs stay unchanged.
Convergence flip_to_delaunay(WorkingMesh& work, int most_rounds);
inline Convergence flip_to_delaunay(WorkingMesh& work)
{
    return flip_to_delaunay(work, std::max(40, work.count()));
}

//! Limits the growth of sizes along the current edges in a few passes. Sizes only decrease.
void even_sizes(WorkingMesh& work);

//! split_long_edges() splits edges longer than 4/3 of their target and flips edges between rounds.
//! collapse_short_edges() collapses edges shorter than 4/5 of their target.
Convergence split_long_edges(WorkingMesh& work, int most_rounds = 40);
Convergence collapse_short_edges(WorkingMesh& work, int most_rounds = 10);

//! Moves every vertex off the ridges to the weighted centroid of its triangles, within the tangent
//! plane.
void smooth(WorkingMesh& work);

}  // namespace sheetmorph::repair
