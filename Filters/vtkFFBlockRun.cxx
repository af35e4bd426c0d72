// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFBlockRun.h"

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkFFBlockRun::vtkFFBlockRun(
  flipflop::BlockShape shape, const flipflop::BlockPoints& points, const flipflop::Options& options)
  : Run(shape, points, options)
{
}

//------------------------------------------------------------------------------
vtkFFBlockRun::~vtkFFBlockRun() = default;

//------------------------------------------------------------------------------
flipflop::BlockMessage vtkFFBlockRun::Introduction() const
{
  return this->Run.introduction();
}

//------------------------------------------------------------------------------
void vtkFFBlockRun::Begin(const std::vector<flipflop::BlockMessage>& introductions, int self)
{
  this->Run.begin(introductions, self);
}

//------------------------------------------------------------------------------
std::map<int, flipflop::BlockMessage> vtkFFBlockRun::Ask()
{
  return this->Run.ask();
}

//------------------------------------------------------------------------------
flipflop::BlockMessage vtkFFBlockRun::Answer(const flipflop::BlockMessage& questions)
{
  return this->Run.answer(questions);
}

//------------------------------------------------------------------------------
void vtkFFBlockRun::Take(int from, const flipflop::BlockMessage& answers)
{
  this->Run.take(from, answers);
}

//------------------------------------------------------------------------------
flipflop::BlockResult vtkFFBlockRun::Finish()
{
  return this->Run.finish();
}

//------------------------------------------------------------------------------
flipflop::BlockMeasure vtkFFBlockRun::Measure(
  const flipflop::BlockResult& result, const double* origin) const
{
  return this->Run.measure(result, origin);
}

//------------------------------------------------------------------------------
void vtkFFBlockRun::SizeOf(const flipflop::BlockMeasure& sum, double& volume, double& area) const
{
  this->Run.sizeOf(sum, volume, area);
}

//------------------------------------------------------------------------------
std::int64_t vtkFFBlockRun::GetNumberOfPointsTold() const
{
  return this->Run.pointsTold();
}
VTK_ABI_NAMESPACE_END
