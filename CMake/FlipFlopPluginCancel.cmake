# Can the plugin FlipFlopCancel be built (Plugin/Cancel)?
#
# FLIPFLOP_PLUGIN_CANCEL: AUTO (the default) builds it where ParaView has its user interface and the
# development files of its Qt and of XCB are found, ON insists on them, OFF does without. In ParaView 6 it is not
# right yet (a cancelled filter can run again, unasked): AUTO leaves it out there, ON builds it to be worked on.
#
# Adds the plugin.
set(FLIPFLOP_PLUGIN_CANCEL AUTO CACHE STRING "Build the plugin FlipFlopCancel: AUTO, ON or OFF")
set_property(CACHE FLIPFLOP_PLUGIN_CANCEL PROPERTY STRINGS AUTO ON OFF)

if(FLIPFLOP_PLUGIN_CANCEL STREQUAL "AUTO" AND FLIPFLOP_QT GREATER 5)
  message(STATUS "No plugin FlipFlopCancel, FlipFlop alone: it is not right yet in ParaView with Qt ${FLIPFLOP_QT}")
elseif(FLIPFLOP_PLUGIN_CANCEL)
  find_package(Qt${FLIPFLOP_QT} 5.12 QUIET COMPONENTS Widgets)
  find_path(FLIPFLOP_XCB_INCLUDE_DIR xcb/xcb.h)
  find_library(FLIPFLOP_XCB_LIBRARY xcb)
  mark_as_advanced(FLIPFLOP_XCB_INCLUDE_DIR FLIPFLOP_XCB_LIBRARY)

  set(missing)
  if(NOT PARAVIEW_USE_QT OR NOT TARGET ParaView::pqCore)
    list(APPEND missing "ParaView's user interface")
  endif()
  if(NOT Qt${FLIPFLOP_QT}_FOUND)
    list(APPEND missing "Qt ${FLIPFLOP_QT}'s development files")
  endif()
  if(NOT FLIPFLOP_XCB_INCLUDE_DIR OR NOT FLIPFLOP_XCB_LIBRARY)
    list(APPEND missing "XCB's development files")
  endif()
  list(JOIN missing ", " missing)
  if(NOT missing)
    add_subdirectory(Plugin/Cancel)
  elseif(FLIPFLOP_PLUGIN_CANCEL STREQUAL "AUTO")
    message(STATUS "No plugin FlipFlopCancel, FlipFlop alone: without ${missing}")
  else()
    message(FATAL_ERROR "FLIPFLOP_PLUGIN_CANCEL is ${FLIPFLOP_PLUGIN_CANCEL}, and there is no: ${missing}")
  endif()
endif()
