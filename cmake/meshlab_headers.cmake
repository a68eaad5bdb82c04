# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# in: MESHLAB_SOURCE_DIR (cache or environment), else what tools/fetch_headers fetches;
# out: the targets a plugin is built with, or a STATUS sentence that says what is missing.
#   meshlab::headers  MeshLab's src/common, vcglib and Eigen as system headers
#   meshlab::common   the above, Qt, the host's version and scalar, and a stub of the host's library
set(MESHLAB_SOURCE_DIR "$ENV{MESHLAB_SOURCE_DIR}" CACHE PATH
	"MeshLab source tree with its vcglib; empty: fetched from Debian's source package")
set(MESHLAB_VERSION 2025.07)
set(INDEXBOOLEAN_SCALAR double CACHE STRING "The host's scalar: double (pymeshlab) or float (GUI)")

# Sets meshlab_dir in the caller to a tree of the pinned version, or to an empty string.
function(locate_meshlab_source)
	set(fetched "${PROJECT_SOURCE_DIR}/build/meshlab-${MESHLAB_VERSION}")
	set(dir "${MESHLAB_SOURCE_DIR}")
	if(NOT dir)
		set(dir "${fetched}")
		if(NOT EXISTS "${dir}/ML_VERSION")
			execute_process(COMMAND "${PROJECT_SOURCE_DIR}/tools/fetch_headers" "${dir}")
		endif()
	endif()
	set(meshlab_dir "" PARENT_SCOPE)
	if(NOT EXISTS "${dir}/src/common" OR NOT EXISTS "${dir}/src/vcglib/vcg")
		message(STATUS "MeshLab's headers are not here: set MESHLAB_SOURCE_DIR to a MeshLab "
			"${MESHLAB_VERSION} source tree (with vcglib), or let tools/fetch_headers get Debian's "
			"source package")
		return()
	endif()
	file(STRINGS "${dir}/ML_VERSION" found LIMIT_COUNT 1)
	if(NOT found STREQUAL MESHLAB_VERSION)
		message(STATUS "${dir} is MeshLab ${found}, needed is ${MESHLAB_VERSION}")
		return()
	endif()
	set(meshlab_dir "${dir}" PARENT_SCOPE)
endfunction()

# An empty library of the host's name. The plugin's undefined symbols are found at load time in the
# host's own copy, so that one build serves every host of this version.
function(add_meshlab_stub)
	set(empty "${CMAKE_CURRENT_BINARY_DIR}/meshlab_stub.cpp")
	file(CONFIGURE OUTPUT "${empty}" CONTENT "")
	add_library(meshlab_common_stub SHARED "${empty}")
	set_target_properties(meshlab_common_stub PROPERTIES OUTPUT_NAME meshlab-common
		LIBRARY_OUTPUT_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/meshlab_stub")
endfunction()

function(find_meshlab_headers)
	locate_meshlab_source()
	if(NOT meshlab_dir)
		return()
	endif()
	find_path(EIGEN_INCLUDE_DIR Eigen/Core PATHS "${meshlab_dir}/src/vcglib/eigenlib"
		PATH_SUFFIXES eigen3)
	if(NOT EIGEN_INCLUDE_DIR)
		message(STATUS "Eigen is not here (Debian: libeigen3-dev)")
		return()
	endif()
	add_library(meshlab_headers INTERFACE)
	add_library(meshlab::headers ALIAS meshlab_headers)
	target_include_directories(meshlab_headers SYSTEM INTERFACE
		"${meshlab_dir}/src" "${meshlab_dir}/src/vcglib" "${EIGEN_INCLUDE_DIR}")

	find_package(Qt5 5.15 COMPONENTS Core Gui Widgets OpenGL Xml)
	find_path(GLEW_INCLUDE_DIR GL/glew.h)
	if(NOT Qt5_FOUND OR NOT GLEW_INCLUDE_DIR)
		message(STATUS "Qt 5.15 or GLEW is not here (Debian: qtbase5-dev libqt5opengl5-dev "
			"libglew-dev)")
		return()
	endif()
	add_meshlab_stub()
	add_library(meshlab_common INTERFACE)
	add_library(meshlab::common ALIAS meshlab_common)
	target_compile_definitions(meshlab_common INTERFACE
		MESHLAB_VERSION=${MESHLAB_VERSION} MESHLAB_SCALAR=${INDEXBOOLEAN_SCALAR})
	target_link_libraries(meshlab_common INTERFACE meshlab_headers meshlab_common_stub
		Qt5::Core Qt5::Gui Qt5::Widgets Qt5::OpenGL Qt5::Xml)
	target_link_options(meshlab_common INTERFACE
		LINKER:--no-as-needed LINKER:-z,undefs LINKER:--allow-shlib-undefined)
endfunction()
