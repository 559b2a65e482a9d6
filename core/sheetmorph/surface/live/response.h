// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/response/response_basis.h"
#include "sheetmorph/surface/bodies/joints.h"
#include "sheetmorph/surface/live/pose_numbers.h"
#include "sheetmorph/surface/live/span.h"
#include "sheetmorph/surface/solve/deformation.h"

#include <optional>

namespace sheetmorph::surface
{

//! Who reads a part in a live frame.
struct ResponseReaders
{
    VertexIds vertices = {};  //!< that later parts read: known before the part is placed, in double
    bool all_logs = false;    //!< whether the rotation logs of all vertices are read too
};

//! How a part answers to whatever drives it - handles, welds, contacts, points -, learnt from
//! poses, so that a frame is one pass over a small basis, without substitution. The shape is linear
//! in the PoseNumbers, and those of all poses of a drag are blends of those of a few. Fields are
//! solved for these few; a frame blends them, and is refused where its numbers are not such a
//! blend. Bodies that the energy turns have fields of their own: a frame minimises over their
//! motions (mathematics.md, section 4). Sizes are laid on last. Less than 1e-6 of the size from the
//! exact solve.
class Response
{
public:
    //! \param part     outlives the response
    //! \param samples  poses to learn from
    //! \throws Cancelled as `progress` asks
    Response(const PreparedSurface& part, const std::vector<SurfaceTargets>& samples,
             ResponseReaders readers, const Progress& progress = {});

    //! Whether the samples have enough in common; else it answers no pose.
    bool is_learnt() const { return is_learnt_; }

    //! A pose in the numbers of the basis. What is rigid is known before any vertex is placed.
    struct Frame
    {
        numerics::ResponseBasis::Coefficients coefficients;
        PoseNumbers::Turns turns;
        Points logs;                        // of what later parts read
        BodyMotions bodies;                 // all of them
        std::vector<BodyState> turned;      // those that the energy turns
        std::vector<RigidMotion> handles;   // of the pose
        std::vector<Points> regions;        // likewise
        SizeChanges sizes;                  // likewise
        std::vector<RigidMotion> features;  // about their rest centroids

        bool has_sizes() const;
    };

    //! Nothing if the pose is no blend of those learnt from, or bodies that the energy turns do not
    //! settle.
    //! \throws InvalidInput if a size cannot be set
    std::optional<Frame> frame(const SurfaceTargets& targets) const;

    //! Fills the rows of positions and logs that later parts read, and the features; without sizes.
    void place_reads(const Frame& frame, Deformation& result) const;

    //! Fills positions, features, and the logs that are read.
    void place(const Frame& frame, Deformation& result) const;

    Eigen::Index fields() const { return basis_.columns(); }
    double bytes() const { return basis_.bytes(); }  //!< of the fields in memory

    //! Whether contacts drive few enough vertices, and the bodies that the energy turns are few
    //! enough.
    static bool is_possible(const PreparedSurface& part);

private:
    struct Group  // what moves as it is told, or as one
    {
        int handle, body;  // or -1
        VertexIds vertices;
        Points rest;
    };
    struct Known
    {
        int vertex, region, row;
    };
    struct Blend  // a read vertex that a body turns along
    {
        Eigen::Index row, turner;
        double weight;
    };
    void find_known();
    void find_spread();
    void find_blends();
    void learn(const std::vector<SurfaceTargets>& samples, const Progress& progress);
    void tell_from_few(const Span& span);
    Eigen::MatrixXd solve(const std::vector<KnownPose>& poses, const Span& span,
                          const Progress& progress);
    void keep(const Eigen::MatrixXd& fields, const Eigen::VectorXd& reach,
              const Progress& progress);
    void turn_open(const PoseNumbers::Turns& turns, BodyMotions& bodies) const;
    std::vector<double> farthest(const PoseNumbers::Turns& turns) const;
    std::optional<Points> minimise_turned(const SurfaceTargets& targets, const Points& blend,
                                          Frame& frame) const;
    void shift_bodies(Frame& frame) const;
    void blend_logs(Frame& frame) const;
    void fill_logs(const Frame& frame, Deformation& result) const;
    bool wants_all_logs() const;

    const PreparedSurface& part_;
    ResponseReaders readers_;  // with the corners that followers hang on
    std::vector<Group> groups_;
    std::vector<Known> known_;
    std::vector<int> open_;  // bodies whose translation the sheet decides
    std::optional<PoseNumbers> numbers_;
    numerics::Weights blend_;  // (k, s) numbers of the fields from those of a pose
    numerics::Weights told_;   // (s, k) and back
    Eigen::VectorXd left_;     // (n) what of the sheet's turn is left to the field
    Eigen::MatrixXd spread_;   // (turners, m) how far the field differs around each, at most
    std::vector<Blend> blends_;
    numerics::Weights slopes_;      // (c, k) of the energy of the turned bodies
    numerics::Weights reads_rows_;  // (open and reads, c + k) of the fields, in double
    numerics::ResponseBasis basis_;
    bool is_learnt_ = false;
};

}  // namespace sheetmorph::surface
