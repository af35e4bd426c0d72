// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Code for host and device alike, second part: bits, vectors and atomics; and the kernels of all.
/// Where C++ leaves a result undefined, or has no word for an instruction, the device has the
/// instruction and the host a formula.
#include "translated_numbers.h"

// The place of an instruction on the device, and of its formula on the host.
#ifdef __CUDA_ARCH__
#define WORD(text, host, ...)                                                                      \
  [&]                                                                                              \
  {                                                                                                \
    U32 r;                                                                                         \
    asm(text : "=r"(r) : __VA_ARGS__);                                                             \
    return r;                                                                                      \
  }()
#define LONG(text, host, ...)                                                                      \
  [&]                                                                                              \
  {                                                                                                \
    U64 r;                                                                                         \
    asm(text : "=l"(r) : __VA_ARGS__);                                                             \
    return r;                                                                                      \
  }()
#else
#define WORD(text, host, ...) U32(host)
#define LONG(text, host, ...) U64(host)
#endif
HD U64 field(U64 a, int bits, U32 position, U32 length, bool isSigned)
{
  U64 result = 0;
  for (U32 i = 0; i < 64; ++i)
  {
    const U32 last = position + (i < length ? i : length - 1);
    const U32 from = last < U32(bits) ? last : bits - 1;
    const bool inside = i < length && position + i < U32(bits);
    result |= U64(inside || (isSigned && length) ? a >> from & 1 : 0) << i;
  }
  return bits == 32 ? U32(result) : result;
}
HD U64 insertion(U64 a, U64 b, U32 bits, U32 position, U32 length)
{
  for (U32 i = 0; i < length && position + i < bits; ++i)
  {
    b = (b & ~(1ull << (position + i))) | ((a >> i & 1) << (position + i));
  }
  return b;
}
HD U32 permuted(const unsigned char* byte, U32 selector)
{
  U32 result = 0;
  for (int i = 0; i < 4; ++i, selector >>= 4)
  {
    const int x = byte[selector & 7];
    result |= U32(selector & 8 ? (x >> 7) * 255 : x) << (8 * i);
  }
  return result;
}
HD U32 carried(S64 a, S64 b, S64 c, S64 sign)
{
  const S64 second = c + sign * a + (a + sign * b >> 32);
  return U32(U32(second) + sign * b + (second >> 32));
}
HD U64 highAndLow(unsigned __int128 product, U64 k)
{
  return U64(product >> 64) + U64(product + k) + U64((unsigned __int128)U64(product) + k >> 64);
}
HD U64 wordOf(double x)
{
  U64 word;
  memcpy(&word, &x, 8);
  return word;
}
HD U32 firstOf(U64 x)
{
  return x ? __builtin_clzll(x) : -1;
}
HD void bits(const Settings&, const Input& in, Sink out)
{
  const U32 a = in.i[0], b = in.i[1], c = in.i[2], n = in.i[3] & 63, m = in.i[2] & 255;
  const U64 l = in.l[0], k = in.l[1], both = U64(b) << 32 | a;
  unsigned char bytes[8];
  memcpy(bytes, &both, 8);
  out(WORD("shl.b32 %0, %1, %2;", n < 32 ? a << n : 0, "r"(a), "r"(n)));
  out(WORD("shr.u32 %0, %1, %2;", n < 32 ? a >> n : 0, "r"(a), "r"(n)));
  out(WORD("shr.s32 %0, %1, %2;", int(a) >> (n < 32 ? n : 31), "r"(a), "r"(n)));
  out(LONG("shl.b64 %0, %1, %2;", m < 64 ? l << m : 0, "l"(l), "r"(m)));
  out(LONG("shr.s64 %0, %1, %2;", S64(l) >> (m < 64 ? m : 63), "l"(l), "r"(m)));
  out(WORD("shf.l.wrap.b32 %0, %1, %2, %3;", both << (n & 31) >> 32, "r"(a), "r"(b), "r"(n)));
  out(
    WORD("shf.l.clamp.b32 %0, %1, %2, %3;", n < 32 ? both << n >> 32 : a, "r"(a), "r"(b), "r"(n)));
  out(WORD("shf.r.wrap.b32 %0, %1, %2, %3;", both >> (n & 31), "r"(a), "r"(b), "r"(n)));
  out(WORD("shf.r.clamp.b32 %0, %1, %2, %3;", n < 32 ? both >> n : b, "r"(a), "r"(b), "r"(n)));
  out(WORD("bfe.u32 %0, %1, %2, %3;", field(a, 32, n, m, false), "r"(a), "r"(n), "r"(m)));
  out(WORD("bfe.s32 %0, %1, %2, %3;", field(a, 32, n, m, true), "r"(a), "r"(n), "r"(m)));
  out(WORD("bfe.s32 %0, %1, %2, %3;", field(a, 32, n, m & 15, true), "r"(a), "r"(n), "r"(m & 15)));
  out(LONG("bfe.u64 %0, %1, %2, %3;", field(l, 64, m, n, false), "l"(l), "r"(m), "r"(n)));
  out(LONG("bfe.s64 %0, %1, %2, %3;", field(l, 64, m, n, true), "l"(l), "r"(m), "r"(n)));
  out(
    WORD("bfi.b32 %0, %1, %2, %3, %4;", insertion(a, b, 32, n, m), "r"(a), "r"(b), "r"(n), "r"(m)));
  out(
    LONG("bfi.b64 %0, %1, %2, %3, %4;", insertion(l, k, 64, n, m), "l"(l), "l"(k), "r"(n), "r"(m)));
  out(WORD("prmt.b32 %0, %1, %2, %3;", permuted(bytes, c), "r"(a), "r"(b), "r"(c)));
  out(WORD("lop3.b32 %0, %1, %2, %3, 0xca;", (a & b) | (~a & c), "r"(a), "r"(b), "r"(c)));
  out(WORD("popc.b64 %0, %1;", __builtin_popcountll(l), "l"(l)));
  out(WORD("clz.b32 %0, %1;", a ? __builtin_clz(a) : 32, "r"(a)));
  out(WORD("clz.b64 %0, %1;", l ? __builtin_clzll(l) : 64, "l"(l)));
  out(WORD("bfind.u32 %0, %1;", a ? 31 - __builtin_clz(a) : -1, "r"(a)));
  out(WORD("bfind.shiftamt.s64 %0, %1;", firstOf(l ^ -(l >> 63)), "l"(l)));
  out(WORD("slct.b32.s32 %0, %1, %2, %3;", int(c) >= 0 ? a : b, "r"(a), "r"(b), "r"(c)));
  out(WORD("{ .reg .u16 t; cvt.sat.u8.s32 t, %1; cvt.u32.u16 %0, t; }",
    int(a) < 0       ? 0
      : int(a) > 255 ? 255
                     : a,
    "r"(a)));
  out(WORD("cvt.sat.s32.s64 %0, %1;",
    S64(l) < INT32_MIN     ? INT32_MIN
      : S64(l) > INT32_MAX ? INT32_MAX
                           : S64(l),
    "l"(l)));
  const double x = in.d[0] == in.d[0] ? in.d[0] : -0.0, y = in.d[1] == in.d[1] ? in.d[1] : 0.0;
  out(LONG("{ .reg .f64 t; min.f64 t, %1, %2; mov.b64 %0, t; }",
    wordOf(x < y || (x == y && std::signbit(x)) ? x : y), "d"(x), "d"(y)));
  out(LONG("{ .reg .f64 t; max.f64 t, %1, %2; mov.b64 %0, t; }",
    wordOf(x > y || (x == y && std::signbit(y)) ? x : y), "d"(x), "d"(y)));
  U32 reversed = 0;
  for (int i = 0; i < 32; ++i)
  {
    reversed |= (a >> i & 1) << (31 - i);
  }
  out(WORD("brev.b32 %0, %1;", reversed, "r"(a)));
  out(WORD("div.s32 %0, %1, -1;", -a, "r"(a)));
  out(WORD("rem.s32 %0, %1, -1;", 0, "r"(a)));
  out(WORD("cnot.b32 %0, %1;", a == 0, "r"(a)));
  out(WORD("{ .reg .pred %%p; testp.subnormal.f64 %%p, %1; selp.u32 %0, 1, 0, %%p; }",
    in.d[0] != 0 && std::fabs(in.d[0]) < 2.3e-308 && std::fabs(in.d[0]) < 2.2250738585072014e-308,
    "d"(in.d[0])));
  out(WORD("{ .reg .u32 t; add.cc.u32 t, %1, %2; addc.cc.u32 t, %3, %1; addc.u32 %0, t, %2; }",
    carried(a, b, c, 1), "r"(a), "r"(b), "r"(c)));
  out(WORD("{ .reg .u32 t; sub.cc.u32 t, %1, %2; subc.cc.u32 t, %3, %1; subc.u32 %0, t, %2; }",
    carried(a, b, c, -1), "r"(a), "r"(b), "r"(c)));
  out(LONG("{ .reg .u64 t; mad.lo.cc.u64 t, %1, %2, %2; madc.hi.u64 %0, %1, %2, t; }",
    highAndLow((unsigned __int128)l * k, k), "l"(l), "l"(k)));
}

HD void vectors(const Settings&, const Input& in, Sink out)
{
#ifdef __CUDA_ARCH__
  const double2 d = reinterpret_cast<const double2*>(in.d)[1];
  const int4 i = *reinterpret_cast<const int4*>(in.i);
  const ushort4 s = *reinterpret_cast<const ushort4*>(in.l);
  const char4 c = *reinterpret_cast<const char4*>(in.l + 1);
  const float4 f = *reinterpret_cast<const float4*>(in.f);
#else
  struct
  {
    double x, y;
  } d;
  struct
  {
    int x, y, z, w;
  } i;
  struct
  {
    unsigned short x, y, z, w;
  } s;
  struct
  {
    signed char x, y, z, w;
  } c;
  struct
  {
    float x, y, z, w;
  } f;
  memcpy(&d, in.d + 2, 16);
  memcpy(&i, in.i, 16);
  memcpy(&s, in.l, 8);
  memcpy(&c, in.l + 1, 4);
  memcpy(&f, in.f, 16);
#endif
  out(d.x - d.y);
  out(U32(i.x) * i.y + i.z - i.w);
  out(s.x * s.y - s.z + s.w);
  out(c.x * c.y + c.z - c.w);
  out((f.x + f.y) * (f.z - f.w));
}

template <class T>
HD T exchanged(T* place, T x, int how) // atomically; what was there
{
#ifdef __CUDA_ARCH__
  return how == 0 ? atomicMin(place, x)
    : how == 1    ? atomicMax(place, x)
    : how == 2    ? atomicExch(place, x)
    : how == 3    ? atomicOr(place, x)
    : how == 4    ? atomicAnd(place, x)
    : how == 5    ? atomicXor(place, x)
    : how == 6    ? atomicCAS(place, T(x & 3), x)
                  : atomicAdd(place, x);
#else
  const T old = *place;
  *place = how == 0 ? (x < old ? x : old)
    : how == 1      ? (x > old ? x : old)
    : how == 2      ? x
    : how == 3      ? old | x
    : how == 4      ? old & x
    : how == 5      ? old ^ x
    : how == 6      ? (old == T(x & 3) ? x : old)
                    : T(U64(old) + U64(x));
  return old;
#endif
}
HD void atomics(const Settings& settings, const Input& in, Sink out)
{
  for (int how = 0; how < 8; ++how)
  {
    out(exchanged(reinterpret_cast<U64*>(settings.counters) + how, U64(in.l[how & 3]), how));
    out(exchanged(reinterpret_cast<int*>(settings.counters + 8) + how, in.i[how & 3], how));
    out(exchanged(reinterpret_cast<U32*>(settings.counters + 16) + how, U32(in.i[how & 3]), how));
  }
  U32* const turns = reinterpret_cast<U32*>(settings.counters + 29);
  const U32 limit = in.i[2] & 7;
#ifdef __CUDA_ARCH__
  out(atomicInc(turns, limit));
  out(atomicDec(turns + 1, limit));
#else
  out(turns[0]);
  out(turns[1]);
  turns[0] = turns[0] >= limit ? 0 : turns[0] + 1;
  turns[1] = turns[1] == 0 || turns[1] > limit ? limit : turns[1] - 1;
#endif
  volatile S64* const mailbox = settings.counters + 30;
  double* const sum = reinterpret_cast<double*>(settings.counters + 31);
  const double finite = std::fabs(in.d[0]) < 1e300 ? in.d[0] : 0;
#ifdef __CUDA_ARCH__
  __threadfence();
  out(atomicAdd(sum, finite));
  const U32 mask = __activemask(); // one lane
  out(__popc(mask));
  out(__shfl_sync(mask, in.i[0], __ffs(mask) - 1));
  out(__ballot_sync(mask, in.i[0] > 0) != 0);
  __syncwarp(mask);
#else
  out(*sum);
  *sum += finite;
  out(1);
  out(in.i[0]);
  out(in.i[0] > 0);
#endif
  *mailbox = *mailbox + in.l[0] % 1000;
}

#define KERNELS(X)                                                                                 \
  X(doubles)                                                                                       \
  X(floats)                                                                                        \
  X(exponents)                                                                                     \
  X(integers) X(wide) X(calls) X(arrays) X(branches) X(conversions) X(bits) X(vectors) X(atomics)
#ifdef __CUDACC__
#define KERNEL(name)                                                                               \
  __global__ void name##Kernel(const Settings settings, const Input* in, U64* out, int n)          \
  {                                                                                                \
    const int i = blockIdx.x * blockDim.x + threadIdx.x;                                           \
    if (i < n)                                                                                     \
    {                                                                                              \
      name(settings, in[i], Sink{ out + Places * i });                                             \
    }                                                                                              \
  }
KERNELS(KERNEL)
#endif
