// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFBlockFailures.h"

#include "vtkFFFailure.h"
#include "vtkFFGuard.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// So many blocks are named at most.
constexpr std::size_t mostNamed = 8;

}

//------------------------------------------------------------------------------
void vtkFFBlockFailures::Add(unsigned int flatIndex, const vtkFFFailure& failure)
{
  if (failure.Kind == vtkFFFailure::None || failure.Kind == vtkFFFailure::Aborted)
  {
    this->HasAbort = this->HasAbort || failure.Kind == vtkFFFailure::Aborted;
    return;
  }
  if (this->Count == 0)
  {
    this->Message = this->Guard.DescribeFailure(failure);
  }
  if (this->Count < mostNamed)
  {
    this->Indices.push_back(flatIndex);
  }
  ++this->Count;
  this->NonFinite += failure.Count;
}

//------------------------------------------------------------------------------
bool vtkFFBlockFailures::Join(std::size_t numberOfBlocks, vtkFFFailure& failure) const
{
  if (this->HasAbort)
  {
    failure.Kind = vtkFFFailure::Aborted;
    return false;
  }
  if (this->Count > 0)
  {
    failure.Say(this->Describe(numberOfBlocks));
    failure.Count = this->NonFinite;
  }
  return this->Count == 0 || this->Count < numberOfBlocks;
}

//------------------------------------------------------------------------------
std::string vtkFFBlockFailures::Describe(std::size_t numberOfBlocks) const
{
  if (numberOfBlocks == 1)
  {
    return this->Message;
  }
  if (this->Count == numberOfBlocks)
  {
    return this->Message + " None of the " + std::to_string(this->Count) + " blocks has a result.";
  }
  std::string names;
  for (std::size_t i = 0; i < this->Indices.size(); ++i)
  {
    const bool isLast = i > 0 && i + 1 == this->Count;
    names += (i == 0 ? "" : isLast ? " and " : ", ") + std::to_string(this->Indices[i]);
  }
  if (this->Count > this->Indices.size())
  {
    names += " and " + std::to_string(this->Count - this->Indices.size()) + " more";
  }
  const std::size_t others = numberOfBlocks - this->Count;
  return this->Message +
    (this->Count == 1 ? " The block of flat index " + names + " has no result"
                      : " The blocks of flat indices " + names + " have no results") +
    (others == 1 ? "; the other one has its own."
                 : "; the " + std::to_string(others) + " others have theirs.");
}
VTK_ABI_NAMESPACE_END
