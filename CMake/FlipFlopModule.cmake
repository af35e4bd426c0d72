# How the VTK modules are built: the one whose vtk.module lies beside the top CMakeLists.txt, and that of the filters for
# distributed data, which builds on it.
set(FLIPFLOP_MODULES FlipFlop::FiltersFlipFlop FlipFlop::FiltersParallelFlipFlop)
set(FLIPFLOP_MODULE_FILES
  "${FlipFlop_SOURCE_DIR}/vtk.module"
  "${FlipFlop_SOURCE_DIR}/Filters/Parallel/vtk.module")

# vtk_module_build() names a module's folders relative to CMAKE_SOURCE_DIR, and that of a module at the
# very top would have no name: CMake would take it for the project's own. So, in the scope of that call
# alone, the source tree begins one folder further up.
macro(flipflop_begin_source_tree_above)
  get_filename_component(CMAKE_SOURCE_DIR "${FlipFlop_SOURCE_DIR}" DIRECTORY)
  if(CMAKE_SOURCE_DIR STREQUAL "/")
    set(CMAKE_SOURCE_DIR "/.") # a checkout in /src: "//src" would be another file to ninja
  endif()
endmacro()

# flipflop_build_modules(): builds them against VTK. (Against ParaView: Plugin/CMakeLists.txt.)
function(flipflop_build_modules)
  flipflop_begin_source_tree_above()
  vtk_module_build(
    MODULES ${FLIPFLOP_MODULES}
    PACKAGE FlipFlop
    VERSION "${FlipFlop_VERSION}"
    SOVERSION "${FlipFlop_VERSION_MAJOR}.${FlipFlop_VERSION_MINOR}"
    INSTALL_EXPORT FlipFlop
    INSTALL_HEADERS ON
    HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/flipflop/vtk"
    CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/FlipFlop"
    LICENSE_DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/licenses/FlipFlop"
    ENABLE_WRAPPING ${FLIPFLOP_WRAP_PYTHON}
    TEST_DIRECTORY_NAME NONE)
  vtk_module_export_find_packages(
    CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/FlipFlop"
    FILE_NAME "FlipFlop-vtk-module-find-packages.cmake"
    MODULES ${FLIPFLOP_MODULES})
endfunction()
