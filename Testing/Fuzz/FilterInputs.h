// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Data objects of all kinds from a few bytes: data sets with points in arrays of any type and
/// layout, cells, point data of any length, and composites with holes.
#ifndef flipflop_fuzz_FilterInputs_h
#define flipflop_fuzz_FilterInputs_h

#include "Bytes.h"

#include "vtkSmartPointer.h"

class vtkDataObject;

namespace flipflop
{
namespace fuzz
{

/// @param most points at most in each data set
vtkSmartPointer<vtkDataObject> drawDataObject(Bytes& bytes, int most);

/// A name that arrays of data objects often have; now and then one that none has.
const char* drawArrayName(Bytes& bytes);

}
}

#endif
