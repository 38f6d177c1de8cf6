// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

// A wrap carves the widest openings first, as with CGAL 5; newer ones carve in the order of a stack, unless told so.
#define CGAL_AW3_USE_SORTED_PRIORITY_QUEUE

#include <CGAL/alpha_wrap_3.h>
