// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/limits.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <string>

namespace CGAL::Shape_correspondence::IO {

/// \throw Invalid_input if a blend cannot have so many
inline void check_number_of_frames(int frames)
{
  if (frames < 2 || frames > internal::most_frames)
    throw Invalid_input("a blend has between 2 and " + std::to_string(internal::most_frames) + " frames, not " +
                        std::to_string(frames));
}

} // namespace CGAL::Shape_correspondence::IO
