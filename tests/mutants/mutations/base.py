# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mistakes in rotations, their logarithms and rigid motions."""
from mutation import Mutation

ROTATION = "base/rotation.cpp"
MOTION = "base/rigid_motion.cpp"
BATCH = "base/rotations/rotation_batch.cpp"
POOL = "base/threads/thread_pool.cpp"
BATCHES = "*RotationBatch.*"
MOTIONS = "*RigidMotion*"

MUTATIONS = [
    Mutation(
        ROTATION, "AngleAxisd(2.0 * half, log / half)", "AngleAxisd(half, log / half)", "Rotation.*"
    ),
    Mutation(
        ROTATION,
        "std::round((axis.dot(reference) - half) / pi)",
        "std::round((axis.dot(reference) - half) / (2.0 * pi))",
        "Rotation.*",
    ),
    Mutation(ROTATION, "if (q.w() < 0.0)", "if (q.w() > 0.0)", "Rotation.*"),
    Mutation(ROTATION, "signs(2) = -1.0", "signs(0) = -1.0", "Rotation*"),
    Mutation(MOTION, "* share.asDiagonal()\n", "\n", MOTIONS),
    Mutation(
        MOTION,
        "FromTwoVectors(svd.matrixU().col(0), svd.matrixV().col(0))",
        "FromTwoVectors(svd.matrixV().col(0), svd.matrixU().col(0))",
        MOTIONS,
    ),
    Mutation(MOTION, "goal = (pivot + translation)", "goal = translation", MOTIONS),
    Mutation(
        "base/log_near.cpp",
        "cosine = (1.0 - std::cos(angle)) / angle",
        "cosine = -(1.0 - std::cos(angle)) / angle",
        "LogNear.*",
    ),
    Mutation(
        "base/log_near.cpp",
        "0.5 * (rotation + rotation.inverse().transpose())",
        "0.5 * (rotation + rotation.inverse())",
        "LogNear*",
        "volume",
    ),
    # Many rotations at once.
    Mutation(BATCH, "yz = f * v.y * v.z;", "yz = f * v.y * v.y;", BATCHES),
    Mutation(BATCH, "hn::NegMulAdd(e, v.z, xy)", "hn::MulAdd(e, v.z, xy)", BATCHES),
    Mutation(BATCH, "hn::Neg(f * (xx + zz))", "hn::Neg(f * (xx - zz))", BATCHES),
    Mutation(BATCH, "1.0 / 362880.0", "1.0 / 362800.0", BATCHES),
    Mutation(
        BATCH,
        "rounded((along - half) * filled(1.0 / pi))",
        "rounded((along + half) * filled(1.0 / pi))",
        BATCHES,
    ),
    # Threads: work that is lost, and a wait that ends too early or never.
    Mutation(POOL, "item < count; item = next++", "item + 1 < count; item = next++", "*Parallel.*"),
    Mutation(
        POOL,
        "if (!failure || item < failed)",
        "if (!failure || item > failed)",
        "*Parallel.*",
    ),
]
