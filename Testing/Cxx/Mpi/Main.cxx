// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The program that mpiexec starts: runs the test that is named, on all processes, and fails on all
// of them when any found something wrong.
#include "DistributedVersusSerial.h"

#include "vtkMPIController.h"

#include <cstdlib>
#include <iostream>
#include <map>

int main(int argc, char* argv[])
{
  const std::map<std::string, void (*)()> tests{
    { "Errors", testErrors },
    { "Faults", testFaults },
    { "Hull", testHull },
    { "HullComposite", testHullComposite },
    { "HullShares", testHullShares },
    { "HullStreamed", testHullStreamed },
    { "RandomPartitions", testRandomPartitions },
    { "Shares", testShares },
    { "Triangulation", testTriangulation },
  };
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);

  const auto test = tests.find(argc > 2 ? argv[1] : "");
  bool well = test != tests.end();
  if (!well)
  {
    std::cerr << "usage: mpiexec -n <processes> FiltersFlipFlopMpiTests <test> <processes>\n";
  }
  else if (controller->GetNumberOfProcesses() != std::atoi(argv[2]))
  {
    // Another MPI's mpiexec starts the program several times, each alone.
    std::cerr << "there are " << controller->GetNumberOfProcesses() << " process(es), not "
              << argv[2] << "\n";
    well = false;
  }
  else
  {
    test->second();
    well = fftest::allWell();
  }
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return well ? EXIT_SUCCESS : EXIT_FAILURE;
}
