// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFFailure.h"

#include "FFExactValues.h"

#include <flipflop/Engines.h>
#include <flipflop/Error.h>
#include <flipflop/Weights.h>

#include <cctype>
#include <cstring>
#include <exception>
#include <iterator>
#include <new>
#include <sstream>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

std::string capitalized(std::string text)
{
  text[0] = static_cast<char>(std::toupper(text[0]));
  return text;
}

/// The sentence and the code for an error of the engine: with its {index} and {count}, its {text},
/// and {of} which data set.
struct ErrorText
{
  flipflop::ErrorCode Code;
  unsigned long Id;
  const char* Text;
};

using flipflop::ErrorCode;
constexpr ErrorText errorTexts[] = {
  { ErrorCode::TooManyPoints, vtkFFErrorCode::MemoryError,
    "{count} points are more than 32-bit indices can name." },
  { ErrorCode::OutOfMemory, vtkFFErrorCode::MemoryError,
    "There is not enough memory for this input: {count} bytes were refused." },
  { ErrorCode::BadArgument, vtkFFErrorCode::InputError, "The engine refuses an argument: {text}." },
  { ErrorCode::WeightCount, vtkFFErrorCode::InputError,
    "There are not as many weights as points: {count} for {index}." },
  { ErrorCode::BadTriangle, vtkFFErrorCode::SurfaceError,
    "A cell names a point that does not exist, or the same point twice: first at cell {index}{of}, "
    "{count} such cell(s) in all." },
  { ErrorCode::NotSimple, vtkFFErrorCode::SurfaceError,
    "A polygon crosses or touches itself, so it cannot be cut into triangles: first at cell "
    "{index}{of}, {count} such polygon(s) in all." },
  { ErrorCode::NotClosed, vtkFFErrorCode::SurfaceError,
    "The surface is not closed: first at cell {index}{of}, which has an edge that no other "
    "triangle shares; {count} such edge(s) in all." },
  { ErrorCode::NotManifold, vtkFFErrorCode::SurfaceError,
    "The surface is not a manifold: first at cell {index}{of}, which has an edge of three or more "
    "triangles, or a vertex where several fans of triangles meet; {count} such edge(s) and "
    "vertices in all." },
  { ErrorCode::NotOriented, vtkFFErrorCode::SurfaceError,
    "The surface is not oriented consistently: first at cell {index}{of}, whose neighbour runs "
    "their shared edge the same way. Generate Surface Normals (vtkPolyDataNormals) can mend that, "
    "with Consistency on." },
  { ErrorCode::NotStarShaped, vtkFFErrorCode::SurfaceError,
    "The surface is not star-shaped: the kernel point does not see the inside of cell "
    "{index}{of}; {count} such triangle(s) in all." },
  { ErrorCode::NoKernel, vtkFFErrorCode::SurfaceError,
    "The surface{of} is not star-shaped, or no point was found from which it is. If you know one, "
    "turn on Use Kernel Point, and give it as Kernel Point." },
  { ErrorCode::ConstraintPoint, vtkFFErrorCode::ConstraintError,
    "Constraint {index} ends at point {count}{of}, which is not there or is left out." },
  { ErrorCode::ConstraintsCross, vtkFFErrorCode::ConstraintError,
    "Constraint {index} crosses constraint {count}, and there is no point where they do. Add one, "
    "and end or begin both there." },
  { ErrorCode::PolygonsDisagree, vtkFFErrorCode::ConstraintError,
    "The polygons disagree about what is inside: what is on the left of a side is inside, and "
    "holes run clockwise. Reverse the polygon of constraint {index}, which disagrees with that of "
    "constraint {count}." },
  { ErrorCode::NotConvex, vtkFFErrorCode::InputError,
    "The domain is no convex polygon with finite corners, counter-clockwise." },
  { ErrorCode::DuplicateSites, vtkFFErrorCode::InputError,
    "The points {index} and {count}{of} are at one position, so their cells cannot have prescribed "
    "areas." },
  { ErrorCode::BadArea, vtkFFErrorCode::InputError,
    "A prescribed area is not positive and finite: first at point {index}{of}, {count} such "
    "point(s) in all." },
  { ErrorCode::NoDevice, vtkFFErrorCode::DeviceError,
    "The CUDA engine was asked for, but {text}. Set Engine to Automatic or CPU." },
  { ErrorCode::DeviceMemory, vtkFFErrorCode::DeviceError,
    "The CUDA device has not enough memory for this input: {count} bytes were refused. Set Engine "
    "to Automatic or CPU." },
  { ErrorCode::DeviceFailed, vtkFFErrorCode::DeviceError,
    "The CUDA device failed: error {index} of the CUDA runtime. Set Engine to Automatic or CPU." },
  { ErrorCode::Internal, vtkFFErrorCode::InternalError,
    "An internal error: please report it, with the input." },
};

constexpr const char* noMemory = "There is not enough memory for this input.";

/// The failure that an error of the engine is; @p of says which data set has it.
FFFailure failureOf(const flipflop::Error& error, const std::string& of)
{
  FFFailure failure;
  const auto* const found = std::find_if(std::begin(errorTexts), std::end(errorTexts),
    [&](const ErrorText& text) { return text.Code == error.code(); });
  if (found == std::end(errorTexts))
  {
    failure.Say(error.what());
    return failure;
  }
  const std::pair<const char*, std::string> parts[] = { { "{index}",
                                                          std::to_string(error.index()) },
    { "{count}", std::to_string(error.count()) }, { "{of}", of },
    { "{text}",
      error.code() == ErrorCode::NoDevice ? flipflop::cudaStatus().problem : error.what() } };
  std::string message = found->Text;
  for (const auto& [name, value] : parts)
  {
    const std::size_t begin = message.find(name);
    if (begin != std::string::npos)
    {
      message.replace(begin, std::strlen(name), value);
    }
  }
  failure.Say(message, found->Id);
  return failure;
}

}

//------------------------------------------------------------------------------
FFFailure FFFailure::OfException(const std::function<vtkIdType(vtkIdType)>& idOf,
  const std::function<std::string(vtkIdType)>& where, const std::string& of)
{
  FFFailure failure;
  const auto pointAt = [&](auto index) { return where(idOf(static_cast<vtkIdType>(index))); };
  try
  {
    throw;
  }
  catch (const flipflop::BadWeight& error)
  {
    failure.Say(capitalized(error.what()) + ": first at " + pointAt(error.index()) +
      (error.fault() == flipflop::BadWeight::Fault::NegativeRadius
          ? ". Radii are lengths. If the array has weights, which may be negative, set Weight Mode "
            "to Weights."
          : ". Use another unit of length, or a smaller factor."));
  }
  catch (const flipflop::Error& error)
  {
    if (error.code() == ErrorCode::NonFinite)
    {
      failure.Kind = NonFinite;
      failure.Point = idOf(static_cast<vtkIdType>(error.index()));
      failure.Count = static_cast<vtkIdType>(error.count());
    }
    else if (error.code() == ErrorCode::Aborted)
    {
      failure.Kind = Aborted;
    }
    else if (error.code() == ErrorCode::OutOfMemory && error.count() <= 0)
    {
      failure.Say(noMemory, vtkFFErrorCode::MemoryError);
    }
    else
    {
      failure = failureOf(error, of);
    }
  }
  catch (const FFInexactValue& error)
  {
    const std::string kind = error.GetKind();
    failure.Say("A " + kind + " is a 64-bit integer that no double holds: first at " +
      pointAt(error.GetIndex()) +
      // Other disks have other radii, but weights may be shifted.
      (kind == "radius"
          ? ". Round the radii to doubles."
          : ". Subtract an offset from every " + kind + ": the result has the same shape."));
  }
  catch (const FFBadSetting& error)
  {
    failure.Say(error.what(), vtkFFErrorCode::SettingError);
  }
  catch (const FFBadConstraint& error)
  {
    failure.Say(error.what(), vtkFFErrorCode::ConstraintError);
  }
  catch (const std::bad_alloc&)
  {
    failure.Say(noMemory, vtkFFErrorCode::MemoryError);
  }
  catch (const std::exception& error)
  {
    failure.Say(error.what());
  }
  catch (...)
  {
    failure.Say("The engine failed for an unknown reason.", vtkFFErrorCode::InternalError);
  }
  return failure;
}

//------------------------------------------------------------------------------
void FFFailure::CheckLength(double length, const char* name, const char* zero)
{
  if (!(length >= 0.0))
  {
    std::ostringstream message;
    message << name << " is " << length << "; it must be a length, or 0 for " << zero << ".";
    throw FFBadSetting(message.str());
  }
}
VTK_ABI_NAMESPACE_END
