# Can the plugin's help pages be built? ParaView makes them of the XML's texts, with tools of Qt.
#
# FLIPFLOP_PLUGIN_HELP: AUTO (the default) builds the pages where ParaView has a window and the tools are found, ON insists
# on them, OFF does without. The texts are in the panels' tooltips in any case.
#
# Sets FLIPFLOP_WITHOUT_HELP for paraview_plugin_build.
set(FLIPFLOP_PLUGIN_HELP AUTO CACHE STRING "Build the plugin's help pages: AUTO, ON or OFF")
set_property(CACHE FLIPFLOP_PLUGIN_HELP PROPERTY STRINGS AUTO ON OFF)

set(FLIPFLOP_WITHOUT_HELP ON)
if(FLIPFLOP_PLUGIN_HELP)
  # The names that ParaView's own CMake files look for; since 6.0, these take xsltproc as well.
  find_program(qt_xmlpatterns_executable
    NAMES xmlpatterns-qt5 xmlpatterns
    HINTS "${Qt5_DIR}/../../../bin" "${Qt5_DIR}/../../../libexec/qt5/bin")
  find_program(ParaViewClient_xsltproc_executable NAMES xsltproc)
  mark_as_advanced(qt_xmlpatterns_executable ParaViewClient_xsltproc_executable)
  # Qt 6 has the generator among its tools.
  find_package(Qt${FLIPFLOP_QT} QUIET COMPONENTS Help OPTIONAL_COMPONENTS ToolsTools)
  set(missing)
  if(NOT PARAVIEW_USE_QT)
    list(APPEND missing "ParaView's user interface")
  endif()
  if(NOT qt_xmlpatterns_executable
      AND (ParaView_VERSION VERSION_LESS 6.0 OR NOT ParaViewClient_xsltproc_executable))
    list(APPEND missing "xmlpatterns")
  endif()
  if(NOT Qt${FLIPFLOP_QT}Help_FOUND OR NOT TARGET Qt${FLIPFLOP_QT}::qhelpgenerator)
    list(APPEND missing "Qt ${FLIPFLOP_QT}'s Help and its generator")
  endif()
  list(JOIN missing ", " missing)
  if(NOT missing)
    set(FLIPFLOP_WITHOUT_HELP OFF)
  elseif(FLIPFLOP_PLUGIN_HELP STREQUAL "AUTO")
    message(STATUS "No help pages in the plugin: without ${missing}")
  else()
    message(FATAL_ERROR "FLIPFLOP_PLUGIN_HELP is ${FLIPFLOP_PLUGIN_HELP}, and there is no: ${missing}")
  endif()
endif()
