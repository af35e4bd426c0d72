# What find_package(FlipFlop) needs, in the build tree and installed; and the engines' own install rules.
include(CMakePackageConfigHelpers)

set(FlipFlop_CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/FlipFlop")
set(config_dir "${CMAKE_BINARY_DIR}/${FlipFlop_CMAKE_DESTINATION}")

install(DIRECTORY Engine/include/flipflop Cuda/include/flipflop
  DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT development)

# An export set each: who wants the CPU engine alone needs no CUDA toolkit. vtk_module_build() exports and
# installs the filters' targets in the same way.
foreach(engine IN ITEMS Engine Cuda)
  set_target_properties(FlipFlop${engine} PROPERTIES
    EXPORT_NAME ${engine}
    INTERFACE_INCLUDE_DIRECTORIES
      "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/${engine}/include>;$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
  install(TARGETS FlipFlop${engine} EXPORT FlipFlop${engine}
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development)
  install(EXPORT FlipFlop${engine}
    NAMESPACE FlipFlop::
    FILE FlipFlop${engine}-targets.cmake
    DESTINATION "${FlipFlop_CMAKE_DESTINATION}"
    COMPONENT development)
  export(EXPORT FlipFlop${engine}
    NAMESPACE FlipFlop::
    FILE "${config_dir}/FlipFlop${engine}-targets.cmake")
endforeach()

get_property(FLIPFLOP_USE_DIY GLOBAL PROPERTY FLIPFLOP_USE_DIY)
configure_package_config_file(CMake/FlipFlopConfig.cmake.in "${config_dir}/FlipFlopConfig.cmake"
  INSTALL_DESTINATION "${FlipFlop_CMAKE_DESTINATION}")
write_basic_package_version_file("${config_dir}/FlipFlopConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${config_dir}/FlipFlopConfig.cmake"
  "${config_dir}/FlipFlopConfigVersion.cmake"
  DESTINATION "${FlipFlop_CMAKE_DESTINATION}"
  COMPONENT development)
install(FILES LICENSE
  DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/licenses/FlipFlop"
  COMPONENT runtime)
