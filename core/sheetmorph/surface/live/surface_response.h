// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/constrained_minimiser.h"
#include "sheetmorph/numerics/response/response_basis.h"
#include "sheetmorph/surface/live/free_fields.h"
#include "sheetmorph/surface/operators/followers.h"
#include "sheetmorph/surface/rotation/rotation_series.h"
#include "sheetmorph/surface/solve/placement.h"
#include "sheetmorph/surface/surface_deformer.h"

#include <optional>

namespace sheetmorph
{

//! What a deformer has factorised; all of it outlives the response.
struct ResponseInput
{
    const PlacementInput part;
    const SurfaceOperators& operators;
    const RotationField& field;
    const ConstrainedMinimiser& minimiser;
    const Followers& followers;
    const FeatureResponses* free_features;  //!< nothing if the energy turns none
};

//! Which poses a response is for.
struct ResponseOptions
{
    std::vector<int> turning;  //!< one or two handles that turn and move
    std::vector<int> moving;   //!< further handles that only move
    int degree = 8;            //!< of the polynomials of the rotation weights
};

//! How a part answers to one or two turning handles, as fields: a frame is one pass over a small
//! basis, without substitution. Less than 1e-6 of the size from the exact solve, where it covers
//! the pose.
class SurfaceResponse
{
public:
    //! Some substitutions a polynomial. \throws Cancelled between them, as `progress` asks
    SurfaceResponse(const ResponseInput& input, ResponseOptions options,
                    const Progress& progress = {});

    //! A pose in the numbers of the basis. What is rigid is known before any vertex is placed.
    struct Frame
    {
        ResponseBasis::Coefficients coefficients;
        std::vector<Vector3> logs;          // of the turning handles
        BodyMotions bodies;                 // all of them
        std::vector<RigidMotion> handles;   // of the pose
        std::vector<RigidMotion> features;  // about their rest centroids
        std::vector<BodyState> free;        // features that the energy turns
    };

    //! Nothing if another handle, a turned feature or point has a say, or the turn is too far.
    std::optional<Frame> frame(const SurfaceTargets& targets) const;

    //! Fills positions and features; the rotations' logs only if somebody reads them.
    void place(const Frame& frame, bool with_logs, Deformation& result) const;

    double bytes() const { return basis_.bytes(); }  //!< of the fields in memory

    //! Whether no other part's shape drives the part, and no motion or link binds its features.
    static bool is_possible(const ResponseInput& input);

private:
    struct Group
    {
        int handle, body;  // or -1
        VertexIds vertices;
        Points rest;
        Vector3 centre;  // it turns about
    };
    struct Rigid
    {
        Eigen::MatrixXd arms, shifts;  // (n, 3), (n, shifting handles)
    };
    void find_groups();
    Rigid rigid_fields() const;
    void add_clamped(const Eigen::MatrixXd& values, Eigen::MatrixXd& offset) const;
    void respond(const Progress& progress);
    bool covers(const SurfaceTargets& targets) const;
    void take(const ConstrainedMinimiser::Targets&, const Eigen::VectorXd&, ResponseFields&);
    void turn_bodies(Frame& frame) const;
    void shift_bodies(Frame& frame) const;

    ResponseInput input_;
    ResponseOptions options_;
    std::vector<int> shifting_;  // handles with a column for their shift
    std::vector<Group> groups_;  // what is rigid and not fixed
    Eigen::MatrixXd weights_;    // (n, s) of the turning handles
    RotationSeries series_;
    FreeFields free_;
    ResponseBasis basis_;  // free features; q_k D p_hat from first_ on; shifts; points
    Eigen::Index first_ = 0;
};

}  // namespace sheetmorph
