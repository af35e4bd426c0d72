# The tree of a wheel: the core, which needs no VTK, and the Python package around it. With FLIPFLOP_WHEEL_VTK also the VTK
# classes, built by VTK's wheel helper against the wheel SDK, to run beside the wheel vtk. Entered from pyproject.toml by
# scikit-build-core alone.
option(FLIPFLOP_WHEEL_VTK "Put the VTK classes into the wheel (needs the wheel vtk-sdk)" OFF)

# The root of a wheel is the folder that holds the packages.
set(FLIPFLOP_PYTHON_DESTINATION ".")

if(FLIPFLOP_WHEEL_VTK)
  include(VTKSDKPythonWheelHelper)
  include(FlipFlopModule)

  # VTK's wheels for x86-64 have the C++ library's older ABI; what the helper gives to the module alone is
  # said to the engines, and to who uses them: paths, and errors of files, are of either.
  if(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64" AND NOT APPLE AND NOT WIN32)
    target_compile_definitions(FlipFlopEngineObjects PUBLIC _GLIBCXX_USE_CXX11_ABI=0)
    target_compile_definitions(FlipFlopEngine PUBLIC _GLIBCXX_USE_CXX11_ABI=0)
  endif()

  function(flipflop_build_wheel)
    flipflop_begin_source_tree_above()
    vtksdk_build_modules(vtkflipflop
      SOURCE_DIR "${FlipFlop_SOURCE_DIR}"
      MODULES ${FLIPFLOP_MODULES})
  endfunction()
  flipflop_build_wheel()

  # The versions of the wheel vtk that pyproject.toml allows, which the package itself looks for when the classes are
  # asked for.
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${FlipFlop_SOURCE_DIR}/pyproject.toml")
  file(STRINGS "${FlipFlop_SOURCE_DIR}/pyproject.toml" allowed REGEX "\"vtk>=[0-9.]+,<=[0-9.]+\"")
  if(NOT allowed MATCHES "\"vtk>=([0-9.]+),<=([0-9.]+)\"")
    message(FATAL_ERROR "pyproject.toml names no range of VTK's versions, as in \"vtk>=9.6.0,<=9.6.2\"")
  endif()
  set(FLIPFLOP_VTK_OLDEST "${CMAKE_MATCH_1}")
  set(FLIPFLOP_VTK_NEWEST "${CMAKE_MATCH_2}")
endif()

add_subdirectory(Wrapping/Core)
add_subdirectory(Wrapping/Package)
