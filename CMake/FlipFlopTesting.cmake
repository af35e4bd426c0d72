# flipflop_leave_out(<what>): says that some tests are left out because this machine lacks what they take, or,
# with FLIPFLOP_ALL_TESTS, stops.
#
# FLIPFLOP_NIGHTLY: the tests that take long, or test the tests. Scripts/nightly.sh runs them, CI does not.
option(FLIPFLOP_NIGHTLY "Build and run the nightly tests, too" OFF)
option(FLIPFLOP_ALL_TESTS "Stop where this machine cannot run some of the tests" OFF)

function(flipflop_leave_out what)
  if(FLIPFLOP_ALL_TESTS)
    message(FATAL_ERROR "FLIPFLOP_ALL_TESTS is on, and this machine cannot run ${what}")
  endif()
  message(STATUS "Left out: ${what}")
endfunction()
