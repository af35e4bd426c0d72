// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What filters say of the engine's errors: for the compiled classes and for those in Python, so
 * without VTK.
 */

#ifndef FFErrorTexts_h
#define FFErrorTexts_h

#include <flipflop/Error.h>

/// As vtkFFErrorCode, less vtkErrorCode::UserError.
enum class FFErrorKind
{
  Setting = 1,
  Input,
  NonFinite,
  Surface,
  Constraint,
  Memory,
  Device,
  Process,
  Internal
};

/// The sentence and the kind for an error of the engine: with its {index} and {count}, its {text},
/// and {of} which data set.
struct FFErrorText
{
  flipflop::ErrorCode Code;
  FFErrorKind Kind;
  const char* Text;
};

constexpr FFErrorText FFErrorTexts[] = {
  { flipflop::ErrorCode::TooManyPoints, FFErrorKind::Memory,
    "{count} points are more than 32-bit indices can name." },
  { flipflop::ErrorCode::OutOfMemory, FFErrorKind::Memory,
    "There is not enough memory for this input: {count} bytes were refused." },
  { flipflop::ErrorCode::BadArgument, FFErrorKind::Input,
    "The engine refuses an argument: {text}." },
  { flipflop::ErrorCode::WeightCount, FFErrorKind::Input,
    "There are not as many weights as points: {count} for {index}." },
  { flipflop::ErrorCode::BadTriangle, FFErrorKind::Surface,
    "A cell names a point that does not exist, or the same point twice: first at cell {index}{of}, "
    "{count} such cell(s) in all." },
  { flipflop::ErrorCode::NotSimple, FFErrorKind::Surface,
    "A polygon crosses or touches itself, so it cannot be cut into triangles: first at cell "
    "{index}{of}, {count} such polygon(s) in all." },
  { flipflop::ErrorCode::NotClosed, FFErrorKind::Surface,
    "The surface is not closed: first at cell {index}{of}, which has an edge that no other "
    "triangle shares; {count} such edge(s) in all." },
  { flipflop::ErrorCode::NotManifold, FFErrorKind::Surface,
    "The surface is not a manifold: first at cell {index}{of}, which has an edge of three or more "
    "triangles, or a vertex where several fans of triangles meet; {count} such edge(s) and "
    "vertices in all." },
  { flipflop::ErrorCode::NotOriented, FFErrorKind::Surface,
    "The surface is not oriented consistently: first at cell {index}{of}, whose neighbour runs "
    "their shared edge the same way. Generate Surface Normals (vtkPolyDataNormals) can mend that, "
    "with Consistency on." },
  { flipflop::ErrorCode::NotStarShaped, FFErrorKind::Surface,
    "The surface is not star-shaped: the kernel point does not see the inside of cell "
    "{index}{of}; {count} such triangle(s) in all." },
  { flipflop::ErrorCode::NoKernel, FFErrorKind::Surface,
    "The surface{of} is not star-shaped, or no point was found from which it is. If you know one, "
    "turn on Use Kernel Point, and give it as Kernel Point." },
  { flipflop::ErrorCode::ConstraintPoint, FFErrorKind::Constraint,
    "Constraint {index} ends at point {count}{of}, which is not there or is left out." },
  { flipflop::ErrorCode::ConstraintsCross, FFErrorKind::Constraint,
    "Constraint {index} crosses constraint {count}, and there is no point where they do. Add one, "
    "and end or begin both there." },
  { flipflop::ErrorCode::PolygonsDisagree, FFErrorKind::Constraint,
    "The polygons disagree about what is inside: what is on the left of a side is inside, and "
    "holes run clockwise. Reverse the polygon of constraint {index}, which disagrees with that of "
    "constraint {count}." },
  { flipflop::ErrorCode::NotConvex, FFErrorKind::Input,
    "The domain is no convex polygon with finite corners, counter-clockwise." },
  { flipflop::ErrorCode::DuplicateSites, FFErrorKind::Input,
    "The points {index} and {count}{of} are at one position, so their cells cannot have prescribed "
    "areas." },
  { flipflop::ErrorCode::BadArea, FFErrorKind::Input,
    "A prescribed area is not positive and finite: first at point {index}{of}, {count} such "
    "point(s) in all." },
  { flipflop::ErrorCode::NoDevice, FFErrorKind::Device,
    "The CUDA engine was asked for, but {text}. Set Engine to Automatic or CPU." },
  { flipflop::ErrorCode::DeviceMemory, FFErrorKind::Device,
    "The CUDA device has not enough memory for this input: {count} bytes were refused. Set Engine "
    "to Automatic or CPU." },
  { flipflop::ErrorCode::DeviceFailed, FFErrorKind::Device,
    "The CUDA device failed: error {index} of the CUDA runtime. Set Engine to Automatic or CPU." },
  { flipflop::ErrorCode::Internal, FFErrorKind::Internal,
    "An internal error: please report it, with the input." },
};

#endif
