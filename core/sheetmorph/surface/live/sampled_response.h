// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/surface/live/driver_numbers.h"
#include "sheetmorph/surface/live/sampled_frame.h"
#include "sheetmorph/surface/live/sampled_span.h"

namespace sheetmorph
{

//! How a part answers to whatever drives it - contacts, welds, handles -, learnt from poses: the
//! shape is linear in the DriverNumbers, and those of all poses of a drag are blends of those of a
//! few. Fields are solved for these few; a frame blends them, and is refused where its numbers are
//! not such a blend. Less than 1e-6 of the size from the exact solve.
class SampledResponse
{
public:
    //! \param samples  poses to learn from
    //! \param reads    vertices that later parts read: known before the part is placed, in double
    //! \throws Cancelled as `progress` asks
    SampledResponse(const ResponseInput& input, const std::vector<SurfaceTargets>& samples,
                    const VertexIds& reads, const Progress& progress = {});

    using Frame = SampledFrame;
    //! Nothing if the pose is no blend of those learnt from.
    std::optional<Frame> frame(const SurfaceTargets& targets) const;

    //! Fills the rows of positions and logs that later parts read, and the features.
    void place_reads(const Frame& frame, Deformation& result) const;

    //! Fills positions and features; no logs.
    void place(const Frame& frame, Deformation& result) const;

    Eigen::Index fields() const { return basis_.columns(); }

    //! Whether only handles, welds and other parts' shapes drive the part, contacts of no more
    //! than a thousand vertices together, and no motion or link binds its features.
    static bool is_possible(const ResponseInput& input);

private:
    struct Group
    {
        int handle, body;  // or -1
        VertexIds vertices;
        Points rest;
    };
    struct Known
    {
        int vertex, region, row;
    };
    struct Blend  // a watched vertex that a free feature turns
    {
        Eigen::Index row, turner;
        double weight;
    };
    struct Sample
    {
        const SurfaceTargets* targets;
        Points numbers;  // of the drivers, then of free features
        Points logs;     // of the open bodies, as they start
        BodyMotions bodies;
        std::vector<BodyState> free;
    };
    VertexIds watched(const VertexIds& reads);
    void watch_turners(VertexIds& vertices);
    bool is_far_turned(const Points& logs) const;
    void find_known();
    std::vector<Sample> taken(const std::vector<SurfaceTargets>& samples) const;
    ConstrainedMinimiser::Targets asked(const Sample& sample) const;
    Eigen::MatrixXd solve(const std::vector<Sample>& samples, const SampledSpan& span,
                          const Progress& progress);
    void learn_turns(std::vector<Sample>& samples, const Progress& progress);
    void learn(const std::vector<Sample>& samples, const Progress& progress);
    Points open_logs(const DriverNumbers::Pose& pose) const;
    void shift_bodies(Frame& frame) const;
    void blend_logs(Frame& frame) const;

    ResponseInput input_;
    Eigen::MatrixXd no_weights_;
    FreeFields free_;
    std::vector<Group> groups_;
    std::vector<Known> known_;
    std::vector<Blend> blends_;  // of the watched vertices
    struct Around                // the watched vertices on and around a free feature
    {
        Eigen::Index first, count;
    };
    std::vector<Around> around_;  // by turner
    std::vector<int> open_;       // bodies whose rotation the field decides
    Eigen::Index reads_ = 0;      // how many vertices later parts read
    VertexIds watched_;           // a vertex of each open body, the reads, those around
    DriverNumbers drivers_;
    Weights turning_;     // (c, e) what free_ counts, from the drivers' numbers
    Weights blend_;       // (k, e + t) numbers of the fields from those of drivers and free_
    Weights numbers_;     // (e + t, k) and back
    Weights reads_rows_;  // (open and reads, k) of the fields, in double
    ResponseBasis basis_;
};

}  // namespace sheetmorph
