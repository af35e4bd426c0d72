# Whose threads the engine works on. Engine/Support/Parallel.h tells what is asked of them.
#
#   FLIPFLOP_THREADS_HEADER    what Parallel.h includes
#   FLIPFLOP_THREADS_PACKAGE   where CMake finds the library
#   FLIPFLOP_THREADS_LIBRARY   to link
set(FLIPFLOP_THREADS_BACKEND "TBB" CACHE STRING "Whose threads the engine works on: TBB (oneTBB) or STD (std::thread)")
set_property(CACHE FLIPFLOP_THREADS_BACKEND PROPERTY STRINGS TBB STD)

set(FLIPFLOP_THREADS_PACKAGE Threads)
set(FLIPFLOP_THREADS_LIBRARY Threads::Threads)
if(FLIPFLOP_THREADS_BACKEND STREQUAL "STD")
  set(FLIPFLOP_THREADS_HEADER "Support/StdThreads.h")
elseif(FLIPFLOP_THREADS_BACKEND STREQUAL "TBB")
  set(FLIPFLOP_THREADS_HEADER "Support/TbbThreads.h")
  set(FLIPFLOP_THREADS_PACKAGE TBB)
  set(FLIPFLOP_THREADS_LIBRARY TBB::tbb)
else()
  message(FATAL_ERROR "FLIPFLOP_THREADS_BACKEND is TBB or STD, not \"${FLIPFLOP_THREADS_BACKEND}\"")
endif()
find_package(${FLIPFLOP_THREADS_PACKAGE} REQUIRED)
