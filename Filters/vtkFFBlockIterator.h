// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFBlockIterator
 * @brief   goes through the blocks of an input
 *
 * vtkFFBlockIterator goes through the blocks of the input, those without data too, in the order of
 * their flat indices. The partitions of a vtkPartitionedDataSet are no blocks.
 */

#ifndef vtkFFBlockIterator_h
#define vtkFFBlockIterator_h

#include "vtkDataObject.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkFFMarks.h"
#include "vtkPartitionedDataSet.h"
#include "vtkSmartPointer.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkFFBlockIterator
{
public:
  explicit vtkFFBlockIterator(vtkDataObject* input)
    : Input(input)
  {
    auto* tree = vtkDataObjectTree::SafeDownCast(input);
    if (tree && !vtkPartitionedDataSet::SafeDownCast(tree))
    {
      this->Nodes.TakeReference(tree->NewTreeIterator());
      this->Nodes->SkipEmptyNodesOff();
      this->Nodes->VisitOnlyLeavesOff();
      this->Nodes->InitTraversal();
      this->SkipInnerNodes();
    }
  }

  bool IsDone() const { return this->Nodes ? this->Nodes->IsDoneWithTraversal() != 0 : this->Past; }

  void GoToNext()
  {
    if (!this->Nodes)
    {
      this->Past = true;
      return;
    }
    auto* partitions = vtkPartitionedDataSet::SafeDownCast(this->GetData());
    for (unsigned int k = partitions ? partitions->GetNumberOfPartitions() : 0; k > 0; --k)
    {
      this->Nodes->GoToNextItem();
    }
    this->Nodes->GoToNextItem();
    this->SkipInnerNodes();
  }

  unsigned int GetFlatIndex() const { return this->Nodes ? this->Nodes->GetCurrentFlatIndex() : 0; }
  vtkDataObject* GetData() const
  {
    return this->Nodes ? this->Nodes->GetCurrentDataObject() : this->Input;
  }

  /**
   * Put data in the place of this block, in a composite of the input's structure.
   */
  void SetData(vtkDataObject* composite, vtkDataObject* data) const
  {
    auto* tree = vtkDataObjectTree::SafeDownCast(composite);
    vtkDataObject* place = this->Nodes ? tree->GetDataSet(this->Nodes) : tree;
    if (auto* partitions = vtkPartitionedDataSet::SafeDownCast(place))
    {
      partitions->SetNumberOfPartitions(1);
      partitions->SetPartition(0, data);
    }
    else
    {
      tree->SetDataSet(this->Nodes, data);
    }
  }

private:
  void SkipInnerNodes()
  {
    while (!this->IsDone() && vtkDataObjectTree::SafeDownCast(this->GetData()) &&
      !vtkPartitionedDataSet::SafeDownCast(this->GetData()))
    {
      this->Nodes->GoToNextItem();
    }
  }

  vtkDataObject* Input;
  vtkSmartPointer<vtkDataObjectTreeIterator> Nodes; // null where the input is the only block
  bool Past = false;
};
VTK_ABI_NAMESPACE_END

#endif
