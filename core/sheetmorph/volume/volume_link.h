// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/rigid_motion.h"
#include "sheetmorph/numerics/products/panel_rows.h"
#include "sheetmorph/volume/control_mesh.h"
#include "sheetmorph/volume/control_mesh_fit.h"
#include "sheetmorph/volume/mean_value_coordinates.h"

#include <memory>
#include <mutex>
#include <vector>

namespace sheetmorph::volume
{

//! The points that drive a control mesh, at rest.
struct LinkSource
{
    Points points;          //!< (n, 3) mm
    Points normals;         //!< (n, 3) unit; only needed with offset samples
    Eigen::VectorXd areas;  //!< n, >= 0, any unit; empty for equal ones
};

struct LinkOptions
{
    double smoothness = 0.05;  //!< c of (3.3)
    double offset = 0.0;       //!< h, mm: samples at +-h along the normals too; 0 for none
    bool rotations = true;     //!< whether targets also rotate; four times the memory
    double most_kept = 4.0 * 1024 * 1024 * 1024;  //!< bytes of the targets' weights in double
};

//! The points of the source in one frame.
struct SourceState
{
    Points positions;                //!< (n, 3) mm
    std::vector<Matrix3> rotations;  //!< n local rotations; only needed with offset samples
    RigidMotion mean;                //!< of mean_motion()

    //! (n, 3) logs of the local rotations. The log of a target is the one nearest to that of its
    //! nearest source point, not to the mean. If a source is twisted by a whole turn, its ends are
    //! half a turn from the mean, and the target would jump. Empty: nearest to the mean.
    Points logs;
};

//! Motion of the targets.
struct LinkedTargets
{
    Points positions;  //!< (k, 3) mm
    Points logs;       //!< (k, 3) near the nearest source point's log; empty without rotations
    std::vector<Matrix3> rotations;  //!< (k) if logs miss a part of them near a whole turn
                                     //!< (tilt_beyond()); empty: the rotations are those of the
                                     //!< logs

    Matrix3 rotation(Eigen::Index row) const;
};

//! Source points drive a control mesh (3.3), and the control mesh drives target points (2.11).
//! Targets move by the mean motion of the source plus a displacement. So a source at rest leaves
//! them in place bit for bit, and a rigid motion of the source moves them rigidly, to rounding.
//! The rows of the targets apply to the inputs: n source points, twice as many with offset samples.
//! If it takes less memory, they apply to combinations of the inputs: s combinations if the rows
//! have the numerical rank s, or the m control vertices if there are too many targets to compute a
//! rank.
//! Memory: about (k + inputs) * min(s, m) or k * inputs entries of six bytes, where k is four times
//! the number of targets with rotations. Above `most_kept`, the link stores no rows, and every
//! transfer() computes the weights again, 256 targets at a time. Only such a link stores its fit.
//! Otherwise the first control_vertices() computes it again.
class VolumeLink
{
public:
    //! \throws InvalidInput if the source is empty, its arrays disagree, or an option is negative
    VolumeLink(const ControlMesh& control, const LinkSource& source, const Points& targets,
               const LinkOptions& options = {});

    //! \throws InvalidInput if the state has another number of points
    LinkedTargets transfer(const SourceState& state, Exactness exactness = Exactness::exact) const;

    //! (m, 3) mm: the deformed control mesh, for display.
    Points control_vertices(const SourceState& state) const;

private:
    //! The map from the inputs to the control mesh.
    struct Fit
    {
        numerics::DenseCholesky factor;
        numerics::Weights from_inputs;  //!< (m, inputs): L^-1 times right-hand sides

        Points displacements(const Points& inputs) const;
    };
    struct LaterFit  // shared by copies of a link
    {
        std::once_flag is_there;
        std::unique_ptr<const Fit> fit;
    };
    VolumeLink(const ControlMesh& control, const LinkSource& source, const LinkOptions& options);
    Eigen::Index input_count() const;
    Points inputs(const SourceState& state) const;
    std::unique_ptr<const Fit> fit_by(const MeanValueCoordinates& coordinates) const;
    const Fit& fit() const;
    void compose(const MeanValueCoordinates& coordinates, std::unique_ptr<const Fit> fit);
    void keep_rows(const MeanValueCoordinates& coordinates, const Fit& fit);
    void keep_low_rank(const MeanValueCoordinates& coordinates, const Fit& fit);
    numerics::Weights target_rows(const MeanValueCoordinates& coordinates,
                                  Eigen::Index first) const;
    Eigen::Index row_count() const;
    Points displacements(const Points& inputs, Exactness exactness) const;

    LinkOptions options_;
    ControlMesh control_;
    Points source_, source_offsets_, targets_;
    Eigen::VectorXd areas_;  // of the source
    Matrix3 steps_;          // columns: steps of the finite differences at the targets, mm
    std::shared_ptr<LaterFit> later_fit_;
    std::vector<Eigen::Index> nearest_;  // source point of every target, with rotations
    numerics::CompactPanelRows rows_;    // of the targets, on the inputs or on combined_
    numerics::ExactPanelRows combined_;  // (s or m, inputs); empty: rows_ are on the inputs
    std::shared_ptr<const MeanValueCoordinates> coordinates_;  // if rows are not stored
};

}  // namespace sheetmorph::volume
