// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// All error bounds of what is decided in floating point, and the ranges in which they hold.
///
/// Each is proven by a Gappa script in Testing/Proofs, whose name its group has
/// (Documentation/Exactness.md). Errors of doubles are multiples of 2^-53, those of double-doubles
/// of 2^-106; each constant is exact as it is written.
#ifndef flipflop_ErrorBounds_h
#define flipflop_ErrorBounds_h

namespace flipflop
{

/// plane-orientation: an orientation in the plane, against the sum of its two products' magnitudes;
/// no less than the floor, below which products lose bits.
/// @{
constexpr double PlaneError = 4.015625 * 0x1p-53;
constexpr double PlaneFloor = 0x1p-963;
/// @}

/// determinant: a 3 by 3 determinant of rounded differences, against the product of its rows' or
/// columns' largest entries, which are from the floor to the ceiling.
/// @{
constexpr double DeterminantError = 48.125 * 0x1p-53;
constexpr double FilterFloor = 0x1p-322;
constexpr double FilterCeiling = 0x1p338;
/// @}

/// symbolic-kernel: a rounded centroid, against its largest coordinate; and by how much a
/// determinant grows with it, against the product of two columns' largest entries.
/// @{
constexpr double CentroidError = 2.0625 * 0x1p-53;
constexpr double CentroidSlope = 2.0078125;
/// @}

/// lifted-determinant, in-circle: the power test, against the sum of its six terms' magnitudes, in
/// which a height counts with the sum of its parts' magnitudes. Positions are below the ceiling,
/// and heights below its square; a bound that is less than LiftedUnderflow is none.
/// @{
constexpr double LiftedTermError = 13 * 0x1p-53;
constexpr double LiftedUnderflow = 0x1p-564;
constexpr double LiftedCeiling = 0x1p232;
/// @}

/// power-difference: a difference of power distances, against the sum of its terms' magnitudes.
constexpr double PowerError = 8 * 0x1p-53;

/// direction: how much farther along a direction, against the sum of the terms' magnitudes.
/// @{
constexpr double DirectionError = 4.015625 * 0x1p-53;
constexpr double DirectionFloor = 0x1p-896;
/// @}

/// edge-length: the square of a length, against that of a limit.
/// @{
constexpr double LengthError = 0x1p-50;
constexpr double SquareFloor = 0x1p-963;
constexpr double SquareCeiling = 0x1p996;
/// @}

/// power-cell-side: the side of a line of equal power, against the sum of the terms' magnitudes.
/// @{
constexpr double CutError = 0x1p-50;
constexpr double CutFloor = 0x1p-900;
/// @}

/// minor: a 2 by 2 determinant in double-double, against the sum of its products' magnitudes; and
/// what rounding adds to the errors of its entries.
/// @{
constexpr double MinorError = 0x1p-102;
constexpr double MinorSlack = 1.0078125;
constexpr double MinorFloor = 0x1p-830;
constexpr double MinorCeiling = 0x1p996;
/// @}

/// lifted-height: a difference of heights in double-double, against the sum of its terms'.
constexpr double HeightError = 0x1p-102;

/// rounded-determinant: the determinant in double-double.
constexpr double RoundedDeterminantError = 0x1p-98;

/// rounded-lifted-determinant: the power test in double-double, against the product of its columns'
/// largest entries, of positions from the floor on.
/// @{
constexpr double RoundedLiftedError = 0x1p-96;
constexpr double RoundedLiftedFloor = 0x1p-232;
/// @}

/// bounded, double-double: an operation on doubles, and on double-doubles, against the product of
/// the high parts or the sum of their magnitudes; what underflow takes from a product; what bounds
/// are off by themselves.
/// @{
constexpr double NearUnit = 0x1p-53;
constexpr double FarUnit = 0x1p-103;
constexpr double BoundedUnderflow = 0x1p-1071;
constexpr double BoundedSlack = 1 + 0x1p-10;
/// @}

/// rounded-fraction: a number and a quotient, against the sum of their magnitudes; and the rounding
/// of the sum's low part.
/// @{
constexpr double FractionError = 32 * 0x1p-106;
constexpr double FractionLowError = 0x1p-52;
/// @}

/// plane-values: areas and heights in double-double are right to 2^-66 where they are at least
/// this, against the sums of their terms' magnitudes.
constexpr double PlaneValueShare = 0x1p-34;

/// hull-planes: a point whose height and error sum to so many errors is above the plane.
constexpr double PlaneClearance = 2.5;

/// hull-locator: a direction in float, in units of its largest component; a length; what limits
/// pass in double; and the error of a plane's slope, in errors of its heights.
/// @{
constexpr double LocatorDirectionError = 0x1p-21;
constexpr double LocatorLengthError = 0x1p-22;
constexpr double LocatorSlack = 0x1p-48;
constexpr double LocatorSlopeErrors = 2;
/// @}

/// conflict-bound: a slope, against the sum of its terms' magnitudes; a term; a sum of terms; and
/// what underflow may add to a height above a plane, and above a circle.
/// @{
constexpr double SlopeError = 10.5 * 0x1p-53;
constexpr double TermError = 8 * 0x1p-53;
constexpr double SumError = 8 * 0x1p-53;
constexpr double PlaneConflictUnderflow = 0x1p-771;
constexpr double CircleConflictUnderflow = 0x1p-989;
/// @}

/// block-patch: a patch's radius and slab, against the radius; of one that is no thinner.
/// @{
constexpr double PatchError = 8 * 0x1p-53;
constexpr double PatchFloor = 0x1p-480;
/// @}

/// crossing-parts: a point of a segment, against the largest coordinate; an offset from a line,
/// against itself and one.
/// @{
constexpr double PartError = 8 * 0x1p-53;
constexpr double PartUnderflow = 0x1p-1073;
constexpr double OffsetError = 3 * 0x1p-53;
constexpr double OffsetUnit = 0x1p-100;
/// @}

/// farthest-pair: squares of distances between corners in the unit frame, and bounds of them.
constexpr double FarthestPairMargin = 0x1p-45;

/// minimal-box: a triangle's share of a volume in the unit frame.
constexpr double VolumeSlack = 0x1p-48;

/// surface-distance: how far a point is on the left of a triangle's side, against the product of
/// the lengths of the side and of the way to the point.
constexpr double LeftError = 32 * 0x1p-53;

/// side-crossing: where a side crosses a row, against the sum of its ends' magnitudes, from the
/// floor on; its slope is below the ceiling.
/// @{
constexpr double CrossingError = 8 * 0x1p-53;
constexpr double CrossingFloor = 0x1p-800;
constexpr double CrossingCeiling = 0x1p500;
/// @}

/// octahedral-map: a direction's share of the sum of its coordinates, against that of their terms,
/// and against one; of terms in this range. A number of steps along a curve.
/// @{
constexpr double ShareError = 10 * 0x1p-53;
constexpr double ShareFloor = 0x1p-400;
constexpr double ShareCeiling = 0x1p400;
constexpr double StepError = 0x1p-33;
/// @}

/// direction-map: a coordinate in the map's grid.
constexpr double MapMargin = 0x1p-44;

}

#endif
