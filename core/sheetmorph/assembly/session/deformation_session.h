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

//! How one form feature moved, and how exactly it kept its form.
struct FeatureResult
{
    std::string name;
    int part = 0;
    RigidMotion motion;          //!< about the feature's rest centroid
    double edge_error = 0.0;     //!< worst |p_i - p_j - R (p_hat_i - p_hat_j)| over its edges, mm
    std::optional<double> size;  //!< mm, of features whose size is set
    double outline_error = 0.0;  //!< worst distance of its rim from the exact circle of that size
};

//! Every part in one pose. Edge errors, contacts and spread are measured by exact solves only.
struct Deformed
{
    std::vector<surface::Deformation>
        parts;  //!< by part; features hold those of the assembly first
    std::vector<surface::Deformation>
        middles;                          //!< by part: what was solved of a thin solid, else empty
    std::vector<FeatureResult> features;  //!< in the order of assembly().features
    std::vector<ContactFidelity> contacts;  //!< of plan().measured
    double spread = 0.0;  //!< mm: how far apart, at most, several contacts want one vertex
};

//! Time one stage of the pre-processing took.
struct Timing
{
    std::string stage;
    double seconds = 0.0;
};

//! Pieces of one part that nothing holds, decided as Assembly::unheld says.
struct LoosePieces
{
    int part = 0;
    int pieces = 0;
    int vertices = 0;                 //!< of all of them, on the skin of a thin solid
    Vector3 place = Vector3::Zero();  //!< of one of the first piece's vertices at rest, mm
};

class LiveDrag;
struct PreparedAssembly;

//! What is one rigid body though it was listed one by one.
struct JoinedBody
{
    std::vector<std::string> labels;  //!< "feature 'a'", "rigid contact 'b'", in their order
    std::vector<Subject> of;          //!< the entries that these stand for
};

//! The assembly, ready to be deformed: the constructor is the pre-processing phase, deform() the
//! interactive one. Parts that nothing reaches stay where they are.
class DeformationSession
{
public:
    //! \param previous  a session of an earlier state of the same assembly: what did not change
    //!                  since is taken over instead of computed again
    //! \throws InvalidInput naming part, region and ids (as the part's file numbers them)
    //! \throws Cancelled    if the progress callback asks for it
    explicit DeformationSession(Assembly assembly, const Progress& progress = {},
                                const DeformationSession* previous = nullptr);
    ~DeformationSession();
    DeformationSession(DeformationSession&&) noexcept;
    DeformationSession& operator=(DeformationSession&&) noexcept;

    //! \throws InvalidInput if the pose names what the assembly does not have, or contradicts
    //! \throws Cancelled    if the progress callback asks for it
    Deformed deform(const Pose& pose, Exactness exactness = Exactness::exact,
                    const Progress& progress = {}) const;

    //! Live frames while the named handles move, the others staying as in `start`; the session may
    //! end before the drag does. See live_drag.h.
    //! \throws InvalidInput if the assembly does not have a name
    std::unique_ptr<LiveDrag> begin_drag(const std::vector<std::string>& handles,
                                         const Pose& start = {},
                                         const DragOptions& options = {}) const;

    //! The control mesh of one contact (the single one: -1) in a pose of this session; nothing for
    //! other contacts. \throws InvalidInput for the shapes of another session
    std::optional<ShownControlMesh> control_mesh(int contact, const Deformed& pose) const;

    //! What the session deforms: with a plane of symmetry, or lumps on thin solids, more than
    //! given.
    const Assembly& assembly() const;

    //! By feature of assembly(): what it is, where its size can be set.
    const std::vector<std::optional<forms::FeatureShape>>& shapes() const;

    //! The thin solid that a part is solved as; nothing if it is solved as it is.
    const recognise::ThinSolid* thin_solid(int part) const;

    //! What is deformed of a part: its mesh, or the middle of a thin solid.
    const mesh::TriangleMesh& sheet(int part) const;

    //! How thick the sheet of a part is as `steel`, mm.
    double sheet_thickness(int part) const;

    //! Order, levels, directions of contacts and unreached parts.
    const PropagationPlan& plan() const;

    //! Form features, lumps and stacks of rigid contacts that are one rigid body because they share
    //! vertices or a group: their labels, body by body, of bodies with more than one.
    std::vector<JoinedBody> joined_bodies() const;

    //! By part, of parts that have any.
    std::vector<LoosePieces> loose_pieces() const;

    //! Whether a fixed region of its own holds a part, or one that reaches it through rigid
    //! contacts; any, where all parts are solved at once.
    bool is_held(int part) const;

    //! What pre-processing took, stage by stage; stages taken over are not listed.
    const std::vector<Timing>& timings() const;

private:
    std::shared_ptr<const PreparedAssembly> data_;
};

}  // namespace sheetmorph::assembly
