# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Link project_warnings PRIVATE to every target whose sources are ours.
add_library(project_warnings INTERFACE)
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
	target_compile_options(project_warnings INTERFACE
		-Wall -Wextra -Wshadow -Wconversion -Werror)
endif()
