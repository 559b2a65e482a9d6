// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/session/prepared_assembly.h"
#include "sheetmorph/surface/live/response.h"

#include <functional>

namespace sheetmorph::assembly
{

//! How sheets answer in live frames, by sheet; nothing: by substitution.
using Responses = std::vector<std::shared_ptr<const surface::Response>>;

//! One pose on its way through the propagation order.
class Wave
{
public:
    //! \param progress  of exact answers that take long
    Wave(const PreparedAssembly& prepared, const Pose& pose, Exactness exactness,
         Progress progress = {});

    //! Every sheet anew.
    Deformed run();

    //! The same into the buffers of an earlier frame. Sheets with a response that
    //! covers the pose take it, and need not have rotation logs.
    //! \param read  by sheet: buffers for what later sheets read of it
    //! \returns by part, whether the response of its sheet was taken
    std::vector<char> run_live(const Responses& responses, std::vector<surface::Deformation>& read,
                               Deformed& result);

    //! For one pose of many, sheet by sheet in their order: only what later sheets read is known
    //! of a sheet, in buffers that the poses share.
    void begin_reading(std::vector<surface::Deformation>& read);
    surface::SurfaceTargets targets_of(int sheet) const;

    bool read(int sheet, const surface::Response& response);

private:
    void start(Deformed& result);
    const Sheet& sheet(int index) const;
    bool is_shared(int sheet) const;
    const ThinSolver* thin_of(int sheet) const;
    surface::Deformation& solved(int sheet) const;
    surface::Deformation& solved_part(int part) const;
    void set_others_at_rest() const;
    void set_at_rest(int sheet) const;
    void hand_out(int sheet, const surface::SurfaceTargets& targets) const;
    void answer_in_order();
    bool answer(int sheet, const std::shared_ptr<const surface::Response>& response);
    void substitute(int sheet);
    bool respond(int sheet, const std::shared_ptr<const surface::Response>& response);
    void pass_on(int sheet);
    void pass_on_link(std::size_t link);
    void pass_on_motions(int sheet);
    void run_stage(const std::vector<int>& sheets, const Responses& responses,
                   std::vector<char>& answered);
    const surface::Deformation& read_of(int sheet) const;
    void place_answers() const;
    Points sized_rest(int part) const;
    std::optional<SizedForm> sized_form(int feature) const;
    void mark_preview(int part);
    void report_features(int part);
    void report_feature(int part, std::size_t own, const Points& rest);
    void report_contacts();

    const PreparedAssembly& prepared_;
    const System& system_;
    const Pose& pose_;
    Exactness exactness_;
    Progress progress_;
    std::vector<volume::LinkedTargets> links_;
    std::vector<RigidMotion> welds_;
    std::vector<RigidMotion> motions_;  // by feature of the assembly
    // By sheet: places its vertices, if only its rigid motions are known yet.
    std::vector<std::function<void(surface::Deformation&)>> answers_;
    Deformed* result_ = nullptr;
    std::vector<surface::Deformation> own_read_;
    std::vector<surface::Deformation>* read_ = nullptr;
    // By sheet: what later sheets read is there, else in the result.
    std::vector<char> is_in_read_;
};

}  // namespace sheetmorph::assembly
