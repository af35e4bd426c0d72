# The tree of a wheel: the module built by VTK's wheel helper against the wheel SDK, to run beside the wheel
# vtk, and the Python package around it. Entered from pyproject.toml by scikit-build-core alone.
include(VTKSDKPythonWheelHelper)
include(FlipFlopModule)

# VTK's wheels for x86-64 have the C++ library's older ABI; what the helper gives to the module alone is
# said to the engines, too.
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64" AND NOT APPLE AND NOT WIN32)
  target_compile_definitions(FlipFlopEngineObjects PUBLIC _GLIBCXX_USE_CXX11_ABI=0)
endif()

function(flipflop_build_wheel)
  flipflop_begin_source_tree_above()
  vtksdk_build_modules(vtkflipflop
    SOURCE_DIR "${FlipFlop_SOURCE_DIR}"
    MODULES FlipFlop::FiltersFlipFlop)
endfunction()
flipflop_build_wheel()

# The root of a wheel is the folder that holds the packages.
set(FLIPFLOP_PYTHON_DESTINATION ".")
add_subdirectory(Wrapping/Package)
