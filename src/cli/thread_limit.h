// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_CLI_THREAD_LIMIT_H
#define CGAL_SHAPE_CORRESPONDENCE_CLI_THREAD_LIMIT_H

#include <memory>

namespace CGAL {
namespace Shape_correspondence {
namespace cli {

/// While it lives, no more threads work than this; 0 sets no limit.
class Thread_limit
{
public:
  explicit Thread_limit(int threads);

private:
  std::shared_ptr<void> control_;
};

} // namespace cli
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_CLI_THREAD_LIMIT_H
