// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/assimp_functions.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <dlfcn.h>

namespace CGAL::Shape_correspondence::IO {
namespace {

std::string loader_error()
{
  const char* const error = dlerror();
  return error ? error : "no reason is known";
}

template <typename Function>
void find_function(void* library, const char* name, Function& function)
{
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (!function) throw Invalid_input("it is read by assimp, which lacks a function (" + loader_error() + ")");
}

void* loaded_library(const std::vector<std::string>& libraries)
{
  std::string first_error;
  for (const std::string& library : libraries) {
    if (void* const result = dlopen(library.c_str(), RTLD_LAZY | RTLD_LOCAL)) return result;
    const std::string error = loader_error();
    if (first_error.empty()) first_error = error;
  }
  throw Invalid_input("it is read by the library assimp, which cannot be loaded (" + first_error + "); install it");
}

} // namespace

Assimp_functions loaded_assimp_functions(const std::vector<std::string>& libraries)
{
  void* const library = loaded_library(libraries);
  Assimp_functions result;
  find_function(library, "aiImportFileExWithProperties", result.import_file);
  find_function(library, "aiReleaseImport", result.release_import);
  find_function(library, "aiGetErrorString", result.error_string);
  find_function(library, "aiCreatePropertyStore", result.create_property_store);
  find_function(library, "aiReleasePropertyStore", result.release_property_store);
  find_function(library, "aiSetImportPropertyInteger", result.set_property);
  find_function(library, "aiGetMaterialString", result.material_string);
  find_function(library, "aiGetMaterialColor", result.material_colour);
  find_function(library, "aiGetMaterialFloatArray", result.material_numbers);
  find_function(library, "aiGetMaterialIntegerArray", result.material_integers);
  find_function(library, "aiGetMaterialTexture", result.material_texture);
  return result;
}

const Assimp_functions& assimp_functions()
{
#ifdef SHAPE_CORRESPONDENCE_ASSIMP_LIBRARIES
  static const Assimp_functions functions = loaded_assimp_functions({SHAPE_CORRESPONDENCE_ASSIMP_LIBRARIES});
#else
  static const Assimp_functions functions{
      aiImportFileExWithProperties, aiReleaseImport,        aiGetErrorString,
      aiCreatePropertyStore,        aiReleasePropertyStore, aiSetImportPropertyInteger,
      aiGetMaterialString,          aiGetMaterialColor,     aiGetMaterialFloatArray,
      aiGetMaterialIntegerArray,    aiGetMaterialTexture};
#endif
  return functions;
}

} // namespace CGAL::Shape_correspondence::IO
