// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFMarks
 * @brief   how VTK marks its classes, for versions that do not
 *
 * VTK 9.3 began to have its classes in a namespace that a build may name, VTK 9.4 to write and read
 * their state. Older versions have no such marks; here they are empty then.
 */

#ifndef vtkFFMarks_h
#define vtkFFMarks_h

#include "vtkType.h"          // For VTK_ABI_NAMESPACE_BEGIN
#include "vtkWrappingHints.h" // For VTK_MARSHALAUTO

#ifndef VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

#ifndef VTK_MARSHALAUTO
#define VTK_MARSHALAUTO
#define VTK_MARSHALEXCLUDE(reason)
#endif

#endif
