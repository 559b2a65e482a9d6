// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/convergence.h"
#include "sheetmorph/mesh/topology/editable_triangles.h"

#include <algorithm>

namespace sheetmorph::repair
{

//! The triangles of a mesh before they are worked on.
struct WorkingInput
{
    const mesh::TriangleMesh& mesh;                  //!< no doubled or repeating triangle
    const std::vector<std::pair<int, int>>& ridges;  //!< (smaller, larger) vertex, sorted
    const std::vector<int>& patch;                   //!< (m)
    const std::vector<double>& sizes;                //!< (n) edge length wanted, mm
    const std::vector<char>& is_flat;                //!< of every patch
    double largest = 0.0;                            //!< edge length wanted far from all ridges, mm
    std::size_t most_triangles = static_cast<std::size_t>(-1);  //!< that splits may make
};

//! A copy of a mesh, turned so that neighbours face the same way, that can be flipped, split and
//! collapsed. Ridges and the vertices on them stay as they are; so do vertices at which triangles
//! meet that do not go round them.
class WorkingMesh : public mesh::EditableTriangles
{
public:
    explicit WorkingMesh(const WorkingInput& input);

    //! Twice the area of a triangle along its normal, or of the one over three places.
    Vector3 area_vector(int t) const;
    static Vector3 area_vector(const Vector3& a, const Vector3& b, const Vector3& c);

    double length(int t, int k) const { return (at(t, k) - at(t, k + 1)).norm(); }
    double wanted_length(int t, int k) const
    {
        return 0.5 * (size[corner(t, k)] + size[corner(t, k + 1)]);
    }

    //! Where a corner of a triangle is.
    const Vector3& at(int t, int k) const { return point[corner(t, k)]; }

    bool is_movable(int v) const { return triangle_at(v) >= 0 && !is_frozen[v]; }

    //! Puts a vertex on the middle of a free side.
    void split(int t, int k);

    //! Makes the shortest edge length wanted anywhere longer, up to the largest of all.
    //! \returns whether anything became longer
    bool raise_least_size(double factor);

    std::size_t most_triangles;
    double least_size = 0.0;  //!< mm, to which it was raised; 0: never

    std::vector<Vector3> point;   //!< (n) mm
    std::vector<int> origin;      //!< (n) vertex of the input, -1 if it is new
    std::vector<char> is_frozen;  //!< (n)
    std::vector<double> size;     //!< (n) edge length wanted, mm
    std::vector<int> patch;       //!< (m)

private:
    void freeze_vertices();

    std::vector<char> is_flat_;
    double largest_;
};

//! Turns the edges that are not ridges until every pair of triangles is Delaunay (the two angles
//! opposite an edge sum up to pi at most), or for so many rounds: a fan of n triangles takes n / 4.
//! Pairs that are bent stay.
Convergence flip_to_delaunay(WorkingMesh& work, int most_rounds);
inline Convergence flip_to_delaunay(WorkingMesh& work)
{
    return flip_to_delaunay(work, std::max(40, work.count()));
}

//! Makes sizes grow slowly along the edges there are now: a few passes each time, sizes only fall.
void even_sizes(WorkingMesh& work);

//! Splits edges longer than 4/3 of what is wanted, turning edges in between, then collapses those
//! shorter than 4/5.
Convergence split_long_edges(WorkingMesh& work, int most_rounds = 40);
Convergence collapse_short_edges(WorkingMesh& work, int most_rounds = 10);

//! Moves every vertex off the ridges to the middle of the triangles around it, inside its surface.
void smooth(WorkingMesh& work);

}  // namespace sheetmorph::repair
