// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Composite input: each data set in it has the result that it has alone, on every port, whatever is
// wrong with the others.
#include "FFCases.h"
#include "FFTest.h"

#include "vtkAMRBox.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFFErrorCode.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkOverlappingAMR.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"
#include "vtkTypeInt64Array.h"
#include "vtkUniformGrid.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace fftest;

namespace
{

using Filter = vtkSmartPointer<vtkFFAlgorithm>;
using Maker = std::function<Filter()>;
using Leaf = vtkSmartPointer<vtkDataObject>;

/// All filters that take points, and have a result of each data set.
std::vector<Maker> makersOfPoints()
{
  std::vector<Maker> makers;
  for (const FilterCase& of : casesOfPoints())
  {
    const Filter filter = of.New();
    auto* const hull = vtkFFHullFilter::SafeDownCast(filter);
    if (!hull || hull->GetCompositeMode() == vtkFFHullFilter::HULL_OF_EACH_BLOCK)
    {
      makers.push_back(
        [=]
        {
          const Filter made = of.New();
          made->SetReportAsFieldData(true);
          return made;
        });
    }
  }
  return makers;
}

vtkSmartPointer<vtkPolyData> makeNotFinite(int count)
{
  auto leaf = randomWeighted(20, 1);
  for (int i = 0; i < count; ++i)
  {
    leaf->GetPoints()->SetPoint(3 + i, 0.5, NAN, 0.0);
  }
  return leaf;
}

/// With a coordinate that no double holds.
vtkSmartPointer<vtkPolyData> makeInexact()
{
  vtkNew<vtkTypeInt64Array> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(5);
  coordinates->Fill(0.0);
  coordinates->SetValue(6, (vtkTypeInt64(1) << 53) + 1);
  auto leaf = makePoints(coordinates);
  leaf->GetPointData()->ShallowCopy(randomWeighted(5, 1)->GetPointData());
  return leaf;
}

/// Of many kinds, null and empty ones among them, one that is there twice, one without field data,
/// and one large among many small ones.
std::vector<Leaf> makeLeaves()
{
  const auto marked = randomWeighted(12, 4);
  markPoints(marked, { vtkDataSetAttributes::DUPLICATEPOINT, 0, 0 });
  const auto bare = randomWeighted(15, 6);
  bare->SetFieldData(nullptr);
  std::vector<Leaf> leaves{ randomWeighted(30, 1), nullptr, vtkSmartPointer<vtkPolyData>::New(),
    makeWeighted(cubeCorners(), std::vector<double>(8, 1.0)),
    makeWeighted(std::vector<Point>(4, Point{ 1.0, 2.0, 3.0 }), { 0.0, 1.0, 2.0, 3.0 }),
    randomWeighted(10, 3, VTK_FLOAT), marked, randomWeighted(9000, 5), bare, marked, marked };
  for (int k = 0; k < 50; ++k)
  {
    leaves.push_back(randomWeighted(1 + k, static_cast<unsigned int>(k)));
  }
  return leaves;
}

/// With blocks inside a block.
vtkSmartPointer<vtkMultiBlockDataSet> makeBlocks(const std::vector<Leaf>& leaves)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  vtkNew<vtkMultiBlockDataSet> inner;
  for (std::size_t k = 0; k < leaves.size(); ++k)
  {
    auto* const to = k < 2 ? blocks.Get() : inner.Get();
    to->SetBlock(to->GetNumberOfBlocks(), leaves[k]);
  }
  blocks->SetBlock(2, inner);
  blocks->GetMetaData(2u)->Set(vtkCompositeDataSet::NAME(), "inner");
  return blocks;
}

vtkSmartPointer<vtkCompositeDataIterator> iterate(vtkDataObject* composite)
{
  vtkSmartPointer<vtkCompositeDataIterator> leaves;
  leaves.TakeReference(vtkCompositeDataSet::SafeDownCast(composite)->NewIterator());
  leaves->InitTraversal();
  return leaves;
}

/// What a filter reports of its last run, to be added up.
std::vector<double> reportOf(vtkFFAlgorithm* ran)
{
  std::vector<double> report{ double(ran->GetNumberOfInputPoints()),
    double(ran->GetNumberOfNonFinitePoints()) };
  if (auto* hull = vtkFFHullAlgorithm::SafeDownCast(ran))
  {
    report.insert(report.end(), { hull->GetVolume(), hull->GetArea() });
  }
  if (auto* triangulation = vtkFFRegularTriangulationFilter::SafeDownCast(ran))
  {
    report.push_back(double(triangulation->GetNumberOfHiddenPoints()));
  }
  return report;
}

/// What is at fault, in the order of the data sets: the number of the data set, and what the error
/// says of it.
struct Fault
{
  int Number;
  unsigned long Code;
  std::string Part;
};

/// Runs the filter for the composite, and for each data set in it alone. One result may be at fault
/// there, too: then it is empty here.
void check(const Maker& maker, vtkCompositeDataSet* input, const std::vector<Fault>& faults = {})
{
  const Filter filter = maker();
  const std::string what = std::string(filter->GetClassName()) + ", " + input->GetClassName();
  const auto errors = ErrorObserver::Of(filter);
  vtkNew<ProgressObserver> progress;
  filter->AddObserver(vtkCommand::ProgressEvent, progress);
  filter->SetInputDataObject(input);
  vtkNew<vtkFFHullFilter> behind; // runs with what there is
  behind->SetCompositeMode(vtkFFHullFilter::HULL_OF_ALL_BLOCKS);
  behind->SetInputConnection(filter->GetOutputPort());
  FF_CHECK(succeeds(behind));
  checkProgress(progress->Values);

  // One message for each that is at fault; the last one's code.
  FF_CHECK_EQUAL(errors->Messages.size(), faults.size());
  for (std::size_t i = 0; i < std::min(faults.size(), errors->Messages.size()); ++i)
  {
    const std::string where = "ata set " + std::to_string(faults[i].Number) + " of the composite";
    const bool isSaid = errors->Messages[i].find(faults[i].Part) != std::string::npos &&
      errors->Messages[i].find(where) != std::string::npos;
    FF_CHECK_EQUAL(isSaid ? faults[i].Part : errors->Messages[i], faults[i].Part);
  }
  FF_CHECK_EQUAL(filter->GetErrorCode(), faults.empty() ? 0 : faults.back().Code);

  std::vector<vtkSmartPointer<vtkCompositeDataIterator>> outputs;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    outputs.push_back(iterate(filter->GetOutputDataObject(port)));
  }
  const auto whole = reportOf(filter);
  std::vector<double> sums(whole.size());
  std::size_t number = 0;
  std::size_t fault = 0;
  for (const auto leaf = iterate(input); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    const Filter alone = maker();
    const auto errorsAlone = ErrorObserver::Of(alone);
    alone->SetInputDataObject(leaf->GetCurrentDataObject());
    alone->Update();
    const bool isBad = fault < faults.size() && faults[fault].Number == int(number);
    FF_CHECK_EQUAL(errorsAlone->Messages.size(), std::size_t(isBad));
    fault += isBad;
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      vtkCompositeDataIterator* const output = outputs[static_cast<std::size_t>(port)];
      FF_CHECK(isIdentical(output->GetCurrentDataObject(), alone->GetOutputDataObject(port),
        what + " " + std::to_string(number) + ", port " + std::to_string(port)));
      FF_CHECK(input->IsA("vtkUniformGridAMR") ||
        output->GetCurrentFlatIndex() == leaf->GetCurrentFlatIndex());
      output->GoToNextItem();
    }
    const auto part = reportOf(alone);
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      sums[i] += part[i];
    }
    FF_CHECK(alone->GetDimension() <= filter->GetDimension());
    ++number;
  }
  FF_CHECK(whole == sums);
  FF_CHECK(outputs[0]->IsDoneWithTraversal());

  // None the worse for it.
  filter->SetInputDataObject(makeVoxels({ { 0, 0, 0 } }));
  if (!filter->GetInputArrayInformation(0)->Has(vtkDataObject::FIELD_NAME()))
  {
    FF_CHECK(succeeds(filter));
    FF_CHECK_EQUAL(filter->GetNumberOfInputPoints(), 8);
  }
}

void testMany()
{
  const auto blocks = makeBlocks(makeLeaves());
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartition(0, 0, randomWeighted(50, 1));
  collection->SetPartition(2, 0, randomWeighted(60, 2)); // there is none with number 1
  collection->SetPartition(2, 1, randomWeighted(70, 3, VTK_FLOAT));
  for (const Maker& maker : makersOfPoints())
  {
    check(maker, blocks);
    check(maker, makeBlocks({ randomWeighted(30, 1) })); // a single one
    check(maker, collection);
  }
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(blocks);
  hull->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(hull->GetOutputDataObject(0));
  FF_CHECK_EQUAL(std::string(output->GetMetaData(2u)->Get(vtkCompositeDataSet::NAME())), "inner");
}

/// What VTK adds to the composites works: here grids on two levels.
void testAMR()
{
  vtkNew<vtkOverlappingAMR> levels;
  const int counts[2] = { 1, 2 };
  const double origin[3] = { 0.0, 0.0, 0.0 };
  levels->Initialize(2, counts);
  levels->SetOrigin(origin);
  levels->SetGridDescription(VTK_XYZ_GRID);
  for (unsigned int level = 0; level < 2; ++level)
  {
    const double side = level == 0 ? 1.0 : 0.5;
    const double spacing[3] = { side, side, side };
    levels->SetSpacing(level, spacing);
    for (int k = 0; k < counts[level]; ++k)
    {
      const int low[3] = { 4 * k, 0, 0 };
      const int high[3] = { 4 * k + 3, 3, 3 };
      levels->SetAMRBox(level, static_cast<unsigned int>(k), vtkAMRBox(low, high));
      vtkNew<vtkUniformGrid> grid;
      grid->SetOrigin(4 * side * k, 0, 0);
      grid->SetSpacing(spacing);
      grid->SetDimensions(5, 5, 5);
      grid->GetPointData()->ShallowCopy(randomWeighted(125, 1)->GetPointData());
      grid->SetFieldData(nullptr);
      levels->SetDataSet(level, static_cast<unsigned int>(k), grid);
    }
  }
  for (const Maker& maker : makersOfPoints())
  {
    check(maker, levels);
  }
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(levels);
  hull->Update();
  FF_CHECK_EQUAL(hull->GetVolume(), 64.0 + 8.0 + 8.0);
  hull->SetCompositeMode(vtkFFHullFilter::HULL_OF_ALL_BLOCKS);
  hull->Update();
  FF_CHECK_EQUAL(hull->GetOutput()->GetNumberOfPoints(), 8);
  FF_CHECK_EQUAL(hull->GetVolume(), 64.0);
  // Also where the last grid sticks out, whose flat index is 2, as the first one's is 0.
  levels->GetDataSet(1, 1)->SetOrigin(20, 0, 0);
  hull->Modified();
  hull->Update();
  vtkPointData* const data = hull->GetOutput()->GetPointData();
  double range[2] = { -1, -1 };
  if (vtkDataArray* const blocks = data->GetArray("BlockIndex"))
  {
    blocks->GetRange(range);
  }
  FF_CHECK(range[0] == 0 && range[1] == 2);
}

/// Wherever they are: also the first, the last, and next to each other.
void testFaults()
{
  const auto flat = makeWeighted(cubeCorners(), std::vector<double>(12, 0.0));
  flat->GetPoints()->GetData()->SetNumberOfComponents(2);
  vtkNew<vtkTable> table;
  const std::vector<Leaf> leaves{ makeNotFinite(2), randomWeighted(9, 1), makeInexact(), nullptr,
    flat, randomWeighted(9, 2), makeNotFinite(1), table, randomWeighted(9, 3) };
  const std::vector<Fault> faults{ { 0, vtkFFErrorCode::NonFiniteError,
                                     "is NaN or infinite: first at point 3 of" },
    { 2, vtkFFErrorCode::InputError, "64-bit integer that no double holds: first at point 2 of" },
    { 3, vtkFFErrorCode::InputError, "have 2 coordinates each" },
    { 5, vtkFFErrorCode::NonFiniteError,
      "first at point 3 of data set 5 of the composite, 1 such" },
    { 6, vtkFFErrorCode::InputError,
      "is a vtkTable. It must be a vtkDataSet, or a composite of these." } };
  for (const Maker& maker : makersOfPoints())
  {
    check(maker, makeBlocks(leaves), faults);
    check(maker, makeBlocks({ randomWeighted(9, 1), randomWeighted(9, 2), makeInexact() }),
      { { 2, vtkFFErrorCode::InputError, "first at point 2 of" } });
  }
  check(makeWeightedFilter<vtkFFRegularTriangulationFilter>,
    makeBlocks({ randomWeighted(9, 1), makePoints(cubeCorners()), randomWeighted(9, 2) }),
    { { 1, vtkFFErrorCode::InputError, "The weights' array \"weights\"" } });

  check(makeFilterOfImages,
    makeBlocks({ randomWeighted(9, 1),
      makeWeighted({ { -1e308, 0, 0 }, { 1e308, 1, 0 }, { 0, 2, 0 } }, { 0, 0, 0 }) }),
    { { 1, vtkFFErrorCode::SettingError, "A length of inf cannot be divided into 12 pixels." } });

  const auto cube = makeVoxels({ { 0, 0, 0 } });
  const auto u = makeVoxels({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 }, { 2, 1, 0 } });
  const auto edge = makeSurface(cubeCorners(), { { 0, 1 } });
  check(makeFilter<vtkFFConvexifyFilter>,
    makeBlocks({ cube, makeSurface(cubeCorners(), { { 0, 1, 3 } }), u, edge,
      makePoints(cubeCorners()), vtkSmartPointer<vtkStructuredGrid>::New(), cube }),
    { { 1, vtkFFErrorCode::SurfaceError, "is not closed: first at cell 0 of" },
      { 2, vtkFFErrorCode::SurfaceError, "is not star-shaped" },
      { 3, vtkFFErrorCode::InputError, "is a polygon of 2" },
      { 4, vtkFFErrorCode::InputError, "has no cells, but 8 point(s)" },
      { 5, vtkFFErrorCode::InputError, "is a vtkStructuredGrid. It must be a vtkPolyData." } });
}

/// Aborts within the run of the data set that comes last before this share of all.
class Aborter : public vtkCommand
{
public:
  static Aborter* New() { return new Aborter; }
  vtkTypeMacro(Aborter, vtkCommand);

  void Execute(vtkObject* caller, unsigned long, void* data) override
  {
    const double progress = 30 * *static_cast<double*>(data);
    // Between data sets, old executives forget.
    if (progress >= this->At && std::fabs(progress - std::round(progress)) > 1e-6)
    {
      this->At = 99; // once: the data sets after this one must not run all the same
      vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
    }
  }

  double At = 99;
};

/// An abort ends the whole run, and is no error.
void testAborts()
{
  std::vector<Leaf> leaves{ makeNotFinite(1) };
  for (unsigned int k = 1; k < 30; ++k)
  {
    leaves.push_back(randomWeighted(500, k));
  }
  for (const Maker& maker : makersOfPoints())
  {
    const Filter filter = maker();
    const auto errors = ErrorObserver::Of(filter);
    vtkNew<Aborter> aborter;
    filter->AddObserver(vtkCommand::ProgressEvent, aborter);
    filter->SetInputDataObject(makeBlocks(leaves));
    filter->Update();
    FF_CHECK_EQUAL(filter->GetNumberOfInputPoints(), vtkIdType(29 * 500));
    aborter->At = 10.0;
    filter->Modified();
    filter->Update();
    filter->SetAbortExecute(0);
    FF_CHECK(filter->GetNumberOfInputPoints() >= 8 * 500);
    FF_CHECK(filter->GetNumberOfInputPoints() <= 11 * 500);
    FF_CHECK_EQUAL(filter->GetErrorCode(), vtkFFErrorCode::NonFiniteError); // of the first
    FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(2));
    aborter->At = 99;
    filter->SetInputDataObject(makeBlocks({ randomWeighted(9, 1), randomWeighted(9, 2) }));
    FF_CHECK(succeeds(filter));
    FF_CHECK_EQUAL(filter->GetNumberOfInputPoints(), vtkIdType(18));
  }
}

}

int TestFFComposites(int, char*[])
{
  testMany();
  testAMR();
  testFaults();
  testAborts();
  return result();
}
