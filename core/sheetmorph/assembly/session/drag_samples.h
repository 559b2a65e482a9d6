// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/session/wave.h"

#include <list>
#include <set>

namespace sheetmorph::assembly
{

//! Poses of a drag, from which the parts learn how they answer (response.h). Handles of a part and
//! the welds that carry it turn on their own (own_poses()). What control meshes and ties drive
//! learns from poses that went through all parts before it: there handles turn by up to 75 degrees.
class DragSamples
{
public:
    //! \param start   told_pose()
    //! \param passes  whether parts learn what earlier parts pass on to them
    DragSamples(const PreparedAssembly& prepared, const std::set<std::string>& dragged,
                const Pose& start, bool passes);

    //! To be asked part by part in their order. Nothing for parts that cannot learn: what drives
    //! them must be learnt too.
    std::shared_ptr<const surface::Response> learn(int part, const Progress& progress);

private:
    bool is_passed_on(int part) const;
    void add_own(int part, std::vector<surface::SurfaceTargets>& samples) const;
    VertexIds reads_of(int part) const;

    const PreparedAssembly& prepared_;
    std::set<std::string> dragged_;
    Pose start_;
    Wave at_start_;
    std::vector<char> is_learnt_;  // by part: all waves have passed it
    std::vector<Pose> poses_;
    std::vector<surface::Deformation> read_;
    std::list<Wave> waves_;  // those that every part so far has answered
};

}  // namespace sheetmorph::assembly
