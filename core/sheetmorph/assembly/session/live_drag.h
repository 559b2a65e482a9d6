// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/session/deformation_session.h"

#include <mutex>
#include <set>

namespace sheetmorph::assembly
{

struct PreparedAssembly;

//! Live frames while some handles are dragged. After the first frame, or a moment without one, it
//! learns in the background how the parts answer (response.h). A frame takes what is ready and
//! substitutes the rest, so none waits. Either way it is within 1e-6 of the size of the exact
//! shape. Several threads may query one drag: they wait for each other's frames.
class LiveDrag
{
public:
    LiveDrag(std::shared_ptr<const PreparedAssembly> prepared, std::set<std::string> handles,
             const Pose& start, const DragOptions& options = {});

    //! Ends the background work after the substitution under way.
    ~LiveDrag();
    LiveDrag(const LiveDrag&) = delete;
    LiveDrag& operator=(const LiveDrag&) = delete;

    //! Any pose, always from rest; those of the dragged handles are fast (drag_samples.h). Rotation
    //! logs need not be there. \returns a frame that stays as it is while
    //! somebody holds it; the memory of one that nobody holds is used again
    //! \throws InvalidInput as DeformationSession::deform()
    std::shared_ptr<const Deformed> frame(const Pose& pose);

    //! Returns when the background work is done. \throws what it failed with
    void wait();

    bool is_ready() const;

    //! What the background work has failed with, in words, empty if it has not: frames go on by
    //! substitution. Does not wait.
    std::string failure() const;

    //! By part: whether the last frame took its response.
    std::vector<char> answered() const;

private:
    class Background;
    std::shared_ptr<Deformed> unheld_frame();
    std::shared_ptr<const PreparedAssembly> prepared_;
    std::unique_ptr<Background> background_;
    mutable std::mutex framing_;  // guards what follows
    std::vector<std::shared_ptr<Deformed>> frames_;
    std::vector<surface::Deformation> read_;  // by sheet: what later sheets read of a frame
    std::vector<char> answered_;
};

}  // namespace sheetmorph::assembly
