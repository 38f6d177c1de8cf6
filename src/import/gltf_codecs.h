// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/read/Gltf_document.h"

namespace CGAL::Shape_correspondence::IO {

/// The codecs for compressed meshes that this program was built with.
Gltf_codecs gltf_codecs();

} // namespace CGAL::Shape_correspondence::IO
