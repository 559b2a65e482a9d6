// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace sheetmorph::mesh
{

//! (k, 4) planes (a, b, c, d), one row each: inside is where a x + b y + c z + d >= 0.
using Planes = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>;

//! A place on a mesh.
struct Hit
{
    int triangle = 0;
    Vector3 barycentric = Vector3::Zero();  //!< >= 0, of the triangle's corners; their sum is 1
    double distance = 0.0;                  //!< from the ray's origin or the point, mm
    Vector3 point = Vector3::Zero();        //!< mm
};

//! Answers what a ray hits and what is nearest to a point, on a shape that may be deformed.
class PickingTree
{
public:
    explicit PickingTree(const TriangleMesh& mesh);

    //! Takes new positions for the same triangles.
    //! \param points  (n, 3) mm
    //! \throws InvalidInput if their number differs or one is not finite; nothing is changed then
    void refit(const Points& points);

    //! The first triangle a ray meets, from either side; of several at the same distance the first
    //! in the mesh. A ray through an edge or a vertex never slips through between the triangles
    //! around (Woop, Benthin, Wald 2013). Triangles seen edge-on, and degenerate ones, are not met.
    //! \param direction  of any length but zero
    //! \throws InvalidInput for a direction of length zero or anything not finite
    std::optional<Hit> nearest_hit(const Vector3& origin, const Vector3& direction) const;

    //! The place on the mesh nearest to a point if it is not farther than `reach` (mm), which is
    //! fast where all is far away; degenerate triangles count as the line or point they are.
    //! \throws InvalidInput if the point is not finite
    std::optional<Hit> nearest_point(const Vector3& point,
                                     double reach = std::numeric_limits<double>::infinity()) const;

    //! All triangles that reach to the inside of every plane, and a few near them, in no order.
    std::vector<int> triangles_between(const Planes& planes) const;

    //! The pairs of triangles, the lower first, whose boxes meet and that are wanted, by rising
    //! pair. \param is_wanted  asked once for each pair whose boxes meet, from several threads
    std::vector<std::pair<int, int>> pairs_where(
        const std::function<bool(int one, int other)>& is_wanted) const;

    const Points& points() const { return points_; }
    const Triangles& triangles() const { return triangles_; }

private:
    struct Box
    {
        Vector3 low;
        Vector3 high;

        bool meets(const Box& other) const
        {
            return (low.array() <= other.high.array()).all()
                   && (other.low.array() <= high.array()).all();
        }
    };

    void order_triangles();
    void fit_boxes();
    Box box_of(int triangle) const;
    Box box_of_leaf(int leaf) const;
    int first_of_leaf(int leaf) const;
    template <typename Visit>
    void visit_leaves_meeting(int leaf, const Visit& visit) const;
    Vector3 corner(int triangle, int k) const;
    template <typename Query>
    void visit(Query& query) const;
    void collect(int node, const Planes& planes, std::vector<int>& found) const;

    Points points_;
    Triangles triangles_;
    std::vector<int> order_;  // triangles along a space-filling curve, an equal share to each leaf
    std::vector<Box>
        boxes_;           // a complete binary tree: 1 the root, 2i and 2i + 1 below i, then leaves
    int leaf_count_ = 0;  // a power of two
};

}  // namespace sheetmorph::mesh
