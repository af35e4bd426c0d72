# The target `documentation`: the Markdown pages and the API of the public headers as HTML, by Doxygen, in
# Documentation/html of the build tree; and its tests.
#
# Public are the engines' installed headers (FlipFlopPackage), and of the filters' those that export a class of its own,
# not one inside another (vtkInternals).
find_package(Doxygen REQUIRED COMPONENTS dot)
find_package(Python3 REQUIRED COMPONENTS Interpreter)

# What Doxygen warns of changes between its versions; that of Debian 12 counts. An older one (Ubuntu 22.04's)
# knows less than Doxyfile.in asks for.
if(DOXYGEN_VERSION VERSION_LESS 1.9.4)
  message(WARNING "Left out: the documentation, which takes Doxygen 1.9.4; here is ${DOXYGEN_VERSION}")
  return()
endif()
set(documentation_warnings NO)
if(DOXYGEN_VERSION VERSION_EQUAL 1.9.4)
  set(documentation_warnings FAIL_ON_WARNINGS)
endif()

file(GLOB public_headers CONFIGURE_DEPENDS
  "${PROJECT_SOURCE_DIR}/Engine/include/flipflop/*.h" "${PROJECT_SOURCE_DIR}/Cuda/include/flipflop/*.h")
file(GLOB filter_headers CONFIGURE_DEPENDS
  "${PROJECT_SOURCE_DIR}/Filters/*.h" "${PROJECT_SOURCE_DIR}/Filters/Parallel/*.h")
foreach(header IN LISTS filter_headers)
  file(STRINGS "${header}" exported REGEX "^class VTKFILTERS(PARALLEL)?FLIPFLOP_EXPORT [A-Za-z_ ]+( : |$)")
  if(exported)
    list(APPEND public_headers "${header}")
  endif()
endforeach()

# In the order of the navigation's tree.
file(GLOB pages CONFIGURE_DEPENDS
  "${PROJECT_SOURCE_DIR}/Documentation/*.md" "${PROJECT_SOURCE_DIR}/Documentation/Tutorials/*.md"
  "${PROJECT_SOURCE_DIR}/Documentation/*.dox")
file(GLOB further_pages CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/*.md" "${PROJECT_SOURCE_DIR}/Data/*.md"
  "${PROJECT_SOURCE_DIR}/Benchmarks/*.md")

set(documentation_folder "${PROJECT_BINARY_DIR}/Documentation")
set(documentation_input ${pages} ${further_pages} ${public_headers})
list(TRANSFORM documentation_input REPLACE "(.+)" "\"\\1\"")
list(JOIN documentation_input " \\\n                         " documentation_input)
configure_file("${PROJECT_SOURCE_DIR}/Documentation/Doxyfile.in" "${documentation_folder}/Doxyfile" @ONLY)

set(write_documentation
  "${CMAKE_COMMAND}" -E env PYTHONDONTWRITEBYTECODE=1
  "${DOXYGEN_EXECUTABLE}" "${documentation_folder}/Doxyfile")
add_custom_target(documentation
  COMMAND ${write_documentation}
  COMMENT "Writing ${documentation_folder}/html"
  VERBATIM)
if(BUILD_TESTING)
  add_test(NAME Documentation COMMAND ${write_documentation})
  add_test(NAME Documentation-TestHtml
    COMMAND "${Python3_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/Testing/Documentation/TestHtml.py" -v)
  set_tests_properties(Documentation PROPERTIES
    LABELS "documentation"
    FIXTURES_SETUP html
    TIMEOUT 300)
  set_tests_properties(Documentation-TestHtml PROPERTIES
    LABELS "documentation"
    FIXTURES_REQUIRED html
    ENVIRONMENT "FLIPFLOP_HTML=${documentation_folder}/html;PYTHONDONTWRITEBYTECODE=1"
    TIMEOUT 60)
endif()
