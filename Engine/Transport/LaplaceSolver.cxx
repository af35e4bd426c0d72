// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// By Eigen's sparse Cholesky factors, in the order of approximate minimum degrees: in that of
/// nested halves by position, factors took twice as long. All that includes Eigen is here.
#include "Transport/LaplaceSolver.h"

#include "Support/StrictArithmetic.h"

#define EIGEN_MPL2_ONLY
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <cstddef>

static_assert(EIGEN_VERSION_AT_LEAST(3, 3, 0), "Eigen 3.3 or later is wanted");

namespace flipflop
{

bool solveLaplace(std::size_t count, const std::vector<WeightedLink>& links,
  const std::vector<double>& wanted, std::vector<double>& x)
{
  x.assign(count, 0.0);
  const auto free = static_cast<Eigen::Index>(count) - 1;
  if (free == 0)
  {
    return true;
  }
  // The lower triangle, column by column: the diagonal, then the links to higher nodes.
  using Matrix = Eigen::SparseMatrix<double>;
  std::vector<double> diagonal(count, 0.0);
  Eigen::VectorXi sizes = Eigen::VectorXi::Constant(free, 1);
  for (const WeightedLink& link : links)
  {
    diagonal[link.low] += link.weight;
    diagonal[link.high] += link.weight;
    sizes[link.low] += link.high < free ? 1 : 0;
  }
  Matrix matrix(free, free);
  matrix.reserve(sizes);
  for (Eigen::Index i = 0; i < free; ++i)
  {
    matrix.insert(i, i) = diagonal[static_cast<std::size_t>(i)];
  }
  for (const WeightedLink& link : links)
  {
    if (link.high < free)
    {
      matrix.insert(link.high, link.low) = -link.weight;
    }
  }
  matrix.makeCompressed();
  const Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::AMDOrdering<int>> factors(matrix);
  if (factors.info() != Eigen::Success)
  {
    return false;
  }
  Eigen::Map<Eigen::VectorXd>(x.data(), free) =
    factors.solve(Eigen::Map<const Eigen::VectorXd>(wanted.data(), free));
  return std::all_of(x.begin(), x.end(), [](double value) { return std::isfinite(value); });
}

}
