// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <functional>
#include <string>

namespace CGAL::Shape_correspondence::IO {

/// Runs `work` in a process of its own, a copy of this one of which nothing but this thread goes on, within limits of
/// memory and processor time. \return what it returned
/// \throw Invalid_input if `work` throws one; or, naming `file`, if it throws anything else, crashes or reaches a limit
std::string run_isolated(const std::string& file, const std::function<std::string()>& work);

} // namespace CGAL::Shape_correspondence::IO
