// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/detect_contacts.h>
#include <CGAL/Shape_correspondence/internal/detect_contacts_impl.h>

namespace CGAL {
namespace Shape_correspondence {

template std::vector<Contact> detect_contacts<CGAL::Sequential_tag>(const Segmented_shape&,
                                                                    const std::vector<Part_abstraction>&,
                                                                    const Shape_frame&, const Contact_options&,
                                                                    std::vector<std::string>&);
template std::vector<Contact> detect_contacts<CGAL::Parallel_tag>(const Segmented_shape&,
                                                                  const std::vector<Part_abstraction>&,
                                                                  const Shape_frame&, const Contact_options&,
                                                                  std::vector<std::string>&);

} // namespace Shape_correspondence
} // namespace CGAL
