# The plugin's tree: the module built against ParaView's own VTK, the plugin around it, and the Python
# package for pvpython. A VTK build and this one exclude each other: every VTK has a tree of its own.
#
# For its deployment, Qt 6 would walk through the project's folders, for ever: the module's folder, the project's own, is
# one of them (FlipFlopModule.cmake). Qt deploys nothing here: tell it that this has been seen to.
set_property(GLOBAL PROPERTY _qt_have_generated_deploy_support TRUE)
find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingCore RemotingServerManager)
include(FlipFlopParaViewQt)
include(FlipFlopPluginHelp)

include(FlipFlopModule)
set(files "${CMAKE_CURRENT_SOURCE_DIR}/Plugin/paraview.plugin")
find_package(Qt${FLIPFLOP_QT} 5.12 QUIET COMPONENTS Core)
if(PARAVIEW_USE_QT AND Qt${FLIPFLOP_QT}_FOUND)
  list(APPEND files "${CMAKE_CURRENT_SOURCE_DIR}/Plugin/Icons/paraview.plugin")
else()
  message(STATUS "No plugin FlipFlopIcons: without ParaView's window or the development files of its Qt")
endif()
paraview_plugin_scan(
  PLUGIN_FILES ${files}
  PROVIDES_PLUGINS plugins
  ENABLE_BY_DEFAULT ON
  HIDE_PLUGINS_FROM_CACHE ON)
paraview_plugin_build(
  PLUGINS ${plugins}
  LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}"
  PLUGINS_FILE_NAME "flipflop.plugins.xml"
  INSTALL_HEADERS OFF
  DISABLE_XML_DOCUMENTATION "${FLIPFLOP_WITHOUT_HELP}")

# PV_PLUGIN_PATH for the build tree; installed, it is the same folder below the prefix.
set(FLIPFLOP_LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/FlipFlop")
set(FLIPFLOP_PLUGIN_PATH "${CMAKE_BINARY_DIR}/${FLIPFLOP_LIBRARY_DESTINATION}"
  CACHE INTERNAL "The folder that holds the plugin in the build tree")

if(FLIPFLOP_WRAP_PYTHON)
  add_subdirectory(Wrapping)
endif()
install(FILES LICENSE
  DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/licenses/FlipFlop"
  COMPONENT runtime)

if(BUILD_TESTING)
  add_subdirectory(Testing/ParaView)
endif()
