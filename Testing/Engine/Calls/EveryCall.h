// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The engine's public calls as rows of one table, for what all of them promise.
#ifndef flipflop_test_EveryCall_h
#define flipflop_test_EveryCall_h

#include "Testing/Engine/Calls/Bits.h"
#include "Testing/Engine/Conformance/CompareTriangulation.h"

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

/// What a call does with a point that is not finite.
enum class NonFinitePoint
{
  IsRefused,     ///< NonFinite, with the first such point and their count
  IsBadArgument, ///< BadArgument: a result of these points cannot be
  IsLeftOut,     ///< always
  IsNotRead      ///< the call has no points
};

struct Call
{
  const char* name;
  /// What the call is made with: (x, y, z), or (x, y, weight).
  Cloud cloud;
  bool planar;   ///< z is not read
  bool weighted; ///< the call has weights
  NonFinitePoint nonFinite;
  std::function<Bits(const PointView&, const WeightView&, const Options&)> run;

  Bits operator()(const Options& options) const;
  WeightView weights() const;

  friend void PrintTo(const Call& call, std::ostream* out) { *out << call.name; }
};

struct CallInputs
{
  Cloud body;
  Cloud shell;
  Cloud sites;      ///< (x, y, weight)
  double unit = 1;  ///< of the calls' other numbers; the sites fill [0, unit]^2
  int levels = 5;   ///< of the icosphere that is made convex
  int side = 50;    ///< of the grid whose lines are constraints
  int teeth = 4000; ///< of a comb, which is cut into triangles
};
std::vector<Call> callsOn(const CallInputs& inputs);

/// Points are floats, weights too.
const std::vector<Call>& everyCall();

/// A call with the cells of a triangulation of randomSites(20, 0, 11).
struct CallOnCells
{
  const char* name;
  std::function<void(const Cloud& sites, const Triangulation& cells)> run;

  friend void PrintTo(const CallOnCells& call, std::ostream* out) { *out << call.name; }
};
std::vector<CallOnCells> everyCallOnCells();

}
}

#endif
