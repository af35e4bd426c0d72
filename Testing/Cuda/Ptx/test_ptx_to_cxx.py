#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Does ptx_to_cxx.py translate as it says? One source is compiled for the host, and through nvcc
and the translator; what both compute must have the same bits. Skipped where there is no nvcc."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

TRANSLATOR = pathlib.Path(__file__).with_name("ptx_to_cxx.py")

# What host and device share. Where C++ leaves a result undefined, or has no word for an
# instruction, the device has the instruction and the host a formula.
SOURCE = r"""
#include <cmath>
#include <cstdint>
#include <cstring>
#ifdef __CUDACC__
#define HD __host__ __device__
#define DATA __device__
#define APART __noinline__
#else
#define HD
#define DATA
#define APART __attribute__((noinline))
#endif

using U32 = unsigned;
using S64 = long long;
using U64 = unsigned long long;
struct alignas(16) Input { double d[4]; S64 l[4]; float f[4]; int i[4]; };
struct Settings { double scale[20]; S64* counters; short shorts[5]; char last; };

struct Sink
{
  U64* place;
  HD void bits(U64 x) { *this->place++ = x; }
  HD void operator()(S64 x) { this->bits(x); }
  HD void operator()(U64 x) { this->bits(x); }
  HD void operator()(int x) { this->bits(x); }
  HD void operator()(U32 x) { this->bits(x); }
  HD void operator()(bool x) { this->bits(x); }
  HD void operator()(unsigned __int128 x) { this->bits(x); this->bits(x >> 64); }
  HD void operator()(double x)
  {
    U64 word;
    memcpy(&word, &x, 8);
    this->bits(x != x ? 0x7ff8000000000000 : word); // NaNs are one
  }
  HD void operator()(float x)
  {
    U32 word;
    memcpy(&word, &x, 4);
    this->bits(x != x ? 0x7fc00000 : word);
  }
};
constexpr int Places = 64; // for each input

template <class Real>
HD void arithmeticOf(const Real* x, Sink& out)
{
  const Real a = x[0], b = x[1], c = x[2];
  out(a + b); out(a - b); out(a * b); out(a / b); out(1 / a);
  out(a * b + c); out(std::fma(a, b, c)); out(std::sqrt(a)); out(-a); out(std::fabs(a));
  out(std::copysign(a, b)); out(std::floor(a)); out(std::ceil(a)); out(std::trunc(a));
  out(std::rint(a)); out(a < b); out(a <= b); out(a > b); out(a >= b); out(a == b); out(a != b);
  out(!(a < b)); out(!(a <= b)); out(!(a > b)); out(!(a >= b)); out(std::isnan(a));
  out(a < b && c < a); out(a < b || !(c < a)); out(a > b ? b : a);
}
HD void doubles(const Settings&, const Input& in, Sink out) { arithmeticOf(in.d, out); }
HD void floats(const Settings&, const Input& in, Sink out) { arithmeticOf(in.f, out); }

HD void exponents(const Settings& settings, const Input& in, Sink out)
{
  const double x = in.d[0];
  out(ldexp(x, in.i[0] % 2200)); out(ldexp(x, in.i[1] % 64)); out(scalbnf(in.f[0], in.i[2] % 300));
  const bool isOrdinary = x != 0 && std::fabs(x) <= 1.7e308;
  out(isOrdinary ? ilogb(x) : 0);
  int exponent = 0;
  out(isOrdinary ? frexp(x, &exponent) : 0); out(exponent);
  out(fmod(in.d[1], settings.scale[3])); out(fmin(x, in.d[1]) + 0.); out(fmax(in.d[1], x) + 0.);
}

HD void integers(const Settings&, const Input& in, Sink out)
{
  const int a = in.i[0], b = in.i[1];
  const U32 ua = a, ub = b;
  const S64 l = in.l[0], m = in.l[1];
  const U64 ul = l, um = m;
  out(ua + ub); out(ua - ub); out(ua * ub); out(S64(a) * b); out(U64(ua) * ub);
  out(int(ua * ub + U32(in.i[2]))); out(l > -99 && b > 9 ? l / b : m); out(b ? ua / ub : 7u);
  out(b > 0 ? a / b : 1); out(b > 0 ? a % b : 1); out(m ? ul % um : 0); out(m > 0 ? l % m : 1);
  out(a < b ? a : b); out(ua > ub ? ua : ub); out(l > m ? l : m); out(a < 0 ? -ua : ua);
  out(a >> (b & 31)); out(ua >> (b & 31)); out(ul << (m & 63)); out(l >> (m & 63));
  out(~a & b); out(ul ^ (um | 12345)); out(int(short(a)) * short(b)); out(U32(uint16_t(a * 3)));
  out(int(int8_t(b))); out(S64(int8_t(m)));
}

HD void wide(const Settings&, const Input& in, Sink out)
{
  using U128 = unsigned __int128;
  const __int128 a = __int128(in.l[0]) * in.l[1], b = __int128(in.l[2]) << (in.i[0] & 63);
  const U128 c = U128(U64(in.l[0])) * U64(in.l[3]), d = U128(a) * U128(b);
  out(U128(a)); out(U128(b)); out(c); out(d); out(c + d); out(c - d); out(a < b); out(c < d);
  out(U128(a >> (in.i[1] & 127))); out(c >> (in.i[2] & 127)); out(c << (in.i[3] & 127));
  out(-c); out(U64(c >> 64) * 3 + U64(c)); out(a == b); out(c ^ d);
}

struct Packet { double x[3]; int number; signed char mark; };
HD APART Packet mix(Packet a, const Packet b, int turn)
{
  for (int i = 0; i < 3; ++i) { a.x[i] += b.x[(turn + i) & 1]; }
  a.number ^= b.number + turn;
  a.mark = a.mark * b.mark;
  return a;
}
HD APART float narrow(float x, bool up, short by, signed char also)
{
  return up ? x + by : x - also;
}
HD APART void swap(double* a, double* b) { const double c = *a; *a = *b; *b = c; }
HD void calls(const Settings& settings, const Input& in, Sink out)
{
  Packet a = { { in.d[0], in.d[1], in.d[2] }, in.i[0], (signed char)in.i[1] };
  const Packet b = mix(a, Packet{ { 1, in.d[3], 2 }, in.i[2], settings.last }, in.i[3]);
  a = mix(b, a, 5);
  swap(&a.x[in.i[0] & 1], &a.x[2]);
  for (int i = 0; i < 3; ++i) { out(a.x[i]); out(b.x[i]); }
  out(a.number); out(b.number); out(int(a.mark)); out(int(b.mark));
  out(narrow(in.f[0], in.i[0] & 1, settings.shorts[in.i[1] & 3], settings.last));
}

DATA int ints[4] = { 5, 6, -7, 8 };
DATA int* const pointers[3] = { ints + 3, ints, ints + 2 };
DATA const double factors[5] = { 1.5, -2, 1e300, 0, 5e-324 };
DATA signed char marks[7] = { 1, -2, 3, -4, 5, -128, 127 };
HD void arrays(const Settings& settings, const Input& in, Sink out)
{
  int local[32];
  for (int i = 0; i < 32; ++i) { local[i] = in.i[i & 3] >> (i & 7); }
  for (int i = 0; i < 64; ++i) { local[local[i & 31] & 31] ^= local[(i * 7 + in.i[0]) & 31] + i; }
  U32 sum = 0;
  for (int i = 0; i < 32; ++i) { sum = sum * 31 + local[i]; }
  out(sum); out(local[in.i[1] & 31]); out(settings.scale[U32(in.i[2]) % 20]);
#if defined(__CUDA_ARCH__) || !defined(__CUDACC__) // these data are the device's
  out(*pointers[U32(in.i[3]) % 3]); out(factors[U32(in.i[0]) % 5] * in.d[0]);
  out(int(marks[U32(in.i[1]) % 7]));
#endif
}

HD APART int jump(int by, int x)
{
#ifdef __CUDA_ARCH__
  int y;
  asm("{\n .reg .pred %p, q;\n setp.ge.and.u32 %p|q, %1, 3, 1;\n @%p bra D;\n"
      "T: .branchtargets A, B, C;\n brx.idx %1, T;\n A: add.s32 %0, %2, 1; bra.uni E;\n"
      "B: sub.s32 %0, %2, 1; bra.uni E;\n C: neg.s32 %0, %2; bra.uni E;\n"
      "D: mov.b32 %0, -9;\n E: selp.b32 %0, %0, 5, q;\n}" : "=r"(y) : "r"(by), "r"(x));
  return y;
#else
  return by == 0 ? U32(x) + 1 : by == 1 ? U32(x) - 1 : by == 2 ? -U32(x) : 5;
#endif
}
HD void branches(const Settings&, const Input& in, Sink out)
{
  int x = in.i[1];
  switch (in.i[0] & 15)
  {
    case 0: x ^= in.i[2]; break;
    case 1: x = in.i[3] >> 3; // and on
    case 2: x |= 64; break;
    case 3: x &= in.i[2]; break;
    case 4: x = ~x; break;
    case 7: x = in.f[0] > 1 ? 9 : 8; break;
    case 9: case 10: x = 4; break;
    case 12: out(in.d[0]); break;
    default: x = 77;
  }
  out(x); out(jump(in.i[0] & 3, x));
  U64 a = U64(in.l[0]), steps = 0; // a loop that ends when the data say so
  while (a > 1 && steps < 90) { a = a & 1 ? a / 3 : a / 2; ++steps; }
  out(a); out(steps);
}

template <class To, class From>
HD To converted(From x) // as the device does it
{
#ifdef __CUDA_ARCH__
  return static_cast<To>(x);
#else
  constexpr int digits = 8 * sizeof(To) - (To(-1) < To(0));
  const To highest = To(U64(-1) >> (64 - digits)), lowest = To(-1) < To(0) ? -highest - 1 : 0;
  if (x != x) { return sizeof(To) + sizeof(From) < 12 ? 0 : To(U64(1) << (8 * sizeof(To) - 1)); }
  return x >= std::ldexp(1.0, digits) ? highest : x <= From(lowest) ? lowest : To(x);
#endif
}
HD void conversions(const Settings&, const Input& in, Sink out)
{
  const double x = in.d[0];
  const float f = in.f[0];
  out(converted<int>(x)); out(converted<U32>(x)); out(converted<S64>(x)); out(converted<U64>(x));
  out(converted<int>(f)); out(converted<U32>(f)); out(converted<S64>(f)); out(converted<U64>(f));
  out(float(x)); out(double(f)); out(float(in.l[0])); out(double(in.l[0]));
  out(float(U64(in.l[1]))); out(double(U64(in.l[1]))); out(double(in.i[0])); out(float(in.i[0]));
  out(float(U32(in.i[1]))); out(float(short(in.i[2]))); out(double(int8_t(in.i[3])));
  out(std::fabs(x) < 1e15 ? S64(std::floor(x)) : 0); out(std::fabs(f) < 1e6 ? S64(lrintf(f)) : 0);
}

// The place of an instruction on the device, and of its formula on the host.
#ifdef __CUDA_ARCH__
#define WORD(text, host, ...) [&] { U32 r; asm(text : "=r"(r) : __VA_ARGS__); return r; }()
#define LONG(text, host, ...) [&] { U64 r; asm(text : "=l"(r) : __VA_ARGS__); return r; }()
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
HD U32 firstOf(U64 x) { return x ? __builtin_clzll(x) : -1; }
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
  out(WORD("shf.l.clamp.b32 %0, %1, %2, %3;", n < 32 ? both << n >> 32 : a,
    "r"(a), "r"(b), "r"(n)));
  out(WORD("shf.r.wrap.b32 %0, %1, %2, %3;", both >> (n & 31), "r"(a), "r"(b), "r"(n)));
  out(WORD("shf.r.clamp.b32 %0, %1, %2, %3;", n < 32 ? both >> n : b, "r"(a), "r"(b), "r"(n)));
  out(WORD("bfe.u32 %0, %1, %2, %3;", field(a, 32, n, m, false), "r"(a), "r"(n), "r"(m)));
  out(WORD("bfe.s32 %0, %1, %2, %3;", field(a, 32, n, m, true), "r"(a), "r"(n), "r"(m)));
  out(WORD("bfe.s32 %0, %1, %2, %3;", field(a, 32, n, m & 15, true), "r"(a), "r"(n), "r"(m & 15)));
  out(LONG("bfe.u64 %0, %1, %2, %3;", field(l, 64, m, n, false), "l"(l), "r"(m), "r"(n)));
  out(LONG("bfe.s64 %0, %1, %2, %3;", field(l, 64, m, n, true), "l"(l), "r"(m), "r"(n)));
  out(WORD("bfi.b32 %0, %1, %2, %3, %4;", insertion(a, b, 32, n, m),
    "r"(a), "r"(b), "r"(n), "r"(m)));
  out(LONG("bfi.b64 %0, %1, %2, %3, %4;", insertion(l, k, 64, n, m),
    "l"(l), "l"(k), "r"(n), "r"(m)));
  out(WORD("prmt.b32 %0, %1, %2, %3;", permuted(bytes, c), "r"(a), "r"(b), "r"(c)));
  out(WORD("lop3.b32 %0, %1, %2, %3, 0xca;", (a & b) | (~a & c), "r"(a), "r"(b), "r"(c)));
  out(WORD("popc.b64 %0, %1;", __builtin_popcountll(l), "l"(l)));
  out(WORD("clz.b32 %0, %1;", a ? __builtin_clz(a) : 32, "r"(a)));
  out(WORD("clz.b64 %0, %1;", l ? __builtin_clzll(l) : 64, "l"(l)));
  out(WORD("bfind.u32 %0, %1;", a ? 31 - __builtin_clz(a) : -1, "r"(a)));
  out(WORD("bfind.shiftamt.s64 %0, %1;", firstOf(l ^ -(l >> 63)), "l"(l)));
  out(WORD("slct.b32.s32 %0, %1, %2, %3;", int(c) >= 0 ? a : b, "r"(a), "r"(b), "r"(c)));
  out(WORD("{ .reg .u16 t; cvt.sat.u8.s32 t, %1; cvt.u32.u16 %0, t; }",
    int(a) < 0 ? 0 : int(a) > 255 ? 255 : a, "r"(a)));
  out(WORD("cvt.sat.s32.s64 %0, %1;",
    S64(l) < INT32_MIN ? INT32_MIN : S64(l) > INT32_MAX ? INT32_MAX : S64(l), "l"(l)));
  const double x = in.d[0] == in.d[0] ? in.d[0] : -0.0, y = in.d[1] == in.d[1] ? in.d[1] : 0.0;
  out(LONG("{ .reg .f64 t; min.f64 t, %1, %2; mov.b64 %0, t; }",
    wordOf(x < y || (x == y && std::signbit(x)) ? x : y), "d"(x), "d"(y)));
  out(LONG("{ .reg .f64 t; max.f64 t, %1, %2; mov.b64 %0, t; }",
    wordOf(x > y || (x == y && std::signbit(y)) ? x : y), "d"(x), "d"(y)));
  U32 reversed = 0;
  for (int i = 0; i < 32; ++i) { reversed |= (a >> i & 1) << (31 - i); }
  out(WORD("brev.b32 %0, %1;", reversed, "r"(a)));
  out(WORD("div.s32 %0, %1, -1;", -a, "r"(a))); out(WORD("rem.s32 %0, %1, -1;", 0, "r"(a)));
  out(WORD("cnot.b32 %0, %1;", a == 0, "r"(a)));
  out(WORD("{ .reg .pred %%p; testp.subnormal.f64 %%p, %1; selp.u32 %0, 1, 0, %%p; }",
    in.d[0] != 0 && std::fabs(in.d[0]) < 2.3e-308 && std::fabs(in.d[0]) < 2.2250738585072014e-308,
    "d"(in.d[0])));
  out(WORD("{ .reg .u32 t; add.cc.u32 t, %1, %2; addc.cc.u32 t, %3, %1; addc.u32 %0, t, %2; }",
    carried(a, b, c, 1), "r"(a), "r"(b), "r"(c)));
  out(WORD("{ .reg .u32 t; sub.cc.u32 t, %1, %2; subc.cc.u32 t, %3, %1; subc.u32 %0, t, %2; }",
    carried(a, b, c, -1), "r"(a), "r"(b), "r"(c)));
  out(LONG("{ .reg .u64 t; mad.lo.cc.u64 t, %1, %2, %2; madc.hi.u64 %0, %1, %2, t; }",
    highAndLow((unsigned __int128)l * k, k),
    "l"(l), "l"(k)));
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
  struct { double x, y; } d;
  struct { int x, y, z, w; } i;
  struct { unsigned short x, y, z, w; } s;
  struct { signed char x, y, z, w; } c;
  struct { float x, y, z, w; } f;
  memcpy(&d, in.d + 2, 16);
  memcpy(&i, in.i, 16);
  memcpy(&s, in.l, 8);
  memcpy(&c, in.l + 1, 4);
  memcpy(&f, in.f, 16);
#endif
  out(d.x - d.y); out(U32(i.x) * i.y + i.z - i.w); out(s.x * s.y - s.z + s.w);
  out(c.x * c.y + c.z - c.w); out((f.x + f.y) * (f.z - f.w));
}

template <class T>
HD T exchanged(T* place, T x, int how) // atomically; what was there
{
#ifdef __CUDA_ARCH__
  return how == 0 ? atomicMin(place, x) : how == 1 ? atomicMax(place, x)
    : how == 2 ? atomicExch(place, x) : how == 3 ? atomicOr(place, x)
    : how == 4 ? atomicAnd(place, x) : how == 5 ? atomicXor(place, x)
    : how == 6 ? atomicCAS(place, T(x & 3), x) : atomicAdd(place, x);
#else
  const T old = *place;
  *place = how == 0 ? (x < old ? x : old) : how == 1 ? (x > old ? x : old) : how == 2 ? x
    : how == 3 ? old | x : how == 4 ? old & x : how == 5 ? old ^ x
    : how == 6 ? (old == T(x & 3) ? x : old) : T(U64(old) + U64(x));
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
  out(atomicInc(turns, limit)); out(atomicDec(turns + 1, limit));
#else
  out(turns[0]); out(turns[1]);
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
  out(__popc(mask)); out(__shfl_sync(mask, in.i[0], __ffs(mask) - 1));
  out(__ballot_sync(mask, in.i[0] > 0) != 0); __syncwarp(mask);
#else
  out(*sum); *sum += finite;
  out(1); out(in.i[0]); out(in.i[0] > 0);
#endif
  *mailbox = *mailbox + in.l[0] % 1000;
}

#define KERNELS(X) X(doubles) X(floats) X(exponents) X(integers) X(wide) X(calls) X(arrays) \
  X(branches) X(conversions) X(bits) X(vectors) X(atomics)
#ifdef __CUDACC__
#define KERNEL(name) \
  __global__ void name##Kernel(const Settings settings, const Input* in, U64* out, int n) \
  { \
    const int i = blockIdx.x * blockDim.x + threadIdx.x; \
    if (i < n) { name(settings, in[i], Sink{ out + Places * i }); } \
  }
KERNELS(KERNEL)
#endif
"""

MAIN = r"""
#include "kernels.cu"
#include <cstdio>
#include <random>
#include <string>
#include <vector>

namespace ptx
{
struct Launch { unsigned blockIndex, blockCount, threadIndex, threadCount; };
using Kernel = void (*)(const void* const* parameters, const Launch& launch);
Kernel find(const char* demangledName);
const char* const* names();
}

int main()
{
  const double special[] = { 0., -0., 1, -1, 0.5, 1.5, -2.5, 3, NAN, INFINITY, -INFINITY, 5e-324,
    -1e-310, 1e308, -1.7e308, 2147483647., 2147483648.5, -2147483648., -2147483649., 4294967295.,
    4294967296., 9223372036854775807., -9223372036854775808., 18446744073709551615., 1e-40, 3e38 };
  const S64 whole[] = { 0, 1, -1, 2, 3, 31, 32, 33, 63, 64, 127, 255, INT32_MAX, INT32_MIN,
    INT64_MAX, INT64_MIN, 0x80000000, 0xffffffff, 0x100000000 };
  std::mt19937_64 random(1);
  const int n = 4000;
  std::vector<Input> in(n);
  for (Input& x : in)
  {
    for (int k = 0; k < 4; ++k)
    {
      const U64 a = random(), b = random();
      const int range = a & 2 ? 1100 : 80;
      x.d[k] = a & 1 ? special[b % 26] : std::ldexp(double(S64(b)), int(a >> 8) % range);
      x.f[k] = a & 4 ? special[a / 8 % 26] : std::ldexp(double(S64(a)), int(b >> 8) % 80 - 63);
      x.l[k] = a & 8 ? whole[a / 64 % 19] : S64(random()) >> (a / 64 % 64);
      x.i[k] = int(a & 16 ? whole[b / 64 % 19] : S64(random()) >> (a / 64 % 64));
    }
  }
  int failures = 0;
  const auto check = [&](const char* name, void (*host)(const Settings&, const Input&, Sink))
  {
    std::vector<S64> counters[2] = { std::vector<S64>(32, 0), std::vector<S64>(32, 0) };
    std::vector<U64> out[2];
    Settings settings = { {}, nullptr, { 1, -2, 3, -4, 5 }, 'x' };
    for (int k = 0; k < 20; ++k) { settings.scale[k] = k * 0.75 - 2; }
    const std::string full =
      std::string(name) + "Kernel(Settings, Input const*, unsigned long long*, int)";
    const ptx::Kernel kernel = ptx::find(full.c_str());
    for (int side = 0; side < 2; ++side)
    {
      out[side].resize(n * Places);
      settings.counters = counters[side].data();
      const Input* const inputs = in.data();
      U64* const outputs = out[side].data();
      const void* const parameters[] = { &settings, &inputs, &outputs, &n };
      for (unsigned i = 0; i < n + 96u && (side == 0 || kernel); ++i)
      {
        if (side == 1) { kernel(parameters, { i / 128, (n + 127u) / 128, i % 128, 128 }); }
        else if (i < n) { host(settings, in[i], Sink{ outputs + Places * i }); }
      }
    }
    int wrong = counters[0] != counters[1];
    for (int i = 0; i < n * Places; ++i)
    {
      if (out[0][i] != out[1][i] && ++wrong < 6)
      {
        std::printf("  input %d, place %d: %llx %llx\n", i / Places, i % Places, out[0][i],
          out[1][i]);
      }
    }
    std::printf("%s: %s\n", name, kernel ? wrong ? "differs" : "same" : "missing");
    failures += wrong || !kernel;
  };
#define CHECK(name) check(#name, name);
  KERNELS(CHECK)
  int count = 0;
  while (ptx::names()[count]) { ++count; }
  std::printf("%d entries\n", count);
  return failures != 0 || ptx::find("no such kernel");
}
"""

REFUSED = """.version 7.0
.target sm_75
.address_size 64
.visible .entry kernel(.param .u64 kernel_param_0)
{
  .reg .f64 %fd<3>;
  .reg .pred %p<2>;
  .reg .b32 %r<3>;
  // line 9
  INSTRUCTION
  ret;
}
"""


def find_nvcc():
    candidates = [os.environ.get("NVCC"), shutil.which("nvcc"), "/usr/local/cuda/bin/nvcc"]
    return next((path for path in candidates if path and pathlib.Path(path).exists()), None)


def run(*command, **settings):
    return subprocess.run([str(word) for word in command], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, universal_newlines=True, **settings)


class TestRefusal(unittest.TestCase):
    """What cannot be translated exactly must stop the translation."""

    def translate(self, instruction):
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder, "input.ptx")
            source.write_text(REFUSED.replace("INSTRUCTION", instruction))
            output = pathlib.Path(folder, "out.cxx")
            result = run(sys.executable, TRANSLATOR, source, "-o", output)
            return result.returncode, result.stdout, output.exists()

    def test_known(self):
        result = self.translate("add.rn.f64 %fd1, %fd1, 0d3FF0000000000000;")
        self.assertEqual(result, (0, "", True))

    def test_refused(self):
        for instruction in ("sin.approx.f32 %r1, %r2;", "add.rz.f64 %fd1, %fd1, %fd2;",
                            "add.f64 %fd1, %fd1, %fd2;", "rcp.approx.ftz.f64 %fd1, %fd2;",
                            "bar.sync 0;", "mov.u32 %r1, %clock;", "ld.shared.u32 %r1, [%r2];",
                            "add.s32 %r1, %r2;", "mov.u32 %r1, %fd1;", "mov.u32 %r1, %r9x;",
                            "cvt.rz.f32.f64 %r1, %fd1;", "setp.lt.b32 %p1, %r1, %fd2;",
                            "call.uni nowhere;", ".shared .b8 memory[4];"):
            with self.subTest(instruction):
                code, message, is_written = self.translate(instruction)
                self.assertNotEqual(code, 0)
                self.assertIn(f"input.ptx:10: refused '{instruction[:-1]}", message)
                self.assertFalse(is_written)


@unittest.skipUnless(find_nvcc(), "no nvcc: set NVCC, or have it in PATH")
class TestTranslation(unittest.TestCase):
    """The same bits as the host's."""

    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name)
        (cls.folder / "kernels.cu").write_text(SOURCE)
        (cls.folder / "main.cxx").write_text(MAIN)
        cls.must("nvcc", find_nvcc(), "-ptx", "-fmad=false", "-std=c++17", "-O3",
                 "-arch=compute_75", "kernels.cu", "-o", "kernels.ptx")
        cls.must("main", *cls.compiler(), "-c", "main.cxx", "-o", "main.o")
        cls.must("translation", sys.executable, TRANSLATOR, "kernels.ptx", "-o", "kernels.cxx")

    @classmethod
    def compiler(cls):
        return os.environ.get("CXX", "g++"), "-std=c++17", "-O1", "-ffp-contract=off"

    @classmethod
    def must(cls, what, *command):
        result = run(*command, cwd=cls.folder)
        if result.returncode:
            raise AssertionError(f"{what} fails:\n{result.stdout}")

    def outcome(self, *sources):
        objects = [source + ".o" for source in sources]
        for source, result in zip(sources, objects):
            self.must("compilation", *self.compiler(), "-c", source, "-o", result)
        self.must("linking", *self.compiler(), "main.o", *objects, "-o", "program")
        return run("./program", cwd=self.folder)

    def test_same(self):
        result = self.outcome("kernels.cxx")
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertIn("12 entries", result.stdout)

    def test_split(self):
        self.must("translation", sys.executable, TRANSLATOR, "kernels.ptx", "-o", "part.cxx",
                  "--split", "3")
        result = self.outcome("part_0.cxx", "part_1.cxx", "part_2.cxx")
        self.assertEqual(result.returncode, 0, result.stdout)

    def test_wrong_translations_are_noticed(self):
        text = (self.folder / "kernels.cxx").read_text()
        begin = text.index("  (void)launch;")  # behind the preamble
        for kind, before, after in (
                ("a difference of floats", r"(\bfd\d+ = .*) - ", r"\1 + "),
                ("a bitwise operation", r"= U64\((rd\d+) \^ (rd\d+)\)", r"= U64(\1 | \2)"),
                ("an fma", r"\bfused\((fd\d+), (fd\d+), (fd\d+)\)", r"(\1 * \2 + \3)"),
                ("a shift", r"shiftRight<S32>", "shiftRight<U32>"),
                ("an atomic operation", r"atomicMin<U64", "atomicMax<U64")):
            with self.subTest(kind):
                changed, count = re.subn(before, after, text[begin:], 1)
                self.assertEqual(count, 1)
                (self.folder / "wrong.cxx").write_text(text[:begin] + changed)
                result = self.outcome("wrong.cxx")
                self.assertNotEqual(result.returncode, 0)
                self.assertIn(": differs", result.stdout)


if __name__ == "__main__":
    unittest.main()
