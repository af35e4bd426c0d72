# For Windows by MinGW-w64, from Linux; Scripts/mingw.sh has made build/mingw-root.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
# The variant that has std::thread.
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)

get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}/../build/mingw-root" ABSOLUTE)
set(CMAKE_CXX_FLAGS_INIT "-isystem ${root}/include")
# Static: where programs run, none of the compiler's libraries may be missing.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static -L${root}/lib")

set(CMAKE_PREFIX_PATH "${root}")
set(CMAKE_FIND_ROOT_PATH "${root}" /usr/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

find_program(FLIPFLOP_WINE NAMES wine wine64)
if(FLIPFLOP_WINE)
  set(CMAKE_CROSSCOMPILING_EMULATOR "${FLIPFLOP_WINE}")
endif()
