// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/session/prepared_assembly.h"
#include "sheetmorph/surface/live/response.h"

#include <functional>

namespace sheetmorph::assembly
{

//! How parts answer in live frames, by part; nothing: by substitution.
using PartResponses = std::vector<std::shared_ptr<const surface::Response>>;

//! One pose on its way through the propagation order.
class Wave
{
public:
    //! \param progress  of exact answers that take long
    Wave(const PreparedAssembly& prepared, const Pose& pose, Exactness exactness,
         Progress progress = {});

    //! Every part anew.
    Deformed run();

    //! The same into the buffers of an earlier frame. Parts with a response that
    //! covers the pose take it, and need not have rotation logs.
    //! \param read  by part: buffers for what later parts read of it
    //! \returns by part, whether its response was taken
    std::vector<char> run_live(const PartResponses& responses,
                               std::vector<surface::Deformation>& read, Deformed& result);

    //! For one pose of many, part by part in their order: only what later parts read is known of
    //! a part, in buffers that the poses share.
    void begin_reading(std::vector<surface::Deformation>& read);
    surface::SurfaceTargets targets_of(int part) const;

    //! What links have made of the parts so far.
    const std::vector<volume::LinkedTargets>& links() const { return links_; }

    bool read(int part, const surface::Response& response);

private:
    void start(Deformed& result);
    surface::Deformation& solved(int part) const;
    void set_at_rest(int part) const;
    void expand(int part, const surface::SurfaceTargets& targets) const;
    void take(const Deformed& joined);
    void answer_in_order();
    bool answer(int part, const std::shared_ptr<const surface::Response>& response);
    void substitute(int part);
    bool respond(int part, const std::shared_ptr<const surface::Response>& response);
    void pass_on(int part);
    void pass_on_link(std::size_t link);
    void pass_on_motions(int part);
    void run_stage(const std::vector<int>& parts, const PartResponses& responses,
                   std::vector<char>& answered);
    const surface::Deformation& read_of(int part) const;
    void place_answers() const;
    Points sized_rest(int part) const;
    std::optional<SizedForm> sized_form(int feature) const;
    void mark_preview(int part);
    void report_features(int part);
    void report_feature(int part, std::size_t own, const Points& rest);
    void report_contacts();

    const PreparedAssembly& prepared_;
    const Pose& pose_;
    Exactness exactness_;
    Progress progress_;
    std::vector<volume::LinkedTargets> links_;
    std::vector<RigidMotion> welds_;
    std::vector<RigidMotion> motions_;  // by feature of the assembly
    // By part: places its vertices, if only its rigid motions are known yet.
    std::vector<std::function<void(surface::Deformation&)>> answers_;
    Deformed* result_ = nullptr;
    std::vector<surface::Deformation>* read_ = nullptr;
    std::vector<char> is_in_read_;  // by part: what later parts read is there, else in the result
};

}  // namespace sheetmorph::assembly
