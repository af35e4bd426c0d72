// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The program that mpiexec starts: runs the tests that are named, or all, on all processes, and
// fails on all of them when any found something wrong.
#include "DistributedVersusSerial.h"

#include "vtkMPIController.h"

#include <algorithm>
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

  const std::vector<std::string> names(argv + std::min(argc, 2), argv + argc);
  bool well = argc > 1 &&
    std::all_of(
      names.begin(), names.end(), [&](const std::string& name) { return tests.count(name) > 0; });
  if (!well)
  {
    std::cerr << "usage: mpiexec -n <processes> FiltersFlipFlopMpiTests <processes> [<test>...]\n";
  }
  else if (controller->GetNumberOfProcesses() != std::atoi(argv[1]))
  {
    // Another MPI's mpiexec starts the program several times, each alone.
    std::cerr << "there are " << controller->GetNumberOfProcesses() << " process(es), not "
              << argv[1] << "\n";
    well = false;
  }
  else
  {
    for (const auto& test : tests)
    {
      if (names.empty() || std::find(names.begin(), names.end(), test.first) != names.end())
      {
        if (controller->GetLocalProcessId() == 0)
        {
          std::cout << test.first << std::endl;
        }
        test.second();
        well = fftest::allWell() && well;
        fftest::failures() = 0;
      }
    }
  }
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return well ? EXIT_SUCCESS : EXIT_FAILURE;
}
