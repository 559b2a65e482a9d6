// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/symmetry/mirror.h"

namespace sheetmorph::assembly
{

Vector3 Mirror::across(const Vector3& direction) const
{
    return plane_.normal.dot(direction) * plane_.normal;
}

Vector3 Mirror::vector(const Vector3& direction) const
{
    return direction - 2.0 * across(direction);
}

Vector3 Mirror::point(const Vector3& position) const
{
    return position - 2.0 * across(position - plane_.point);
}

Vector3 Mirror::log(const Vector3& rotation_log) const
{
    return -vector(rotation_log);
}

RigidMotion Mirror::motion(const RigidMotion& given) const
{
    return {vector(given.translation), log(given.rotation_log), point(given.pivot)};
}

Vector3 Mirror::symmetric_vector(const Vector3& direction) const
{
    return direction - across(direction);
}

Vector3 Mirror::symmetric_log(const Vector3& rotation_log) const
{
    return across(rotation_log);
}

RigidMotion Mirror::symmetric_motion(const RigidMotion& given) const
{
    return {symmetric_vector(given.translation), symmetric_log(given.rotation_log), given.pivot};
}

}  // namespace sheetmorph::assembly
