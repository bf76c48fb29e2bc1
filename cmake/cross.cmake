# cross.cmake -- the toolchain of tests/platforms.sh: Debian's cross compiler for SCREE_TARGET, for example aarch64-linux-gnu.
#
# Tests run by the program in SCREE_EMULATOR, with its arguments. Libraries of this system are not searched.
set(SCREE_TARGET "" CACHE STRING "GNU name of the system to build for")
set(SCREE_EMULATOR "" CACHE STRING "Program that runs programs of that system")
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES SCREE_TARGET SCREE_EMULATOR)

string(REGEX MATCH "^[^-]+" CMAKE_SYSTEM_PROCESSOR "${SCREE_TARGET}")
if(SCREE_TARGET MATCHES "mingw")
	set(CMAKE_SYSTEM_NAME Windows)
	set(CMAKE_RC_COMPILER ${SCREE_TARGET}-windres)
else()
	set(CMAKE_SYSTEM_NAME Linux)
endif()
set(CMAKE_C_COMPILER ${SCREE_TARGET}-gcc)
set(CMAKE_CXX_COMPILER ${SCREE_TARGET}-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR ${SCREE_EMULATOR})
set(CMAKE_DISABLE_FIND_PACKAGE_PkgConfig ON)
set(CMAKE_FIND_ROOT_PATH /usr/${SCREE_TARGET})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
