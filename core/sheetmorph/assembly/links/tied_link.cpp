// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/links/control_box.h"
#include "sheetmorph/assembly/links/motion_link.h"
#include "sheetmorph/assembly/links/patch_anchors.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/volume/local_rotations.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace sheetmorph::assembly
{

namespace
{

class TiedLink : public MotionLink
{
public:
    explicit TiedLink(const MotionLinkInput& input)
        : anchors_(nearest_anchors(input.source_part, input.source, input.targets)),
          corners_(corners_of(anchors_)),
          meter_(input.source_part, corners_),
          targets_(input.targets),
          arms_(input.targets.rows(), 3),
          rest_corners_(rows_of(input.source_part.mesh().points(), corners_))
    {
        for (Eigen::Index row = 0; row < arms_.rows(); ++row)
            arms_.row(row) = targets_.row(row)
                             - anchors_[static_cast<std::size_t>(row)]
                                   .on(input.source_part.mesh().points())
                                   .transpose();
    }

    volume::LinkedTargets transfer(const surface::Deformation& source, Exactness) const override
    {
        const volume::LocalRotations turned =
            meter_.measure(source.positions, rows_of(source.rotation_logs, corners_));
        volume::LinkedTargets result{Points(arms_.rows(), 3), Points(arms_.rows(), 3), {}};
        for (Eigen::Index row = 0; row < arms_.rows(); ++row)
        {
            const mesh::Anchor& anchor = anchors_[static_cast<std::size_t>(row)];
            const Matrix3 rotation =
                anchor.rotation([&](int corner) -> const Matrix3&
                                { return turned.matrices[corner_index(corner)]; });
            const Vector3 log = anchor.sum(
                [&](int corner) { return Vector3(turned.logs.row(corner_row(corner))); });
            const Vector3 arm = arms_.row(row).transpose();
            // A displacement, so that a source at rest does not move the target.
            const Vector3 shift = displacement(anchor, source) + (rotation * arm - arm);
            result.positions.row(row) = targets_.row(row) + shift.transpose();
            result.logs.row(row) = log_near(rotation, log).transpose();
            result.rotations.push_back(rotation);
        }
        return result;
    }

    VertexIds reads() const override { return meter_.reads(); }

    std::optional<ShownControlMesh> control_mesh(const surface::Deformation&) const override
    {
        return std::nullopt;
    }

private:
    Vector3 displacement(const mesh::Anchor& anchor, const surface::Deformation& source) const
    {
        return anchor.sum(
            [&](int corner) {
                return Vector3(source.positions.row(corner)
                               - rest_corners_.row(corner_row(corner)));
            });
    }

    std::size_t corner_index(int vertex) const
    {
        return static_cast<std::size_t>(std::lower_bound(corners_.begin(), corners_.end(), vertex)
                                        - corners_.begin());
    }

    Eigen::Index corner_row(int vertex) const
    {
        return static_cast<Eigen::Index>(corner_index(vertex));
    }

    static VertexIds corners_of(const std::vector<mesh::Anchor>& anchors)
    {
        VertexIds corners;
        for (const mesh::Anchor& anchor : anchors)
            corners.insert(corners.end(), anchor.corners.begin(), anchor.corners.end());
        make_set(corners);
        return corners;
    }

    std::vector<mesh::Anchor> anchors_;
    VertexIds corners_;
    volume::LocalRotationMeter meter_;
    Points targets_;
    Points arms_;
    Points rest_corners_;  // rows as corners_
};

}  // namespace

std::unique_ptr<MotionLink> tied_link(const MotionLinkInput& input)
{
    return std::make_unique<TiedLink>(input);
}

}  // namespace sheetmorph::assembly
