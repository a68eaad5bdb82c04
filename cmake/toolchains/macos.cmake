# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# pymeshlab's plugin for macOS, made on Debian: zig's clang compiles with the headers that zig has
# of macOS, LLVM's ld64.lld links and signs. INDEXBOOLEAN_CROSS_ROOT is the folder that
# tools/macos_root.py has made: bin/c++ and bin/ar; include/, headers that belong to no system; and
# lib/, of each library a stub with the names that it is known to export.
set(CMAKE_SYSTEM_NAME Darwin)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES INDEXBOOLEAN_CROSS_ROOT)
file(STRINGS "${INDEXBOOLEAN_CROSS_ROOT}/architecture" CMAKE_SYSTEM_PROCESSOR)
set(CMAKE_CXX_COMPILER "${INDEXBOOLEAN_CROSS_ROOT}/bin/c++")
set(CMAKE_AR "${INDEXBOOLEAN_CROSS_ROOT}/bin/ar" CACHE FILEPATH "")
# The C++ library is that of macOS, so its headers are told to use of it only what the least version
# has; zig would link its own. Boost 1.74 derives from what C++17 has taken out of the library.
set(CMAKE_CXX_FLAGS_INIT "-isystem ${INDEXBOOLEAN_CROSS_ROOT}/include \
-U_LIBCPP_HAS_VENDOR_AVAILABILITY_ANNOTATIONS -D_LIBCPP_HAS_VENDOR_AVAILABILITY_ANNOTATIONS=1 \
-D_LIBCPP_ENABLE_CXX17_REMOVED_UNARY_BINARY_FUNCTION")
# zig takes -O3 for -O2, and for debug information. Boost's exceptions name their files.
set(CMAKE_CXX_FLAGS_RELEASE_INIT
	"-Xclang -O3 -g0 -fmacro-prefix-map=${INDEXBOOLEAN_CROSS_ROOT}/include/=")
set(CMAKE_OSX_SYSROOT "")
set(CMAKE_FIND_ROOT_PATH "${INDEXBOOLEAN_CROSS_ROOT}")
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)

# Nothing but the plugin is linked, and that not by the compiler. What is signed must not change.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_USER_MAKE_RULES_OVERRIDE_CXX "${CMAKE_CURRENT_LIST_DIR}/macos_link.cmake")
set(CMAKE_SKIP_RPATH ON)
foreach(tool RANLIB STRIP INSTALL_NAME_TOOL)
	set(CMAKE_${tool} /bin/true CACHE FILEPATH "")
endforeach()

set(Qt5_DIR "${CMAKE_CURRENT_LIST_DIR}/macos_qt5" CACHE PATH "")
set(MESHLAB_COMMON_LIBRARY "${INDEXBOOLEAN_CROSS_ROOT}/lib/libmeshlab-common.tbd" CACHE FILEPATH "")
