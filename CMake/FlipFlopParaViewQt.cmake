# FLIPFLOP_QT: the major version of the Qt that ParaView's window is made of. ParaView tells it from 5.12 on; before,
# there was Qt 5 alone.
if(PARAVIEW_QT_MAJOR_VERSION)
  set(FLIPFLOP_QT "${PARAVIEW_QT_MAJOR_VERSION}")
else()
  set(FLIPFLOP_QT 5)
endif()
