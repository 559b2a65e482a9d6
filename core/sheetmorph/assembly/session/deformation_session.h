// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/links/motion_link.h"
#include "sheetmorph/assembly/plan/propagation_plan.h"
#include "sheetmorph/assembly/session/fidelity.h"
#include "sheetmorph/base/progress.h"
#include "sheetmorph/forms/feature_shape.h"
#include "sheetmorph/recognise/thin/thin_solid.h"
#include "sheetmorph/surface/surface_deformer.h"

#include <memory>

namespace sheetmorph::assembly
{

//! Motion of a form feature, and its errors.
struct FeatureResult
{
    std::string name;
    int part = 0;
    RigidMotion motion;          //!< about the centroid of the feature at rest
    double edge_error = 0.0;     //!< worst |p_i - p_j - R (p_hat_i - p_hat_j)| over its edges, mm
    std::optional<double> size;  //!< mm, if it is set
    double outline_error = 0.0;  //!< mm: largest distance of its rim from its exact outline
};

//! Every part in one pose. Only exact solves measure edge errors, contacts and spread.
struct Deformed
{
    std::vector<surface::Deformation> parts;  //!< by part; features first those of the assembly
    std::vector<surface::Deformation>
        middles;                            //!< by part: mid-surface of a thin solid, else empty
    std::vector<FeatureResult> features;    //!< in the order of assembly().features
    std::vector<ContactFidelity> contacts;  //!< of plan().measured
    double spread = 0.0;  //!< mm: largest distance between several targets of one vertex
};

//! Duration of one stage of the set-up.
struct Timing
{
    std::string stage;
    double seconds = 0.0;
};

//! Pieces of one part without a constraint, treated according to Assembly::unheld.
struct LoosePieces
{
    int part = 0;
    int pieces = 0;
    int vertices = 0;                 //!< of all pieces, on the skin of a thin solid
    Vector3 place = Vector3::Zero();  //!< of one vertex of the first piece at rest, mm
};

class LiveDrag;
struct PreparedAssembly;

//! Entries that form one rigid body although they are listed separately.
struct JoinedBody
{
    std::vector<std::string> labels;  //!< "feature 'a'", "rigid contact 'b'", in order
    std::vector<Subject> of;          //!< the entries behind these labels
};

//! An assembly, ready to be deformed. The constructor is the pre-processing phase, deform() the
//! interactive one. Parts that nothing reaches stay at rest.
class DeformationSession
{
public:
    //! \param previous  optional, a session of an earlier state of the same assembly; unchanged
    //!     parts are reused
    //! \throws InvalidInput naming part, region and ids (as the part's file numbers them)
    //! \throws Cancelled    if the progress callback requests it
    explicit DeformationSession(Assembly assembly, const Progress& progress = {},
                                const DeformationSession* previous = nullptr);
    ~DeformationSession();
    DeformationSession(DeformationSession&&) noexcept;
    DeformationSession& operator=(DeformationSession&&) noexcept;

    //! \throws InvalidInput if the pose names an entry that does not exist, or contradicts itself
    //! \throws Cancelled    if the progress callback requests it
    Deformed deform(const Pose& pose, Exactness exactness = Exactness::exact,
                    const Progress& progress = {}) const;

    //! Live frames while the named handles move; the others stay as in `start`. The session may end
    //! before the drag. See live_drag.h.
    //! \throws InvalidInput if a name does not exist
    std::unique_ptr<LiveDrag> begin_drag(const std::vector<std::string>& handles,
                                         const Pose& start = {},
                                         const DragOptions& options = {}) const;

    //! The control mesh of one contact (-1: the single one) in a pose of this session; nothing for
    //! other contacts.
    //! \throws InvalidInput for the shapes of another session
    std::optional<ShownControlMesh> control_mesh(int contact, const Deformed& pose) const;

    //! The assembly that the session deforms. With a plane of symmetry, or lumps on thin solids, it
    //! has more entries than the given one.
    const Assembly& assembly() const;

    //! By feature of assembly(): its shape, if its size can be set.
    const std::vector<std::optional<forms::FeatureShape>>& shapes() const;

    //! The thin solid of a part; nothing if the part is solved as it is.
    const recognise::ThinSolid* thin_solid(int part) const;

    //! The mesh that is solved for a part: its own, or the mid-surface of its thin solid.
    const mesh::TriangleMesh& sheet(int part) const;

    //! Thickness of a part's sheet as `steel`, mm.
    double sheet_thickness(int part) const;

    //! Order, levels, directions of contacts and unreached parts.
    const PropagationPlan& plan() const;

    //! Form features, lumps and stacks of rigid contacts that form one rigid body because they
    //! share vertices or a group. Labels, body by body, for bodies with several.
    std::vector<JoinedBody> joined_bodies() const;

    //! By part, for parts with loose pieces.
    std::vector<LoosePieces> loose_pieces() const;

    //! Whether a fixed region holds a part: its own, one that rigid contacts connect to it, or any
    //! one if all parts are solved together.
    bool is_held(int part) const;

    //! Durations of the stages of the set-up, without reused ones.
    const std::vector<Timing>& timings() const;

private:
    std::shared_ptr<const PreparedAssembly> data_;
};

}  // namespace sheetmorph::assembly
