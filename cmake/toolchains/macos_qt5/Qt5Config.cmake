# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Qt 5.15 as pymeshlab's wheel for macOS has it: the headers and moc are Debian's, of the same
# minor version; the libraries are the wheel's.
set(qt_headers "${INDEXBOOLEAN_CROSS_ROOT}/include/qt5")
foreach(module Core Gui Widgets OpenGL Xml)
	add_library(Qt5::${module} INTERFACE IMPORTED)
	target_include_directories(Qt5::${module} INTERFACE "${qt_headers}" "${qt_headers}/Qt${module}")
	target_link_libraries(Qt5::${module} INTERFACE
		"${INDEXBOOLEAN_CROSS_ROOT}/lib/Qt${module}.tbd")
endforeach()
target_include_directories(Qt5::Core INTERFACE
	/usr/lib/x86_64-linux-gnu/qt5/mkspecs/macx-clang)
target_compile_definitions(Qt5::Core INTERFACE QT_NO_DEBUG)
# CMake's AUTOMOC asks for these.
set_target_properties(Qt5::Core PROPERTIES
	INTERFACE_QT_MAJOR_VERSION 5 COMPATIBLE_INTERFACE_STRING QT_MAJOR_VERSION)
set_property(DIRECTORY "${PROJECT_SOURCE_DIR}" PROPERTY Qt5Core_VERSION_MAJOR 5)
set_property(DIRECTORY "${PROJECT_SOURCE_DIR}" PROPERTY Qt5Core_VERSION_MINOR 15)
if(NOT TARGET Qt5::moc)
	add_executable(Qt5::moc IMPORTED)
	set_target_properties(Qt5::moc PROPERTIES IMPORTED_LOCATION /usr/lib/qt5/bin/moc)
endif()
