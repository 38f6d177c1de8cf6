// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/internal/build_structural_graph_impl.h>

namespace CGAL {
namespace Shape_correspondence {

template Structural_graph build_structural_graph<CGAL::Sequential_tag>(const Segmented_shape&, const Structure_options&,
                                                                       Structure_times*);
template Structural_graph build_structural_graph<CGAL::Parallel_tag>(const Segmented_shape&, const Structure_options&,
                                                                     Structure_times*);

} // namespace Shape_correspondence
} // namespace CGAL
