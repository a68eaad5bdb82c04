# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Read by cmake/toolchains/macos.cmake after CMake's own rules for macOS: how a plugin is linked.
# The minimum is that of pymeshlab's wheel.
set(CMAKE_CXX_CREATE_SHARED_MODULE "ld64.lld-19 -bundle -arch ${CMAKE_SYSTEM_PROCESSOR} \
-platform_version macos 11.0 11.0 -adhoc_codesign --error-limit=0 -dead_strip -x -S <LINK_FLAGS> -o <TARGET> \
<OBJECTS> <LINK_LIBRARIES> ${INDEXBOOLEAN_CROSS_ROOT}/lib/libc++.tbd \
${INDEXBOOLEAN_CROSS_ROOT}/lib/libSystem.tbd")
set(CMAKE_CXX_LINKER_WRAPPER_FLAG "")
