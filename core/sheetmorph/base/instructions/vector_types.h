// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

//! Inlined into callers compiled for other instruction sets, or the kernels would not be
//! vectorised.
#define SHEETMORPH_INLINED __attribute__((always_inline))
#define SHEETMORPH_INLINE inline SHEETMORPH_INLINED

namespace sheetmorph
{

//! `width` doubles in one register (or several). Written out: g++ 12 drops the attribute of a
//! vector type whose size depends on a template parameter as soon as it is const.
template <int width>
struct VectorTypes;

template <>
struct VectorTypes<2>
{
    using Lanes = double __attribute__((vector_size(16)));
    using Bits = long long __attribute__((vector_size(16)));
};

template <>
struct VectorTypes<4>
{
    using Lanes = double __attribute__((vector_size(32)));
    using Bits = long long __attribute__((vector_size(32)));
};

template <>
struct VectorTypes<8>
{
    using Lanes = double __attribute__((vector_size(64)));
    using Bits = long long __attribute__((vector_size(64)));
};

//! The same for floats: Lanes of `width` floats, and as many integers of 32 and 16 bits.
template <int width>
struct FloatVectorTypes;

template <>
struct FloatVectorTypes<2>
{
    using Lanes = float __attribute__((vector_size(8)));
    using Ints = int __attribute__((vector_size(8)));
    using Shorts = short __attribute__((vector_size(4)));
};

template <>
struct FloatVectorTypes<4>
{
    using Lanes = float __attribute__((vector_size(16)));
    using Ints = int __attribute__((vector_size(16)));
    using Shorts = short __attribute__((vector_size(8)));
};

template <>
struct FloatVectorTypes<8>
{
    using Lanes = float __attribute__((vector_size(32)));
    using Ints = int __attribute__((vector_size(32)));
    using Shorts = short __attribute__((vector_size(16)));
};

template <>
struct FloatVectorTypes<16>
{
    using Lanes = float __attribute__((vector_size(64)));
    using Ints = int __attribute__((vector_size(64)));
    using Shorts = short __attribute__((vector_size(32)));
};

}  // namespace sheetmorph
