// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>

namespace CGAL::Shape_correspondence::cli {

/// The folder of the models that come with the program: of the installation, found from where the program lies, or of
/// the source tree. \throw Invalid_input if there is none
std::string data_folder();

} // namespace CGAL::Shape_correspondence::cli
