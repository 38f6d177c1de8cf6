// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/read/Gltf_document.h"

#include <map>
#include <string>

namespace CGAL::Shape_correspondence::IO {

/// The codecs for compressed meshes that this program was built with.
Gltf_codecs gltf_codecs();

/// The names of objects, which assimp drops, by the names that assimp gives them; empty if the program was built
/// without minizip. \throw Invalid_input if the archive is damaged, or has objects in several files
std::map<std::string, std::string> names_in_3mf(const std::string& file);

} // namespace CGAL::Shape_correspondence::IO
