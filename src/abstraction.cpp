// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/internal/abstract_part_impl.h>

namespace CGAL {
namespace Shape_correspondence {

template std::vector<Part_abstraction> abstract_parts<CGAL::Sequential_tag>(const Segmented_shape&, const Shape_frame&,
                                                                            const Abstraction_options&);
template std::vector<Part_abstraction> abstract_parts<CGAL::Parallel_tag>(const Segmented_shape&, const Shape_frame&,
                                                                          const Abstraction_options&);

} // namespace Shape_correspondence
} // namespace CGAL
