// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/session/wave.h"

#include <list>
#include <set>

namespace sheetmorph::assembly
{

//! Poses of a drag, from which the sheets learn how they answer (response.h). Handles of a sheet
//! and the welds that carry it turn on their own (own_poses()). What control meshes and ties drive
//! learns from poses that went through all sheets before it: there handles turn by up to 75
//! degrees.
class DragSamples
{
public:
    //! \param start   told_pose()
    //! \param passes  whether sheets learn what earlier ones pass on to them
    DragSamples(const PreparedAssembly& prepared, const std::set<std::string>& dragged,
                const Pose& start, bool passes);

    //! To be asked sheet by sheet in their order. Nothing for sheets that cannot learn: what drives
    //! them must be learnt too.
    std::shared_ptr<const surface::Response> learn(int sheet, const Progress& progress);

private:
    bool is_passed_on(int sheet) const;
    void add_own(int sheet, std::vector<surface::SurfaceTargets>& samples) const;
    surface::ResponseReaders readers_of(int sheet) const;

    const PreparedAssembly& prepared_;
    std::set<std::string> dragged_;
    Pose start_;
    Wave at_start_;
    std::vector<char> is_learnt_;  // by sheet: all waves have passed it
    std::vector<Pose> poses_;
    std::vector<surface::Deformation> read_;
    std::list<Wave> waves_;  // those that every sheet so far has answered
};

}  // namespace sheetmorph::assembly
