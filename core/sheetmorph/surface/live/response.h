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

//! The data of a part that a live frame reads.
struct ResponseReaders
{
    VertexIds vertices = {};  //!< read by later parts; computed first, in double
    bool all_logs = false;    //!< whether the rotation logs of all vertices are read too
};

//! A reduced model of a part's response to its drivers (handles, welds, contacts, points), trained
//! on sample poses. A frame evaluates a small basis and needs no back-substitution.
//! The shape is linear in the PoseNumbers. Those of all poses of a drag are combinations of the
//! numbers of a few snapshots. The constructor solves the fields of these snapshots. A frame
//! combines them; it is refused if its numbers are not such a combination. Rotating bodies have
//! their own fields: a frame minimises over their motions (mathematics.md, section 4). Sizes are
//! applied last. The difference to the exact solve is below 1e-6 of the size.
class Response
{
public:
    //! \param part     must outlive the response
    //! \param samples  training poses
    //! \throws Cancelled on request of `progress`
    Response(const PreparedSurface& part, const std::vector<SurfaceTargets>& samples,
             ResponseReaders readers, const Progress& progress = {});

    //! Whether a small basis represents the samples; otherwise frame() returns nothing.
    bool is_learnt() const { return is_learnt_; }

    //! A pose in the coordinates of the basis. All rigid motions are determined before any vertex
    //! is placed.
    struct Frame
    {
        numerics::ResponseBasis::Coefficients coefficients;
        PoseNumbers::Turns turns;
        Points logs;                        // of the vertices that later parts read
        BodyMotions bodies;                 // all bodies
        std::vector<BodyState> turned;      // states of the rotating bodies
        std::vector<RigidMotion> handles;   // of the pose
        std::vector<Points> regions;        // of the pose
        SizeChanges sizes;                  // of the pose
        std::vector<RigidMotion> features;  // about their rest centroids

        bool has_sizes() const;
    };

    //! Returns nothing if the pose is not a combination of the snapshots, or if the rotating bodies
    //! do not converge.
    //! \throws InvalidInput if a size cannot be set
    std::optional<Frame> frame(const SurfaceTargets& targets) const;

    //! Fills the rows of positions and logs that later parts read, and the features; without sizes.
    void place_reads(const Frame& frame, Deformation& result) const;

    //! Fills positions, features, and the logs that are read.
    void place(const Frame& frame, Deformation& result) const;

    Eigen::Index fields() const { return basis_.columns(); }
    double bytes() const { return basis_.bytes(); }  //!< of the fields in memory

    //! Whether contacts drive few enough vertices.
    static bool is_possible(const PreparedSurface& part);

private:
    struct Group  // vertices that move with one handle or body
    {
        int handle, body;  // or -1
        VertexIds vertices;
        Points rest;
    };
    struct Known
    {
        int vertex, region, row;
    };
    struct Blend  // a read vertex that a rotating body influences
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
    ResponseReaders readers_;  // with the corners to which followers are attached
    std::vector<Group> groups_;
    std::vector<Known> known_;
    std::vector<int> open_;  // bodies whose translation depends on the sheet
    std::optional<PoseNumbers> numbers_;
    numerics::Weights blend_;  // (k, s) combination of the snapshots from the numbers of a pose
    numerics::Weights told_;   // (s, k) numbers of a pose from a combination
    Eigen::VectorXd left_;     // (n) the field's share of the sheet's rotation
    Eigen::MatrixXd spread_;   // (rotating bodies, m) bound on the field's variation around each
    std::vector<Blend> blends_;
    numerics::Weights slopes_;      // (c, k) slopes of the reduced energy
    numerics::Weights reads_rows_;  // (read values, c + k) rows of the fields, in double
    numerics::ResponseBasis basis_;
    bool is_learnt_ = false;
};

}  // namespace sheetmorph::surface
