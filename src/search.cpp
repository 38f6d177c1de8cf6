// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// The light rooms: transform, energy, search.
#include <CGAL/Shape_correspondence/find_correspondence.h>
#include <CGAL/Shape_correspondence/match_parts.h>

#include <CGAL/Shape_correspondence/internal/Deformation_energy_impl.h>
#include <CGAL/Shape_correspondence/internal/Geotopo_transform_impl.h>
#include <CGAL/Shape_correspondence/internal/Matching_problem_impl.h>
#include <CGAL/Shape_correspondence/internal/Pairwise_energy_impl.h>
#include <CGAL/Shape_correspondence/internal/Part_costs_impl.h>
#include <CGAL/Shape_correspondence/internal/align_shapes_impl.h>
#include <CGAL/Shape_correspondence/internal/beam_search_impl.h>
#include <CGAL/Shape_correspondence/internal/exact_search_impl.h>
#include <CGAL/Shape_correspondence/internal/find_correspondence_impl.h>
#include <CGAL/Shape_correspondence/internal/match_parts_impl.h>
#include <CGAL/Shape_correspondence/internal/part_assemblies_impl.h>
