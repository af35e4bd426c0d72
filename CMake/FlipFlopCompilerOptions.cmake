# The flags that every target of ours is built with.
#
# flipflop_compile_options(<target>): warnings, and the rules that exactness depends on

function(flipflop_compile_options target)
  # A contracted a*b-c*d is no longer antisymmetric: the predicates' signs would depend on the compiler.
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-ffp-contract=off>
    $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall -Wextra -Wconversion -Wno-sign-conversion>
    # A constructor's parameter may have the name of the member it sets.
    $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local> $<$<CXX_COMPILER_ID:Clang,AppleClang>:-Wshadow>
    $<$<CXX_COMPILER_ID:MSVC>:/fp:precise /W4>)
  if(FLIPFLOP_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE
      $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Werror> $<$<CXX_COMPILER_ID:MSVC>:/WX>)
  endif()
endfunction()

if(FLIPFLOP_SANITIZE)
  add_compile_options(-fsanitize=${FLIPFLOP_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -g)
  add_link_options(-fsanitize=${FLIPFLOP_SANITIZE})
endif()
