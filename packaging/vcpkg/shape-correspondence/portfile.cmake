# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
# A port of the source tree that it lies in: vcpkg install shape-correspondence --overlay-ports=packaging/vcpkg
get_filename_component(SOURCE_PATH "${CURRENT_PORT_DIR}/../../.." ABSOLUTE)

vcpkg_check_features(OUT_FEATURE_OPTIONS features FEATURES io SHAPE_CORRESPONDENCE_PROGRAM)
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS ${features} -DCMAKE_INSTALL_LIBEXECDIR=bin -DBUILD_TESTING=OFF -DSHAPE_CORRESPONDENCE_EXAMPLES=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME Shape_correspondence CONFIG_PATH lib/cmake/Shape_correspondence)
if("io" IN_LIST FEATURES)
  set(tools shape_correspondence)
  if(NOT VCPKG_TARGET_IS_WINDOWS)
    list(APPEND tools shape_correspondence_import)
  endif()
  vcpkg_copy_tools(TOOL_NAMES ${tools} AUTO_CLEAN)
endif()

file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share"
                    "${CURRENT_PACKAGES_DIR}/share/doc" "${CURRENT_PACKAGES_DIR}/share/man"
                    "${CURRENT_PACKAGES_DIR}/share/bash-completion")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
