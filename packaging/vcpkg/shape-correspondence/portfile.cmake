# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
# A port of the source tree that it lies in: vcpkg install shape-correspondence --overlay-ports=packaging/vcpkg
get_filename_component(SOURCE_PATH "${CURRENT_PORT_DIR}/../../.." ABSOLUTE)

set(page_options "")
if("io" IN_LIST FEATURES) # web pages contain it
  vcpkg_download_distfile(THREE_ARCHIVE
    URLS https://registry.npmjs.org/three/-/three-0.111.0.tgz
    FILENAME three-0.111.0.tgz
    SHA512 01c4eac862771fbe4022eb0eb800f2d0bb0ff79f10290c26fd884004714ccdde911573cd55acb5ae549b6c6e9662feca33bd86d931cc330a9b8d07787551cc91)
  vcpkg_extract_source_archive(THREE_PATH ARCHIVE "${THREE_ARCHIVE}")
  set(page_options "-DSHAPE_CORRESPONDENCE_THREE_JS=${THREE_PATH}/build/three.module.js")
endif()
vcpkg_check_features(OUT_FEATURE_OPTIONS features FEATURES io SHAPE_CORRESPONDENCE_PROGRAM)
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS ${features} ${page_options} -DCMAKE_INSTALL_LIBEXECDIR=bin -DBUILD_TESTING=OFF -DSHAPE_CORRESPONDENCE_EXAMPLES=OFF)
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
