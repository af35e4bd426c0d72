# The flags that every target of ours is built with.
#
# flipflop_compile_options(<target>): C++17 at least, warnings, the rules that exactness depends on, whose threads

function(flipflop_compile_options target)
  target_compile_features(${target} PRIVATE cxx_std_17) # a host's later standard stays
  # A contracted a*b-c*d is no longer antisymmetric: the predicates' signs would depend on the compiler.
  # (CUDA sources: see FlipFlopCuda.cmake.)
  set(gcc_like $<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>)
  set(msvc $<COMPILE_LANG_AND_ID:CXX,MSVC>)
  target_compile_options(${target} PRIVATE
    $<${gcc_like}:-ffp-contract=off>
    # A host's flags may have parts of -ffast-math that no macro reveals (Support/StrictArithmetic.h stops the others).
    $<${gcc_like}:-fno-unsafe-math-optimizations>
    $<${gcc_like}:-Wall -Wextra -Wconversion -Wno-sign-conversion>
    # A constructor's parameter may have the name of the member it sets.
    $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wshadow=local>
    $<$<COMPILE_LANG_AND_ID:CXX,Clang,AppleClang>:-Wshadow>
    $<${msvc}:/fp:precise /W4>)
  target_compile_definitions(${target} PRIVATE "FLIPFLOP_THREADS_HEADER=\"${FLIPFLOP_THREADS_HEADER}\"")
  if(FLIPFLOP_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE $<${gcc_like}:-Werror> $<${msvc}:/WX>)
  endif()
endfunction()

# flipflop_vtk_standard(<target>): C++17 for what includes VTK's headers where these are no later C++: those of VTK 9.1
# (vtkSMPTools.h, DIY's) are not.
function(flipflop_vtk_standard target)
  if(VTK_VERSION VERSION_LESS 9.3)
    set_target_properties(${target} PROPERTIES CXX_STANDARD 17)
  endif()
endfunction()

if(FLIPFLOP_SANITIZE)
  add_compile_options(-fsanitize=${FLIPFLOP_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${FLIPFLOP_SANITIZE})
  if(FLIPFLOP_SANITIZE STREQUAL "address,undefined")
    # AddressSanitizer finds these, too, and they are a quarter of the time to compile.
    add_compile_options(-fno-sanitize=null,object-size)
  endif()
endif()
