// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The engine's public calls with any arguments that callers can make: an error of the type and
/// code that is promised, or a result that is right, and the same on any number of threads.
#include "EngineCalls.h"

#include <iterator>
#include <thread>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

using namespace flipflop::fuzz;

void oneCall(Bytes bytes)
{
  static constexpr void (*calls[])(Bytes&) = { fuzzHull, fuzzTriangulation, fuzzDiagram,
    fuzzConvexify, fuzzHullClaims, fuzzTriangulationClaims, fuzzArguments, fuzzHullQueries,
    fuzzTriangulationQueries, fuzzPolygons, fuzzConstraints, fuzzCells, fuzzDiagram, fuzzCentroidal,
    fuzzPrescribed, fuzzEdits, fuzzHalfSpaces, fuzzFurthestSite };
  calls[bytes.below(static_cast<int>(std::size(calls)))](bytes);
}

}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Bytes bytes(data, size);
  if (bytes.oneOf(8))
  {
    std::thread other(oneCall, bytes);
    oneCall(bytes);
    other.join();
  }
  else
  {
    oneCall(bytes);
  }
  return 0;
}
