// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/session/wave.h"

#include <list>
#include <set>

namespace sheetmorph
{

//! Poses of a drag on their way through the parts: handles turned by up to 75 degrees and moved by
//! up to a third of their part from where they stand. From them parts that control meshes and ties
//! drive, and those that drive them, learn how they answer (sampled_response.h).
class DragSamples
{
public:
    //! \param start  told_pose()
    DragSamples(const PreparedAssembly& prepared, const std::set<std::string>& dragged,
                const Pose& start);

    //! To be asked part by part in their order. Nothing for parts that need not learn, or cannot:
    //! what a part before them became must be learnt too.
    std::shared_ptr<const SampledResponse> learn(int part, const Progress& progress);

private:
    void find_needed();
    bool can_learn(int part) const;
    VertexIds reads_of(int part) const;

    const PreparedAssembly& prepared_;
    std::vector<char> is_needed_, is_learnt_;  // by part
    std::vector<Pose> poses_;
    std::vector<Deformation> read_;
    std::list<Wave> waves_;  // those that every part so far has answered
};

}  // namespace sheetmorph
