// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <assimp/cimport.h>
#include <assimp/material.h>

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// The functions of assimp that are called.
struct Assimp_functions
{
  decltype(&aiImportFileExWithProperties) import_file = nullptr;
  decltype(&aiReleaseImport) release_import = nullptr;
  decltype(&aiGetErrorString) error_string = nullptr;
  decltype(&aiCreatePropertyStore) create_property_store = nullptr;
  decltype(&aiReleasePropertyStore) release_property_store = nullptr;
  decltype(&aiSetImportPropertyInteger) set_property = nullptr;
  decltype(&aiGetMaterialString) material_string = nullptr;
  decltype(&aiGetMaterialColor) material_colour = nullptr;
  decltype(&aiGetMaterialFloatArray) material_numbers = nullptr;
  decltype(&aiGetMaterialIntegerArray) material_integers = nullptr;
  decltype(&aiGetMaterialTexture) material_texture = nullptr;
};

/// Those of the assimp that the package was built with. A shared library of assimp is loaded at the first call, since
/// that takes longer than the match of two shapes of which the graphs are known. \throw Invalid_input if it cannot be
const Assimp_functions& assimp_functions();

/// Those of the first of some shared libraries that can be loaded. It stays loaded.
/// \throw Invalid_input if none can be; says why of the first
Assimp_functions loaded_assimp_functions(const std::vector<std::string>& libraries);

} // namespace CGAL::Shape_correspondence::IO
