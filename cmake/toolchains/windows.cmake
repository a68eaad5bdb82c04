# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Debian's mingw-w64 with POSIX threads, for the core and its tests; what it makes runs under
# Debian's wine64. INDEXBOOLEAN_CROSS_ROOT is the folder in which tools/cross has put what
# belongs to no system (Boost's headers) and GoogleTest for this one.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR AMD64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
# The runtimes of GCC and of its threads are not on a Windows system.
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
set(CMAKE_CROSSCOMPILING_EMULATOR /usr/lib/wine/wine64)

set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES INDEXBOOLEAN_CROSS_ROOT)
set(CMAKE_FIND_ROOT_PATH "${INDEXBOOLEAN_CROSS_ROOT}")
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
