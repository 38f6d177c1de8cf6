// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_CLI_PROGRAM_OPTIONS_FWD_H
#define CGAL_SHAPE_CORRESPONDENCE_CLI_PROGRAM_OPTIONS_FWD_H

// Boost has no such header, and its full one takes a second to compile.
namespace boost {
namespace program_options {
class options_description;
class variables_map;
} // namespace program_options
} // namespace boost

#endif // CGAL_SHAPE_CORRESPONDENCE_CLI_PROGRAM_OPTIONS_FWD_H
