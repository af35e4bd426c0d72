# The top CMakeLists.txt in its role as a VTK module's list file. Where the project around is not our own,
# the engines and their rules are brought along.
if(NOT TARGET FlipFlopEngineObjects)
  set(CMAKE_POSITION_INDEPENDENT_CODE ON)
  set(FlipFlop_SOURCE_DIR "${CMAKE_CURRENT_SOURCE_DIR}")
  include("${CMAKE_CURRENT_SOURCE_DIR}/CMake/FlipFlopCompilerOptions.cmake")
  include("${CMAKE_CURRENT_SOURCE_DIR}/CMake/FlipFlopThreads.cmake")
  include("${CMAKE_CURRENT_SOURCE_DIR}/CMake/FlipFlopCuda.cmake")
  add_subdirectory(Engine EXCLUDE_FROM_ALL)
  add_subdirectory(Cuda EXCLUDE_FROM_ALL)
endif()
add_subdirectory(Filters)
