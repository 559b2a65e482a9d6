// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/prepared_assembly.h"
#include "sheetmorph/surface/surface_response.h"

namespace sheetmorph
{

//! By part: how it answers to its handles; nothing where it is substituted.
using PartResponses = std::vector<std::shared_ptr<const SurfaceResponse>>;

//! One pose on its way through the propagation order.
class Wave
{
public:
    Wave(const PreparedAssembly& prepared, const Pose& pose, Exactness exactness);

    //! Every part anew.
    Deformed run();

    //! The same into the buffers of an earlier frame. Parts with a response that
    //! covers the pose take it, and have rotation logs only if a later part reads
    //! them. \returns by part, whether its response was taken
    std::vector<char> run_live(const PartResponses& responses, Deformed& result);

private:
    struct Answer
    {
        int part;
        std::shared_ptr<const SurfaceResponse> response;
        SurfaceResponse::Frame frame;
    };

    void start(Deformed& result);
    Deformation& solved(int part) const;
    void set_at_rest(int part) const;
    void expand(int part, const SurfaceTargets& targets) const;
    SurfaceTargets targets_of(int part) const;
    void substitute(int part);
    bool respond(int part, const std::shared_ptr<const SurfaceResponse>& response);
    void pass_on(int part);
    void place_answers() const;
    Points sized_rest(int part) const;
    std::optional<SizedForm> sized_form(int feature) const;
    void report_features(int part);
    void report_feature(int part, std::size_t own, const Points& rest);
    void report_contacts();

    const PreparedAssembly& prepared_;
    const Pose& pose_;
    Exactness exactness_;
    std::vector<LinkedTargets> links_;
    std::vector<RigidMotion> welds_;
    std::vector<RigidMotion> motions_;  // by feature of the assembly
    std::vector<Answer> answers_;       // rigid motions known, vertices still to be placed
    Deformed* result_ = nullptr;
};

}  // namespace sheetmorph
