# How the VTK module is built whose vtk.module lies beside the top CMakeLists.txt.

# vtk_module_build() names a module's folders relative to CMAKE_SOURCE_DIR, and that of a module at the
# very top would have no name: CMake would take it for the project's own. So, in the scope of that call
# alone, the source tree begins one folder further up.
macro(flipflop_begin_source_tree_above)
  get_filename_component(CMAKE_SOURCE_DIR "${FlipFlop_SOURCE_DIR}" DIRECTORY)
  if(CMAKE_SOURCE_DIR STREQUAL "/")
    set(CMAKE_SOURCE_DIR "/.") # a checkout in /src: "//src" would be another file to ninja
  endif()
endmacro()

# flipflop_build_module(): builds it against VTK. (Against ParaView: Plugin/CMakeLists.txt.)
function(flipflop_build_module)
  flipflop_begin_source_tree_above()
  vtk_module_build(
    MODULES FlipFlop::FiltersFlipFlop
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
endfunction()
