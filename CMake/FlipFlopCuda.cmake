# Is there a CUDA compiler, and how is it called?
#
# FLIPFLOP_CUDA: AUTO (the default) builds the CUDA engine's kernels where a compiler of CUDA 12 or later is
# found, ON insists on one, OFF does without.
# CMAKE_CUDA_ARCHITECTURES: by default those of the devices at hand. Where there is none, all that the compiler knows
# from 7.5 on, and PTX for devices newer than these.
#
# Sets FLIPFLOP_USE_CUDA. flipflop_cuda_options(<target>): the rules that exactness depends on.
set(FLIPFLOP_CUDA AUTO CACHE STRING "Build the CUDA engine: AUTO, ON or OFF")
set_property(CACHE FLIPFLOP_CUDA PROPERTY STRINGS AUTO ON OFF)

set(FLIPFLOP_USE_CUDA OFF)
if(FLIPFLOP_CUDA)
  include(CheckLanguage)
  check_language(CUDA)
  if(CMAKE_CUDA_COMPILER)
    if(NOT DEFINED CMAKE_CUDA_ARCHITECTURES)
      # "native" stops where there is no device.
      execute_process(COMMAND nvidia-smi --query-gpu=compute_cap --format=csv,noheader
        OUTPUT_VARIABLE found ERROR_QUIET RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE)
      string(REGEX MATCHALL "[0-9]+\\.[0-9]+" found "${found}")
      list(TRANSFORM found REPLACE "\\." "")
      list(REMOVE_DUPLICATES found)
      if(failed OR NOT found)
        execute_process(COMMAND "${CMAKE_CUDA_COMPILER}" --list-gpu-arch OUTPUT_VARIABLE known)
        string(REGEX MATCHALL "[0-9]+" known "${known}")
        list(SORT known COMPARE NATURAL)
        set(found)
        foreach(architecture IN LISTS known)
          if(architecture GREATER_EQUAL 75)
            list(APPEND found ${architecture}-real)
            set(newest ${architecture})
          endif()
        endforeach()
        list(APPEND found ${newest}-virtual)
      endif()
      set(CMAKE_CUDA_ARCHITECTURES "${found}" CACHE STRING "Architectures to build device code for")
    endif()
    set(CMAKE_CUDA_STANDARD 17)
    set(CMAKE_CUDA_STANDARD_REQUIRED ON)
    enable_language(CUDA)
    if(CMAKE_CUDA_COMPILER_VERSION VERSION_LESS 12)
      if(FLIPFLOP_CUDA STREQUAL "AUTO")
        message(STATUS "CUDA ${CMAKE_CUDA_COMPILER_VERSION} is too old: no CUDA engine")
      else()
        message(FATAL_ERROR "The CUDA engine needs CUDA 12 or later, not ${CMAKE_CUDA_COMPILER_VERSION}")
      endif()
    else()
      find_package(CUDAToolkit REQUIRED)
      set(FLIPFLOP_USE_CUDA ON)
    endif()
  elseif(NOT FLIPFLOP_CUDA STREQUAL "AUTO")
    message(FATAL_ERROR "FLIPFLOP_CUDA is ${FLIPFLOP_CUDA}, and no CUDA compiler was found")
  endif()
endif()

function(flipflop_cuda_options target)
  target_compile_options(${target} PRIVATE
    # A contracted a*b-c*d is no longer antisymmetric, on a device as little as on the host.
    "$<$<COMPILE_LANGUAGE:CUDA>:-fmad=false;--expt-relaxed-constexpr>"
    "$<$<COMPILE_LANGUAGE:CUDA>:-Xcompiler=-ffp-contract=off,-Wall,-Wextra,-Wno-sign-conversion>")
  if(FLIPFLOP_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CUDA>:-Werror=all-warnings>)
  endif()
  set_target_properties(${target} PROPERTIES CUDA_RUNTIME_LIBRARY Static)
  target_link_libraries(${target} PUBLIC CUDA::cudart_static)
endfunction()
