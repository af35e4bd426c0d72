# Installs the build tree into a folder, then configures, builds and tests users of the installed package:
# the C++ examples, and programs that want an engine without VTK. Neither needs Boost, whose headers no public header has.
#
#   cmake -D BINARY_DIR=... -D SOURCE_DIR=... -D WORK_DIR=... -D GENERATOR=... -D LIBDIR=... -P RunPackage.cmake
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE failed)
  if(failed)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "failed: ${command}")
  endif()
endfunction()

file(REMOVE_RECURSE "${WORK_DIR}")
run("${CMAKE_COMMAND}" --install "${BINARY_DIR}" --prefix "${WORK_DIR}/prefix")

# Installed here and there, the package must find itself wherever it is taken.
file(RENAME "${WORK_DIR}/prefix" "${WORK_DIR}/moved")

# The project of the page for C++ users: its first block of CMake and README's program, both as they stand there.
file(READ "${SOURCE_DIR}/Documentation/Cxx.md" page)
string(REGEX MATCH "```cmake\n([^`]*)```" block "${page}")
file(WRITE "${WORK_DIR}/user/CMakeLists.txt" "${CMAKE_MATCH_1}
enable_testing()
add_test(NAME app COMMAND app WORKING_DIRECTORY \"${SOURCE_DIR}\")
set_tests_properties(app PROPERTIES PASS_REGULAR_EXPRESSION \"305 vertices, 596 facets\")
")
file(READ "${SOURCE_DIR}/README.md" page)
string(REGEX MATCH "```cpp\n([^`]*)```" block "${page}")
file(WRITE "${WORK_DIR}/user/main.cxx" "${CMAKE_MATCH_1}")

foreach(user IN ITEMS "${WORK_DIR}/user" "${SOURCE_DIR}/Examples/Cxx" "${SOURCE_DIR}/Testing/Cxx/Package")
  string(MAKE_C_IDENTIFIER "${user}" name)
  run("${CMAKE_COMMAND}" -S "${user}" -B "${WORK_DIR}/${name}" -G "${GENERATOR}"
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_DISABLE_FIND_PACKAGE_Boost=ON
    "-DFlipFlop_DIR=${WORK_DIR}/moved/${LIBDIR}/cmake/FlipFlop")
  run("${CMAKE_COMMAND}" --build "${WORK_DIR}/${name}")
  run("${CMAKE_CTEST_COMMAND}" --test-dir "${WORK_DIR}/${name}" --output-on-failure --no-tests=error)
endforeach()
