// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/operators/natural_rows.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/mesh/geometry/fans.h"
#include "sheetmorph/mesh/geometry/operators.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>

namespace sheetmorph::surface
{

namespace
{

// Rows this much smaller than others of the same vertex are rounding. From doubles: about a
// thousand units of the last digit.
constexpr double nothing = 1e-13;

//! A face's area (mm^2) and the gradients of its three hat functions (1/mm).
struct FaceGradients
{
    double area;
    Matrix3 of_hat;  // column k: gradient of the hat function of corner k

    explicit FaceGradients(const mesh::LaidFaces::Corners& corners)
    {
        const Vector3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        area = 0.5 * normal.norm();
        for (int k = 0; k < 3; ++k)
            of_hat.col(k) = normal.cross(corners[at((k + 2) % 3)] - corners[at((k + 1) % 3)])
                            / normal.squaredNorm();
    }
};

class NaturalRows
{
public:
    NaturalRows(const mesh::LaidFaces& faces, const std::vector<char>& is_held)
        : faces_(faces),
          is_held_(is_held),
          vertex_count_(static_cast<int>(is_held.size())),
          fans_(mesh::fans_of(faces, vertex_count_))
    {
        for (const mesh::LaidFaces::Corners& corners : faces.corners)
            gradients_.emplace_back(corners);
        add_hessians();
        add_hinges();
        add_seams();
        add_ball_joints();
    }

    BendingRows finished() const
    {
        BendingRows result;
        const auto count = static_cast<Eigen::Index>(weights_.size());
        result.rows.resize(count, vertex_count_);
        result.rows.setFromTriplets(entries_.begin(), entries_.end());
        result.weights = Eigen::Map<const Eigen::VectorXd>(weights_.data(), count);
        result.row_vertices = row_vertices_;
        return result;
    }

private:
    int add_row(double weight, int vertex)
    {
        weights_.push_back(weight);
        row_vertices_.push_back(vertex);
        return static_cast<int>(weights_.size()) - 1;
    }

    void add_hessians()
    {
        Eigen::VectorXd masses = Eigen::VectorXd::Zero(vertex_count_);
        std::vector<std::vector<int>> corners_at(at(vertex_count_));
        for (int f = 0; f < faces_.count(); ++f)
        {
            const Vector3 shares = mesh::mixed_voronoi_shares(faces_.corners[at(f)]);
            for (int k = 0; k < 3; ++k)
            {
                masses(faces_.triangles(f, k)) += shares(k);
                corners_at[at(faces_.triangles(f, k))].push_back(3 * f + k);
            }
        }
        for (int i = 0; i < vertex_count_; ++i)
            if (fans_.is_interior[at(i)])
                add_hessian(i, masses(i), corners_at[at(i)]);
    }

    // The 9 entries span at most one row per neighbour, and three if the sheet is flat. As many
    // orthogonal rows are equivalent, because a rotation mixes coordinates and not entries.
    void add_hessian(int vertex, double mass, const std::vector<int>& corners)
    {
        VertexIds neighbours;
        for (const int corner : corners)
            for (int k = 0; k < 3; ++k)
                neighbours.push_back(faces_.triangles(corner / 3, k));
        make_set(neighbours);
        using Entries = Eigen::Matrix<double, 9, Eigen::Dynamic>;
        Entries entries = Entries::Zero(9, static_cast<Eigen::Index>(neighbours.size()));
        for (const int corner : corners)
        {
            const FaceGradients& gradients = gradients_[at(corner / 3)];
            for (int k = 0; k < 3; ++k)
            {
                const Matrix3 outer = gradients.area / mass * gradients.of_hat.col(k)
                                      * gradients.of_hat.col(corner % 3).transpose();
                const auto column = std::lower_bound(neighbours.begin(), neighbours.end(),
                                                     faces_.triangles(corner / 3, k));
                entries.col(column - neighbours.begin()) += outer.reshaped();
            }
        }
        Eigen::ColPivHouseholderQR<Entries> split(entries);
        split.setThreshold(nothing);
        for (Eigen::Index entry = 0; entry < split.rank(); ++entry)
        {
            const int row = add_row(mass, vertex);
            for (Eigen::Index k = entry; k < entries.cols(); ++k)
                entries_.emplace_back(row, neighbours[at(split.colsPermutation().indices()(k))],
                                      split.matrixR()(entry, k));
        }
    }

    bool touches_free_boundary(int f) const
    {
        for (int k = 0; k < 3; ++k)
            if (!fans_.is_interior[at(faces_.triangles(f, k))]
                && !is_held_[at(faces_.triangles(f, k))])
                return true;
        return false;
    }

    void add_hinges()
    {
        for (int side = 0; side < 3 * faces_.count(); ++side)
        {
            const int other = faces_.glued[at(side)];
            if (other > side
                && (touches_free_boundary(side / 3) || touches_free_boundary(other / 3)))
                add_hinge(side, other, 1.0);
        }
    }

    void add_seams()
    {
        for (const std::vector<int>& seam : mesh::seams_of(faces_))
            for (std::size_t i = 0; i < seam.size(); ++i)
                for (std::size_t j = 0; j < i; ++j)
                    add_hinge(seam[i], seam[j], 2.0 / static_cast<double>(seam.size()));
    }

    void add_hinge(int side, int other, double share)
    {
        const mesh::LaidFaces::Corners& one = faces_.corners[at(side / 3)];
        const mesh::LaidFaces::Corners& two = faces_.corners[at(other / 3)];
        const bool opposed = faces_.from(side) == faces_.to(other);
        const double c01 = mesh::corner_cotangent(one, side % 3);
        const double c03 = mesh::corner_cotangent(one, (side + 1) % 3);
        const double c02 = mesh::corner_cotangent(two, (other + (opposed ? 1 : 0)) % 3);
        const double c04 = mesh::corner_cotangent(two, (other + (opposed ? 0 : 1)) % 3);
        const double weight =
            share * 0.25 * 3.0 / (gradients_[at(side / 3)].area + gradients_[at(other / 3)].area);
        for (const int end : {faces_.from(side), faces_.to(side)})
        {
            const int row = add_row(0.5 * weight, end);
            entries_.emplace_back(row, faces_.from(side), c03 + c04);
            entries_.emplace_back(row, faces_.to(side), c01 + c02);
            entries_.emplace_back(row, faces_.apex(side), -c01 - c03);
            entries_.emplace_back(row, faces_.apex(other), -c02 - c04);
        }
    }

    void add_ball_joints()
    {
        const auto fan_count = fans_.vertex.size();
        std::vector<double> areas(fan_count, 0.0);
        std::vector<std::vector<int>> corners_at(at(vertex_count_));
        for (int corner = 0; corner < 3 * faces_.count(); ++corner)
            if (fans_.around[at(faces_.from(corner))] > 1)
            {
                areas[at(fans_.of_corner[at(corner)])] += gradients_[at(corner / 3)].area;
                corners_at[at(faces_.from(corner))].push_back(corner);
            }
        for (std::size_t fan = 0; fan < fan_count; ++fan)
        {
            const int vertex = fans_.vertex[fan];
            const double count = fans_.around[at(vertex)];
            if (count < 2.0)
                continue;
            const int first = add_row(count / (count - 1.0), vertex);
            add_row(count / (count - 1.0), vertex);
            add_row(count / (count - 1.0), vertex);
            for (const int corner : corners_at[at(vertex)])
            {
                const int of_corner = fans_.of_corner[at(corner)];
                const double own = at(of_corner) == fan ? 1.0 : 0.0;
                add_gradient(first, corner / 3, (own - 1.0 / count) / areas[at(of_corner)]);
            }
        }
    }

    // Adds three rows: the gradient of a face times its area and a factor.
    void add_gradient(int first, int f, double factor)
    {
        const FaceGradients& gradients = gradients_[at(f)];
        for (int corner = 0; corner < 3; ++corner)
            for (int a = 0; a < 3; ++a)
                entries_.emplace_back(first + a, faces_.triangles(f, corner),
                                      factor * gradients.area * gradients.of_hat(a, corner));
    }

    const mesh::LaidFaces& faces_;
    const std::vector<char>& is_held_;
    int vertex_count_;
    mesh::Fans fans_;
    std::vector<FaceGradients> gradients_;
    std::vector<Eigen::Triplet<double>> entries_;
    std::vector<double> weights_;
    VertexIds row_vertices_;
};

}  // namespace

BendingRows natural_rows(const mesh::LaidFaces& faces, const std::vector<char>& is_held)
{
    return NaturalRows(faces, is_held).finished();
}

}  // namespace sheetmorph::surface
