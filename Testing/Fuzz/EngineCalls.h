// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The calls that the engine's fuzzer chooses from. Each draws its arguments, and demands that what
/// comes out is what is promised: it is compared with the references of the engine's tests.
#ifndef flipflop_fuzz_EngineCalls_h
#define flipflop_fuzz_EngineCalls_h

#include "Bytes.h"

namespace flipflop
{
namespace fuzz
{

void fuzzHull(Bytes& bytes);
void fuzzTriangulation(Bytes& bytes);
void fuzzDiagram(Bytes& bytes);    ///< in boxes and polygons; of what is no triangulation, too
void fuzzConvexify(Bytes& bytes);  ///< star-shaped surfaces, and any triangles
void fuzzPolygons(Bytes& bytes);   ///< any polygons, to be cut into triangles
void fuzzHullClaims(Bytes& bytes); ///< validate, of results that are wrong
void fuzzTriangulationClaims(Bytes& bytes);
void fuzzArguments(Bytes& bytes);            ///< null, negative, too many
void fuzzHullQueries(Bytes& bytes);          ///< of hulls, and of what is none
void fuzzTriangulationQueries(Bytes& bytes); ///< of triangulations, and of what is none
void fuzzCells(Bytes& bytes);       ///< alphas, lengths, measures, borders; and of what is none
void fuzzConstraints(Bytes& bytes); ///< and polygons of them, and where they cross, in pieces
void fuzzEdits(Bytes& bytes);       ///< of points and constraints
void fuzzCentroidal(Bytes& bytes);  ///< sites that move
void fuzzPrescribed(Bytes& bytes);  ///< areas that are met, or not
void fuzzHalfSpaces(Bytes& bytes);  ///< bounded or not, flat, empty
void fuzzFurthestSite(Bytes& bytes);

}
}

#endif
