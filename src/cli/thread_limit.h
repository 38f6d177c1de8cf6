// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <memory>

namespace CGAL::Shape_correspondence::cli {

/// While it lives, no more threads work than this; 0 sets no limit.
class Thread_limit
{
public:
  explicit Thread_limit(int threads);

private:
  std::shared_ptr<void> control_;
};

} // namespace CGAL::Shape_correspondence::cli
