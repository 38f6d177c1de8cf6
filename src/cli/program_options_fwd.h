// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

// Boost has no such header, and its full one takes a second to compile.
namespace boost {
namespace program_options {
class options_description;
class variables_map;
} // namespace program_options
} // namespace boost
