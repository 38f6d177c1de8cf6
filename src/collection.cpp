// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Sets of shapes.
#include <CGAL/Shape_correspondence/co_analysis.h>
#include <CGAL/Shape_correspondence/energy_matrix.h>
#include <CGAL/Shape_correspondence/nearest_shapes.h>
#include <CGAL/Shape_correspondence/topological_medoid.h>
#include <CGAL/Shape_correspondence/transitive_correspondence.h>

#include <CGAL/Shape_correspondence/internal/Part_map_impl.h>
#include <CGAL/Shape_correspondence/internal/co_analysis_impl.h>
#include <CGAL/Shape_correspondence/internal/energy_matrix_impl.h>
#include <CGAL/Shape_correspondence/internal/markov_clustering_impl.h>
#include <CGAL/Shape_correspondence/internal/nearest_shapes_impl.h>
#include <CGAL/Shape_correspondence/internal/topological_medoid_impl.h>
#include <CGAL/Shape_correspondence/internal/transitive_correspondence_impl.h>

namespace CGAL {
namespace Shape_correspondence {

template std::vector<Rated_map> match_pairs<CGAL::Sequential_tag>(const std::vector<Structural_graph>&,
                                                                  const std::vector<Shape_pair>&,
                                                                  const Energy_matrix_options&);
template Nearest_shapes nearest_shapes<CGAL::Sequential_tag>(const Structural_graph&, std::size_t,
                                                             const std::function<Structural_graph(std::size_t)>&,
                                                             std::size_t, const Energy_matrix_options&);
template Energy_matrix energy_matrix<CGAL::Sequential_tag>(const std::vector<Structural_graph>&,
                                                           const Energy_matrix_options&);
#ifdef CGAL_LINKED_WITH_TBB
template std::vector<Rated_map> match_pairs<CGAL::Parallel_tag>(const std::vector<Structural_graph>&,
                                                                const std::vector<Shape_pair>&,
                                                                const Energy_matrix_options&);
template Nearest_shapes nearest_shapes<CGAL::Parallel_tag>(const Structural_graph&, std::size_t,
                                                           const std::function<Structural_graph(std::size_t)>&,
                                                           std::size_t, const Energy_matrix_options&);
template Energy_matrix energy_matrix<CGAL::Parallel_tag>(const std::vector<Structural_graph>&,
                                                         const Energy_matrix_options&);
#endif

} // namespace Shape_correspondence
} // namespace CGAL
