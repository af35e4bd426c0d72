// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Code for host and device alike, first part: numbers, calls, memory and branches.
#ifndef flipflop_test_translated_numbers_h
#define flipflop_test_translated_numbers_h

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
struct alignas(16) Input
{
  double d[4];
  S64 l[4];
  float f[4];
  int i[4];
};
struct Settings
{
  double scale[20];
  S64* counters;
  short shorts[5];
  char last;
};

struct Sink
{
  U64* place;
  HD void bits(U64 x) { *this->place++ = x; }
  HD void operator()(S64 x) { this->bits(x); }
  HD void operator()(U64 x) { this->bits(x); }
  HD void operator()(int x) { this->bits(x); }
  HD void operator()(U32 x) { this->bits(x); }
  HD void operator()(bool x) { this->bits(x); }
  HD void operator()(unsigned __int128 x)
  {
    this->bits(x);
    this->bits(x >> 64);
  }
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
  out(a + b);
  out(a - b);
  out(a * b);
  out(a / b);
  out(1 / a);
  out(a * b + c);
  out(std::fma(a, b, c));
  out(std::sqrt(a));
  out(-a);
  out(std::fabs(a));
  out(std::copysign(a, b));
  out(std::floor(a));
  out(std::ceil(a));
  out(std::trunc(a));
  out(std::rint(a));
  out(a < b);
  out(a <= b);
  out(a > b);
  out(a >= b);
  out(a == b);
  out(a != b);
  out(!(a < b));
  out(!(a <= b));
  out(!(a > b));
  out(!(a >= b));
  out(std::isnan(a));
  out(a < b && c < a);
  out(a < b || !(c < a));
  out(a > b ? b : a);
}
HD void doubles(const Settings&, const Input& in, Sink out)
{
  arithmeticOf(in.d, out);
}
HD void floats(const Settings&, const Input& in, Sink out)
{
  arithmeticOf(in.f, out);
}

HD void exponents(const Settings& settings, const Input& in, Sink out)
{
  const double x = in.d[0];
  out(ldexp(x, in.i[0] % 2200));
  out(ldexp(x, in.i[1] % 64));
  out(scalbnf(in.f[0], in.i[2] % 300));
  const bool isOrdinary = x != 0 && std::fabs(x) <= 1.7e308;
  out(isOrdinary ? ilogb(x) : 0);
  int exponent = 0;
  out(isOrdinary ? frexp(x, &exponent) : 0);
  out(exponent);
  out(fmod(in.d[1], settings.scale[3]));
  out(fmin(x, in.d[1]) + 0.);
  out(fmax(in.d[1], x) + 0.);
}

HD void integers(const Settings&, const Input& in, Sink out)
{
  const int a = in.i[0], b = in.i[1];
  const U32 ua = a, ub = b;
  const S64 l = in.l[0], m = in.l[1];
  const U64 ul = l, um = m;
  out(ua + ub);
  out(ua - ub);
  out(ua * ub);
  out(S64(a) * b);
  out(U64(ua) * ub);
  out(int(ua * ub + U32(in.i[2])));
  out(l > -99 && b > 9 ? l / b : m);
  out(b ? ua / ub : 7u);
  out(b > 0 ? a / b : 1);
  out(b > 0 ? a % b : 1);
  out(m ? ul % um : 0);
  out(m > 0 ? l % m : 1);
  out(a < b ? a : b);
  out(ua > ub ? ua : ub);
  out(l > m ? l : m);
  out(a < 0 ? -ua : ua);
  out(a >> (b & 31));
  out(ua >> (b & 31));
  out(ul << (m & 63));
  out(l >> (m & 63));
  out(~a & b);
  out(ul ^ (um | 12345));
  out(int(short(a)) * short(b));
  out(U32(uint16_t(a * 3)));
  out(int(int8_t(b)));
  out(S64(int8_t(m)));
}

HD void wide(const Settings&, const Input& in, Sink out)
{
  using U128 = unsigned __int128;
  const __int128 a = __int128(in.l[0]) * in.l[1], b = __int128(in.l[2]) << (in.i[0] & 63);
  const U128 c = U128(U64(in.l[0])) * U64(in.l[3]), d = U128(a) * U128(b);
  out(U128(a));
  out(U128(b));
  out(c);
  out(d);
  out(c + d);
  out(c - d);
  out(a < b);
  out(c < d);
  out(U128(a >> (in.i[1] & 127)));
  out(c >> (in.i[2] & 127));
  out(c << (in.i[3] & 127));
  out(-c);
  out(U64(c >> 64) * 3 + U64(c));
  out(a == b);
  out(c ^ d);
}

struct Packet
{
  double x[3];
  int number;
  signed char mark;
};
HD APART Packet mix(Packet a, const Packet b, int turn)
{
  for (int i = 0; i < 3; ++i)
  {
    a.x[i] += b.x[(turn + i) & 1];
  }
  a.number ^= b.number + turn;
  a.mark = a.mark * b.mark;
  return a;
}
HD APART float narrow(float x, bool up, short by, signed char also)
{
  return up ? x + by : x - also;
}
HD APART void swap(double* a, double* b)
{
  const double c = *a;
  *a = *b;
  *b = c;
}
HD void calls(const Settings& settings, const Input& in, Sink out)
{
  Packet a = { { in.d[0], in.d[1], in.d[2] }, in.i[0], (signed char)in.i[1] };
  const Packet b = mix(a, Packet{ { 1, in.d[3], 2 }, in.i[2], settings.last }, in.i[3]);
  a = mix(b, a, 5);
  swap(&a.x[in.i[0] & 1], &a.x[2]);
  for (int i = 0; i < 3; ++i)
  {
    out(a.x[i]);
    out(b.x[i]);
  }
  out(a.number);
  out(b.number);
  out(int(a.mark));
  out(int(b.mark));
  out(narrow(in.f[0], in.i[0] & 1, settings.shorts[in.i[1] & 3], settings.last));
}

DATA int ints[4] = { 5, 6, -7, 8 };
DATA int* const pointers[3] = { ints + 3, ints, ints + 2 };
DATA const double factors[5] = { 1.5, -2, 1e300, 0, 5e-324 };
DATA signed char marks[7] = { 1, -2, 3, -4, 5, -128, 127 };
HD void arrays(const Settings& settings, const Input& in, Sink out)
{
  int local[32];
  for (int i = 0; i < 32; ++i)
  {
    local[i] = in.i[i & 3] >> (i & 7);
  }
  for (int i = 0; i < 64; ++i)
  {
    local[local[i & 31] & 31] ^= local[(i * 7 + in.i[0]) & 31] + i;
  }
  U32 sum = 0;
  for (int i = 0; i < 32; ++i)
  {
    sum = sum * 31 + local[i];
  }
  out(sum);
  out(local[in.i[1] & 31]);
  out(settings.scale[U32(in.i[2]) % 20]);
#if defined(__CUDA_ARCH__) || !defined(__CUDACC__) // these data are the device's
  out(*pointers[U32(in.i[3]) % 3]);
  out(factors[U32(in.i[0]) % 5] * in.d[0]);
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
      "D: mov.b32 %0, -9;\n E: selp.b32 %0, %0, 5, q;\n}"
      : "=r"(y)
      : "r"(by), "r"(x));
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
    case 0:
      x ^= in.i[2];
      break;
    case 1:
      x = in.i[3] >> 3; // and on
    case 2:
      x |= 64;
      break;
    case 3:
      x &= in.i[2];
      break;
    case 4:
      x = ~x;
      break;
    case 7:
      x = in.f[0] > 1 ? 9 : 8;
      break;
    case 9:
    case 10:
      x = 4;
      break;
    case 12:
      out(in.d[0]);
      break;
    default:
      x = 77;
  }
  out(x);
  out(jump(in.i[0] & 3, x));
  U64 a = U64(in.l[0]), steps = 0; // a loop that ends when the data say so
  while (a > 1 && steps < 90)
  {
    a = a & 1 ? a / 3 : a / 2;
    ++steps;
  }
  out(a);
  out(steps);
}

template <class To, class From>
HD To converted(From x) // as the device does it
{
#ifdef __CUDA_ARCH__
  return static_cast<To>(x);
#else
  constexpr int digits = 8 * sizeof(To) - (To(-1) < To(0));
  const To highest = To(U64(-1) >> (64 - digits)), lowest = To(-1) < To(0) ? -highest - 1 : 0;
  if (x != x)
  {
    return sizeof(To) + sizeof(From) < 12 ? 0 : To(U64(1) << (8 * sizeof(To) - 1));
  }
  return x >= std::ldexp(1.0, digits) ? highest : x <= From(lowest) ? lowest : To(x);
#endif
}
HD void conversions(const Settings&, const Input& in, Sink out)
{
  const double x = in.d[0];
  const float f = in.f[0];
  out(converted<int>(x));
  out(converted<U32>(x));
  out(converted<S64>(x));
  out(converted<U64>(x));
  out(converted<int>(f));
  out(converted<U32>(f));
  out(converted<S64>(f));
  out(converted<U64>(f));
  out(float(x));
  out(double(f));
  out(float(in.l[0]));
  out(double(in.l[0]));
  out(float(U64(in.l[1])));
  out(double(U64(in.l[1])));
  out(double(in.i[0]));
  out(float(in.i[0]));
  out(float(U32(in.i[1])));
  out(float(short(in.i[2])));
  out(double(int8_t(in.i[3])));
  out(std::fabs(x) < 1e15 ? S64(std::floor(x)) : 0);
  out(std::fabs(f) < 1e6 ? S64(lrintf(f)) : 0);
}

#endif
