// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The exception that the engine throws: a code, and what is at fault.
#ifndef flipflop_Error_h
#define flipflop_Error_h

#include <cstdint>
#include <exception>

namespace flipflop
{

/// What went wrong; and what index() and count() of the Error then mean.
enum class ErrorCode
{
  NonFinite, ///< index: first point with a NaN or infinite coordinate or weight; count: how many
  TooManyPoints, ///< count: points given (or left after culling); 32-bit indices end here
  OutOfMemory,   ///< count: bytes requested
  Aborted,       ///< the progress function requested it
  BadArgument,   ///< what() names the argument and what is allowed; index: where it is at fault,
                 ///< as a set of a batch, a site, a cell
  WeightCount,   ///< index: the number of points; count: the weights given, which are not as many
  BadTriangle, ///< index: first triangle with a corner out of range or used twice; count: how many
  NotSimple,   ///< index: first polygon that crosses or touches itself; count: how many
  NotClosed,   ///< index: first triangle with an edge that no other triangle shares; count: edges
  NotManifold, ///< index: first triangle with an edge of three or more triangles, or with a vertex
               ///< whose triangles form several fans; count: how many such edges and vertices
  NotOriented, ///< index: first triangle whose neighbour runs the shared edge the same way
  NotStarShaped,    ///< index: first triangle not seen from inside by the kernel point; count: how
                    ///< many
  NoKernel,         ///< no kernel point was given and none was found
  ConstraintPoint,  ///< index: first constraint with an end that is no point, or one that was left
                    ///< out; count: the id of that end
  ConstraintsCross, ///< index: first constraint that crosses an earlier one between points; count:
                    ///< the first that it crosses
  PolygonsDisagree, ///< of two polygons one says that a cell is inside, the other that it is not;
                    ///< index: a constraint that is a side of the polygon to be reversed, by the
                    ///< even-odd rule; count: a constraint that is a side of the other
  NotConvex,        ///< a domain; index: first corner that is not finite, is there twice, or turns
                    ///< right; -1: fewer than three corners, or not once around
  DuplicateSites,   ///< index, count: the ids of two sites at one position
  BadArea,          ///< index: first site whose prescribed area is not positive or not finite;
                    ///< count: how many
  NoDevice,         ///< the CUDA engine was requested, and there is no device for it
  DeviceMemory,     ///< count: bytes requested from the device
  DeviceFailed,     ///< index: the CUDA runtime's error number
  Internal ///< an invariant of the engine does not hold: a fault of FlipFlop, to be reported
};

/// The engine's exception. what() is a constant text: callers compose their own from the parts.
class Error : public std::exception
{
public:
  /// What went wrong, where, and how often. text, a constant, replaces the code's own clause.
  explicit Error(ErrorCode code, std::int64_t index = -1, std::int64_t count = 0,
    const char* text = nullptr) noexcept
    : Code(code)
    , Index(index)
    , Count(count)
    , Text(text)
  {
  }

  /// What went wrong.
  ErrorCode code() const noexcept { return this->Code; }
  /// The first point, triangle or polygon at fault, -1 if there is none.
  std::int64_t index() const noexcept { return this->Index; }
  /// How many are at fault, or the size requested.
  std::int64_t count() const noexcept { return this->Count; }

  /// What went wrong, as a clause: "the surface is not closed".
  const char* what() const noexcept override
  {
    if (this->Text)
    {
      return this->Text;
    }
    switch (this->Code)
    {
      case ErrorCode::NonFinite:
        return "a coordinate or weight is NaN or infinite";
      case ErrorCode::TooManyPoints:
        return "more points than 32-bit indices can name";
      case ErrorCode::OutOfMemory:
        return "out of memory";
      case ErrorCode::Aborted:
        return "aborted on request";
      case ErrorCode::BadArgument:
        return "an argument is invalid";
      case ErrorCode::WeightCount:
        return "there are not as many weights as points";
      case ErrorCode::BadTriangle:
        return "a triangle's corner is out of range or used twice";
      case ErrorCode::NotSimple:
        return "a polygon crosses or touches itself";
      case ErrorCode::NotClosed:
        return "the surface is not closed";
      case ErrorCode::NotManifold:
        return "the surface is not a manifold";
      case ErrorCode::NotOriented:
        return "neighbouring triangles are not oriented alike";
      case ErrorCode::NotStarShaped:
        return "the surface is not star-shaped from the kernel point";
      case ErrorCode::NoKernel:
        return "no kernel point was found";
      case ErrorCode::ConstraintPoint:
        return "a constraint ends at a point that is not in the triangulation";
      case ErrorCode::ConstraintsCross:
        return "two constraints cross between points";
      case ErrorCode::PolygonsDisagree:
        return "the polygons disagree about what is inside";
      case ErrorCode::NotConvex:
        return "the domain is no convex polygon with finite corners, counter-clockwise";
      case ErrorCode::DuplicateSites:
        return "two sites are at one position";
      case ErrorCode::BadArea:
        return "a prescribed area is not positive and finite";
      case ErrorCode::NoDevice:
        return "there is no device for the CUDA engine";
      case ErrorCode::DeviceMemory:
        return "the device is out of memory";
      case ErrorCode::DeviceFailed:
        return "the device failed";
      case ErrorCode::Internal:
        return "an internal fault of FlipFlop: please report it, with the input";
    }
    return "unknown error";
  }

private:
  ErrorCode Code;
  std::int64_t Index;
  std::int64_t Count;
  const char* Text;
};

/// A BadArgument whose text, a constant, names the argument and what is allowed: "a box's upper
/// corner must be above its lower corner in x and in y".
inline Error badArgument(const char* text, std::int64_t index = -1, std::int64_t count = 0) noexcept
{
  return Error(ErrorCode::BadArgument, index, count, text);
}

/// Ends the run if an invariant does not hold. That is better than a hang or a wrong result. Use it
/// for checks that cost nothing compared with the work around them.
/// @throw Error Internal
inline void ensure(bool holds)
{
  if (!holds)
  {
    throw Error(ErrorCode::Internal);
  }
}

}

#endif
