// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "assembly/drawn_parts.h"
#include "assembly/frames.h"

namespace sheetmorph::assembly::frames
{

//! A whole assembly with a pose, drawn at random: parts one after the other that branch and close
//! rings, held at the left, with handles, features, points, contacts and relations.
class DrawnAssembly
{
public:
    explicit DrawnAssembly(unsigned seed);
    const Frame& frame() const { return frame_; }

    //! Another pose of the same assembly.
    Pose another_pose();

    //! One handle or all of them.
    std::vector<std::string> dragged();

private:
    template <typename Condition>
    PartRegion region(const std::string& name, int part, Condition condition) const
    {
        const Vector3 corner = corners_[static_cast<std::size_t>(part)];
        return side(name, frame_.assembly, part,
                    [&](const Vector3& p) { return condition(Vector3(p - corner)); });
    }

    PartRegion end(int part) const;
    void add_part(int k);
    void add_contact(int a, int b, double from_a, double from_b);
    void add_regions();
    void add_handle(const std::string& name, const PartRegion& where);
    RigidMotion drawn_motion(const std::string& name, const Vector3& pivot);
    void add_features(int part);
    void bind(PartFeature& feature);
    void resize(PartFeature& feature);
    void add_relations();
    void add_point();

    shapes::Draw draw_;
    Frame frame_;
    std::vector<Vector3> corners_;
    std::vector<DrawnPart> drawn_;
};

}  // namespace sheetmorph::assembly::frames
