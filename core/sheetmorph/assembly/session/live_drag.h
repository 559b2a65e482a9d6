// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/session/deformation_session.h"

#include <set>

namespace sheetmorph
{

struct PreparedAssembly;

//! Live frames while some handles are dragged. Begun, it works out in the background how the parts
//! answer: to one or two handles or rigid welds (surface_response.h), to control meshes and ties
//! (sampled_response.h). A frame takes what is ready and substitutes the rest, so the first frame
//! does not wait. Either way it is within 1e-6 of the size of the exact shape. One thread at a time
//! asks for frames.
class LiveDrag
{
public:
    LiveDrag(std::shared_ptr<const PreparedAssembly> prepared, std::set<std::string> handles,
             const Pose& start, const DragOptions& options = {});

    //! Ends the background work after the substitution under way.
    ~LiveDrag();
    LiveDrag(const LiveDrag&) = delete;
    LiveDrag& operator=(const LiveDrag&) = delete;

    //! Any pose, always from rest; those that turn no more than two handles of a
    //! part are fast. Rotation logs need not be there. \returns a buffer that the next frame
    //! overwrites \throws InvalidInput as DeformationSession::deform()
    const Deformed& frame(const Pose& pose);

    //! Returns when the background work is done.
    void wait();

    bool is_ready() const;

    //! By part: whether the last frame took its response.
    const std::vector<char>& answered() const;

private:
    class Background;
    std::shared_ptr<const PreparedAssembly> prepared_;
    std::unique_ptr<Background> background_;
    Deformed result_;
    std::vector<Deformation> read_;  // by part: what later parts read of a frame
    std::vector<char> answered_;
};

}  // namespace sheetmorph
