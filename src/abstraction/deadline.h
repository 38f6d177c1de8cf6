// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/deadline.h"

#include <stdexcept>

namespace CGAL::Shape_correspondence::internal {

/// Thrown if the flow cannot treat a part; the message says why. Does not leave this room.
class Flow_failure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

} // namespace CGAL::Shape_correspondence::internal
