// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// VTK's arrays from a few bytes: any type, plain or one array a component.
#ifndef flipflop_fuzz_FilterArrays_h
#define flipflop_fuzz_FilterArrays_h

#include "Bytes.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkAbstractArray;
class vtkDataArray;

namespace flipflop
{
namespace fuzz
{

/// An array of numbers, all zero.
vtkSmartPointer<vtkDataArray> drawDataArray(Bytes& bytes, int components, vtkIdType tuples);

/// The value, or the nearest that the array's type has.
void setComponent(vtkDataArray* array, vtkIdType tuple, int component, double value);

/// Of numbers, strings or variants, some of its values drawn.
vtkSmartPointer<vtkAbstractArray> drawAnyArray(Bytes& bytes, vtkIdType tuples);

}
}

#endif
