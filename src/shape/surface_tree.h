// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>

#include <boost/variant/get.hpp>
#include <boost/variant/variant.hpp>

#include <variant>

// CGAL's AABB tree: CGAL 6 renamed its traits, and returns intersections in a `std::variant`, no longer in a
// `boost::variant`.
#if CGAL_VERSION_NR < 1060000000
#include <CGAL/AABB_traits.h>
#else
#include <CGAL/AABB_traits_3.h>
#endif

namespace CGAL::Shape_correspondence::internal {

#if CGAL_VERSION_NR < 1060000000
template <typename Kernel, typename Primitive>
using Surface_tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
#else
template <typename Kernel, typename Primitive>
using Surface_tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;
#endif

template <typename Found, typename... Types>
const Found* get_if(const boost::variant<Types...>& found)
{
  return boost::get<Found>(&found);
}

template <typename Found, typename... Types>
const Found* get_if(const std::variant<Types...>& found)
{
  return std::get_if<Found>(&found);
}

} // namespace CGAL::Shape_correspondence::internal
