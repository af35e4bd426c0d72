// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFErrorCode
 * @brief   why a Flip-Flop filter gave no result
 *
 * vtkFFErrorCode has the values of GetErrorCode() after a run of a Flip-Flop filter, in VTK's range
 * for users' codes. The rest is in the message of the error.
 */

#ifndef vtkFFErrorCode_h
#define vtkFFErrorCode_h

#include "vtkErrorCode.h"
#include "vtkFFMarks.h"

VTK_ABI_NAMESPACE_BEGIN
struct vtkFFErrorCode
{
  enum ErrorIds
  {
    NoError = vtkErrorCode::NoError,
    SettingError = vtkErrorCode::UserError + 1, ///< settings that do not go together
    InputError,      ///< data that the filter cannot work on: types, arrays, numbers of values
    NonFiniteError,  ///< a coordinate or a weight is NaN or infinite
    SurfaceError,    ///< a surface that is not closed, not a manifold, not star-shaped
    ConstraintError, ///< constraints that cross, or whose polygons disagree
    MemoryError,     ///< not enough memory, or more points than the engine takes
    DeviceError,     ///< the CUDA engine was asked for, and there is none or it failed
    ProcessError,    ///< another process, or the data that it sent
    InternalError    ///< a fault of the filter: please report it
  };
};
VTK_ABI_NAMESPACE_END

#endif
