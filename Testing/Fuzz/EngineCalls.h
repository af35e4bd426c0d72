// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The calls that the engine's fuzzer chooses from. Each draws its arguments, and demands that what
/// comes out is what is promised.
#ifndef flipflop_fuzz_EngineCalls_h
#define flipflop_fuzz_EngineCalls_h

#include "Bytes.h"

#include <flipflop/CellComplex.h>

namespace flipflop
{
namespace fuzz
{

void fuzzHull(Bytes& bytes);
void fuzzTriangulation(Bytes& bytes);
void fuzzPowerDiagram(Bytes& bytes); ///< of triangulations, and of what is none
void fuzzFlipFlop(Bytes& bytes);     ///< of star-shaped surfaces, and of any triangles
void fuzzPolygons(Bytes& bytes);     ///< any polygons, to be cut into triangles
void fuzzHullJudge(Bytes& bytes);    ///< validate, of answers that are wrong
void fuzzTriangulationJudge(Bytes& bytes);
void fuzzArguments(Bytes& bytes);            ///< null, negative, too many
void fuzzHullQueries(Bytes& bytes);          ///< of hulls, and of what is none
void fuzzTriangulationQueries(Bytes& bytes); ///< of triangulations, and of what is none
void fuzzConstraints(Bytes& bytes); ///< and polygons of them, and where they cross, in pieces
void fuzzAlpha(Bytes& bytes);       ///< alpha complexes, and borders of them and of what is none
void fuzzDomains(Bytes& bytes);     ///< power diagrams in boxes and polygons
void fuzzCentroidal(Bytes& bytes);  ///< sites that move
void fuzzPrescribed(Bytes& bytes);  ///< areas that are met, or not

/// Change one number in some of a result's parts.
/// @param hidden a triangulation's; null: a hull's
void corrupt(Bytes& bytes, CellComplex& cells, Buffer<std::int64_t>* hidden);

}
}

#endif
