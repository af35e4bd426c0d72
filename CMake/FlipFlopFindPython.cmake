# Sets Python3_EXECUTABLE, unless it is given, to the first python3 that can import VTK.
#
# A python3 early in PATH (pyenv's, conda's) need not be the one that the VTK at hand was built for.
if(NOT Python3_EXECUTABLE AND NOT Python3_ROOT_DIR)
  foreach(python IN ITEMS python3 /usr/bin/python3)
    execute_process(
      COMMAND "${python}" -c "import sys, vtkmodules.vtkCommonCore; print(sys.executable)"
      RESULT_VARIABLE failed
      OUTPUT_VARIABLE found
      OUTPUT_STRIP_TRAILING_WHITESPACE
      ERROR_QUIET)
    if(NOT failed)
      set(Python3_EXECUTABLE "${found}" CACHE FILEPATH "The Python that VTK was built for")
      break()
    endif()
  endforeach()
endif()
