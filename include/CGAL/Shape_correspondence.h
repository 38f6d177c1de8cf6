// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_H
#define CGAL_SHAPE_CORRESPONDENCE_H

/// \file Shape_correspondence.h Includes the package except files (`Shape_correspondence/IO/`) and the solvers that can
/// be used without shapes (`exact_search.h`, `markov_clustering.h`).

#include <CGAL/Shape_correspondence/Correspondence_map.h>
#include <CGAL/Shape_correspondence/Surface_map.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/co_analysis.h>
#include <CGAL/Shape_correspondence/energy_matrix.h>
#include <CGAL/Shape_correspondence/estimate_up.h>
#include <CGAL/Shape_correspondence/evaluate_correspondence.h>
#include <CGAL/Shape_correspondence/features_of_parts.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>
#include <CGAL/Shape_correspondence/nearest_shapes.h>
#include <CGAL/Shape_correspondence/parameters.h>
#include <CGAL/Shape_correspondence/split_parts.h>
#include <CGAL/Shape_correspondence/topological_medoid.h>
#include <CGAL/Shape_correspondence/transfer_appearance.h>
#include <CGAL/Shape_correspondence/transitive_correspondence.h>

#endif // CGAL_SHAPE_CORRESPONDENCE_H
