// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/match_shapes.h"
#include "cli/clock.h"

namespace CGAL::Shape_correspondence::cli {

Matched_shapes match_shapes(const Loaded_shape& source, const Loaded_shape& target, const Search_options& options)
{
  const Prepared_shape prepared_source(source.graph), prepared_target(target.graph);
  const double begin_roles = now();
  for (const Prepared_shape* shape : {&prepared_source, &prepared_target})
    shape->read_roles(options.roles);
  const double begin = now();
  Matched_shapes result{Correspondence_finder(prepared_source, options).ranked(prepared_target), {}};
  result.seconds = {source.read_seconds + target.read_seconds, source.abstraction_seconds + target.abstraction_seconds,
                    source.structure_seconds + target.structure_seconds + begin - begin_roles, now() - begin};
  return result;
}

} // namespace CGAL::Shape_correspondence::cli
