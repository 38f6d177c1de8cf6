// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <iosfwd>

namespace CGAL::Shape_correspondence::cli {

/// Writes the help of the program and of all commands as a manual page in the language of man(7).
void write_manual_page(std::ostream& out);

} // namespace CGAL::Shape_correspondence::cli
