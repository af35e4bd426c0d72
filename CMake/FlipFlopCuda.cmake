# Is the CUDA engine built, and for which devices?
#
# FLIPFLOP_CUDA: ON insists on a compiler of CUDA 12 or later, OFF does without the engine. AUTO (the default) builds it
# where nvidia-smi finds a device and there is such a compiler; inside VTK's own build, where VTK_USE_CUDA is on.
# CMAKE_CUDA_ARCHITECTURES: by default those of the devices here. Where there is none, 75: code for the oldest devices that
# the engine runs on, which newer ones translate when it is loaded.
#
# Sets FLIPFLOP_USE_CUDA. flipflop_cuda_options(<target>): the rules that exactness depends on.
set(FLIPFLOP_CUDA AUTO CACHE STRING "Build the CUDA engine: AUTO, ON or OFF")
set_property(CACHE FLIPFLOP_CUDA PROPERTY STRINGS AUTO ON OFF)

# flipflop_find_devices(<variable>): the architectures of the devices here that the engine runs on, as
# CMAKE_CUDA_ARCHITECTURES names them
function(flipflop_find_devices variable)
  execute_process(COMMAND nvidia-smi --query-gpu=compute_cap --format=csv,noheader
    OUTPUT_VARIABLE found ERROR_QUIET RESULT_VARIABLE failed)
  if(failed)
    set(found)
  endif()
  string(REGEX MATCHALL "[0-9]+\\.[0-9]+" found "${found}")
  list(TRANSFORM found REPLACE "\\." "")
  list(REMOVE_DUPLICATES found)
  set(devices)
  foreach(architecture IN LISTS found)
    if(architecture GREATER_EQUAL 75)
      list(APPEND devices ${architecture})
    endif()
  endforeach()
  set(${variable} "${devices}" PARENT_SCOPE)
endfunction()

# Every way out says why, once.
function(flipflop_without_cuda reason)
  if(NOT FLIPFLOP_CUDA STREQUAL "AUTO" AND FLIPFLOP_CUDA)
    message(FATAL_ERROR "FLIPFLOP_CUDA is ${FLIPFLOP_CUDA}, and ${reason}")
  endif()
  message(STATUS "No CUDA engine: ${reason}")
endfunction()

flipflop_find_devices(devices)
set(wanted ON)
if(NOT FLIPFLOP_CUDA)
  flipflop_without_cuda("FLIPFLOP_CUDA is ${FLIPFLOP_CUDA}")
  set(wanted OFF)
elseif(FLIPFLOP_CUDA STREQUAL "AUTO" AND DEFINED VTK_USE_CUDA)
  if(NOT VTK_USE_CUDA)
    flipflop_without_cuda("VTK_USE_CUDA is ${VTK_USE_CUDA}")
    set(wanted OFF)
  endif()
elseif(FLIPFLOP_CUDA STREQUAL "AUTO" AND NOT devices)
  flipflop_without_cuda("nvidia-smi finds no device here that it runs on (FLIPFLOP_CUDA=ON builds it for other machines)")
  set(wanted OFF)
endif()

set(FLIPFLOP_USE_CUDA OFF)
if(wanted)
  include(CheckLanguage)
  check_language(CUDA)
  if(NOT CMAKE_CUDA_COMPILER)
    flipflop_without_cuda("no CUDA compiler was found")
  else()
    if(NOT CMAKE_CUDA_ARCHITECTURES)
      set(CMAKE_CUDA_ARCHITECTURES 75)
      if(devices)
        set(CMAKE_CUDA_ARCHITECTURES "${devices}")
      endif()
    endif()
    set(CMAKE_CUDA_STANDARD 17)
    set(CMAKE_CUDA_STANDARD_REQUIRED ON)
    enable_language(CUDA)
    if(CMAKE_CUDA_COMPILER_VERSION VERSION_LESS 12)
      flipflop_without_cuda("the engine needs CUDA 12 or later, not ${CMAKE_CUDA_COMPILER_VERSION}")
    else()
      find_package(CUDAToolkit REQUIRED)
      set(FLIPFLOP_USE_CUDA ON)
      message(STATUS "The CUDA engine is built for ${CMAKE_CUDA_ARCHITECTURES}")
    endif()
  endif()
endif()

function(flipflop_cuda_options target)
  target_compile_options(${target} PRIVATE
    # A contracted a*b-c*d is no longer antisymmetric, on a device as little as on the host.
    "$<$<COMPILE_LANGUAGE:CUDA>:-fmad=false;-ftz=false;-prec-div=true;-prec-sqrt=true;--expt-relaxed-constexpr>"
    "$<$<COMPILE_LANGUAGE:CUDA>:-Xcompiler=-ffp-contract=off,-fno-unsafe-math-optimizations,-Wall,-Wextra,-Wno-sign-conversion>")
  if(FLIPFLOP_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CUDA>:-Werror=all-warnings>)
  endif()
  set_target_properties(${target} PROPERTIES CUDA_RUNTIME_LIBRARY Static)
  target_link_libraries(${target} PUBLIC CUDA::cudart_static)
endfunction()
