# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# in: INDEXBOOLEAN_HOSTS and, for each version of MeshLab among them, a source tree: the one that
# MESHLAB_SOURCE_DIR (2025.07) or MESHLAB_2020_09_SOURCE_DIR names, as a cache or environment
# variable, else what tools/fetch_headers fetches; out: the targets a plugin is built with, or a
# STATUS sentence that says what is missing.
#   meshlab::headers  vcglib of MeshLab 2025.07 and Eigen, as system headers
#   meshlab::<host>   MeshLab's src/common, its vcglib, Eigen, Qt, the host's version and scalar, and
#                     the host's library: MESHLAB_COMMON_LIBRARY, or what stands in for it
set(INDEXBOOLEAN_HOSTS pymeshlab CACHE STRING
	"What to build the plugin for, a list of: pymeshlab meshlab-2025.07 meshlab-2020.09")
set(MESHLAB_SOURCE_DIR "$ENV{MESHLAB_SOURCE_DIR}" CACHE PATH
	"MeshLab 2025.07 source tree with its vcglib; empty: fetched from Debian's source package")
set(MESHLAB_2020_09_SOURCE_DIR "$ENV{MESHLAB_2020_09_SOURCE_DIR}" CACHE PATH
	"MeshLab 2020.09 source tree with its vcglib; empty: fetched from Debian's source package")
set(MESHLAB_COMMON_LIBRARY "" CACHE FILEPATH
	"MeshLab's own meshlab-common to link with (its import library on Windows); empty: a stub, which \
Windows has not")

# host: MeshLab's version, its scalar, the folder of filter_indexboolean/hosts/ with the adapter
set(host_pymeshlab 2025.07 double meshlab_2025_07)
set(host_meshlab-2025.07 2025.07 float meshlab_2025_07)
set(host_meshlab-2020.09 2020.09 float meshlab_2020_09)

function(meshlab_api_of host out)
	list(GET host_${host} 2 api)
	set(${out} ${api} PARENT_SCOPE)
endfunction()

# Sets meshlab_dir in the caller to a tree of that version, or to an empty string.
function(locate_meshlab_source version variable)
	set(meshlab_dir "" PARENT_SCOPE)
	set(dir "${${variable}}")
	if(NOT dir)
		set(dir "${PROJECT_SOURCE_DIR}/build/meshlab-${version}")
		if(NOT EXISTS "${dir}/ML_VERSION")
			execute_process(COMMAND "${PROJECT_SOURCE_DIR}/tools/fetch_headers" ${version} "${dir}")
		endif()
	endif()
	if(NOT EXISTS "${dir}/src/common")
		message(STATUS "MeshLab's headers are not here: set ${variable} to a MeshLab ${version} "
			"source tree (with vcglib), or let tools/fetch_headers get Debian's source package")
		return()
	endif()
	file(STRINGS "${dir}/ML_VERSION" found LIMIT_COUNT 1)
	if(NOT found STREQUAL version)
		message(STATUS "${dir} is MeshLab ${found}, needed is ${version}")
		return()
	endif()
	set(meshlab_dir "${dir}" PARENT_SCOPE)
endfunction()

# The target meshlab-headers-<version>, if its tree and Eigen are here.
function(add_meshlab_headers version variable)
	locate_meshlab_source(${version} ${variable})
	if(NOT meshlab_dir)
		return()
	endif()
	find_path(vcglib_${version} vcg/complex/complex.h NO_CACHE NO_DEFAULT_PATH
		PATHS "${meshlab_dir}/src/vcglib" "${meshlab_dir}/vcglib")
	find_path(EIGEN_INCLUDE_DIR Eigen/Core
		PATHS "${vcglib_${version}}/eigenlib" PATH_SUFFIXES eigen3)
	if(NOT EIGEN_INCLUDE_DIR OR NOT vcglib_${version})
		message(STATUS "Eigen (Debian: libeigen3-dev) or ${meshlab_dir}'s vcglib is not here")
		return()
	endif()
	add_library(meshlab-headers-${version} INTERFACE)
	target_include_directories(meshlab-headers-${version} SYSTEM INTERFACE
		"${meshlab_dir}/src" "${vcglib_${version}}" "${EIGEN_INCLUDE_DIR}")
endfunction()

# The target meshlab_common: the host's own library if that is given. Else the plugin's undefined
# symbols are found at load time in the host's own copy, so that one build serves every host of its
# version: by an empty library of the same name, on macOS by the linker's leave.
function(add_meshlab_common)
	add_library(meshlab_common INTERFACE)
	if(MESHLAB_COMMON_LIBRARY)
		target_link_libraries(meshlab_common INTERFACE "${MESHLAB_COMMON_LIBRARY}")
	elseif(APPLE)
		target_link_options(meshlab_common INTERFACE LINKER:-undefined,dynamic_lookup)
	else()
		set(empty "${CMAKE_CURRENT_BINARY_DIR}/meshlab_stub.cpp")
		file(CONFIGURE OUTPUT "${empty}" CONTENT "")
		add_library(meshlab_common_stub SHARED "${empty}")
		set_target_properties(meshlab_common_stub PROPERTIES OUTPUT_NAME meshlab-common
			LIBRARY_OUTPUT_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/meshlab_stub")
		target_link_libraries(meshlab_common INTERFACE meshlab_common_stub)
		target_link_options(meshlab_common INTERFACE
			LINKER:--no-as-needed LINKER:-z,undefs LINKER:--allow-shlib-undefined)
	endif()
endfunction()

function(add_meshlab_host host)
	list(GET host_${host} 0 version)
	list(GET host_${host} 1 scalar)
	add_library(meshlab-host-${host} INTERFACE)
	add_library(meshlab::${host} ALIAS meshlab-host-${host})
	target_compile_definitions(meshlab-host-${host} INTERFACE
		MESHLAB_VERSION=${version} MESHLAB_SCALAR=${scalar})
	target_link_libraries(meshlab-host-${host} INTERFACE meshlab-headers-${version}
		meshlab_common Qt5::Core Qt5::Gui Qt5::Widgets Qt5::OpenGL Qt5::Xml)
endfunction()

function(find_meshlab_headers)
	if(INDEXBOOLEAN_HOSTS MATCHES "2020\\.09")
		add_meshlab_headers(2020.09 MESHLAB_2020_09_SOURCE_DIR)
	endif()
	add_meshlab_headers(2025.07 MESHLAB_SOURCE_DIR)
	if(TARGET meshlab-headers-2025.07)
		add_library(meshlab::headers ALIAS meshlab-headers-2025.07)
	endif()
	find_package(Qt5 5.15 COMPONENTS Core Gui Widgets OpenGL Xml)
	find_path(GLEW_INCLUDE_DIR GL/glew.h)
	if(NOT Qt5_FOUND OR NOT GLEW_INCLUDE_DIR)
		message(STATUS "Qt 5.15 or GLEW is not here (Debian: qtbase5-dev libqt5opengl5-dev "
			"libglew-dev)")
		return()
	endif()
	if(WIN32 AND NOT MESHLAB_COMMON_LIBRARY)
		message(STATUS "Windows links plugins with MeshLab's own import library: set "
			"MESHLAB_COMMON_LIBRARY to the meshlab-common.lib of a MeshLab build")
		return()
	endif()
	add_meshlab_common()
	foreach(host IN LISTS INDEXBOOLEAN_HOSTS)
		if(NOT DEFINED host_${host})
			message(FATAL_ERROR "INDEXBOOLEAN_HOSTS: there is no host \"${host}\"")
		endif()
		list(GET host_${host} 0 version)
		if(TARGET meshlab-headers-${version})
			add_meshlab_host(${host})
		endif()
	endforeach()
endfunction()
