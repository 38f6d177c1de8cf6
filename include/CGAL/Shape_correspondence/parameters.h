// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_PARAMETERS_H
#define CGAL_SHAPE_CORRESPONDENCE_PARAMETERS_H

#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <CGAL/Named_function_parameters.h>

#include <type_traits>

namespace CGAL::Shape_correspondence {

/// CGAL named parameters of this package, an alternative to the option structures. Each sets one field; all others keep
/// their defaults. They can be chained: `parameters::beam_width(40).expansions(8)`.
namespace parameters {

/// \cond SKIP_IN_MANUAL

/// A parameter pack of CGAL that can be chained with the parameters of this package.
template <typename T, typename Tag, typename Base = CGAL::internal_np::No_property>
struct Named_parameters;

// The named parameters, by name, option structure and field
#define CGAL_SHAPE_CORRESPONDENCE_PARAMETERS(X)                                                                        \
  X(search_method, Search_options, method)                                                                             \
  X(min_confidence, Search_options, min_confidence)                                                                    \
  X(feature_weight, Search_options, parts.weights.features)                                                            \
  X(beam_width, Search_options, beam.beam_width)                                                                       \
  X(expansions, Search_options, beam.expansions)                                                                       \
  X(unmatched_cost, Search_options, energy.unmatched_cost)                                                             \
  X(pinned, Search_options, energy.pinned)                                                                             \
  X(forbidden, Search_options, energy.forbidden)                                                                       \
  X(maximum_parts, Search_options, maximum_parts)                                                                      \
  X(alignments, Search_options, alignments)                                                                            \
  X(front_is_sure, Search_options, front_is_sure)                                                                      \
  X(solutions, Search_options, solutions)                                                                              \
  X(time_limit, Structure_options, abstraction.time_limit)                                                             \
  X(progress, Structure_options, abstraction.progress)                                                                 \
  X(detect_symmetry, Structure_options, symmetry.enabled)                                                              \
  X(contact_tolerance, Structure_options, contacts.tolerance)

#define CGAL_SHAPE_CORRESPONDENCE_TAG(name, options, field)                                                            \
  struct name##_t                                                                                                      \
  {};
CGAL_SHAPE_CORRESPONDENCE_PARAMETERS(CGAL_SHAPE_CORRESPONDENCE_TAG)
#undef CGAL_SHAPE_CORRESPONDENCE_TAG

template <typename T, typename Tag, typename Base>
struct Named_parameters : CGAL::Named_function_parameters<T, Tag, Base>
{
  using Pack = CGAL::Named_function_parameters<T, Tag, Base>;
  using Pack::Pack;

#define CGAL_SHAPE_CORRESPONDENCE_CHAIN(name, options, field)                                                          \
  template <typename K>                                                                                                \
  Named_parameters<K, name##_t, Pack> name(const K& value) const                                                       \
  {                                                                                                                    \
    return {value, *this};                                                                                             \
  }
  CGAL_SHAPE_CORRESPONDENCE_PARAMETERS(CGAL_SHAPE_CORRESPONDENCE_CHAIN)
  CGAL_SHAPE_CORRESPONDENCE_CHAIN(part_names, , )
#undef CGAL_SHAPE_CORRESPONDENCE_CHAIN
};

#define CGAL_SHAPE_CORRESPONDENCE_START(name, options, field)                                                          \
  template <typename K>                                                                                                \
  Named_parameters<K, name##_t> name(const K& value)                                                                   \
  {                                                                                                                    \
    return {value};                                                                                                    \
  }
CGAL_SHAPE_CORRESPONDENCE_PARAMETERS(CGAL_SHAPE_CORRESPONDENCE_START)
CGAL_SHAPE_CORRESPONDENCE_START(part_names, , ) // for Segmented_shape::from_segmentation()
#undef CGAL_SHAPE_CORRESPONDENCE_START

/// The option structure (`Search_options` or `Structure_options`) described by a parameter pack.
template <typename Options, typename NamedParameters>
Options options_from(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Options result;
  const auto set = [&](auto& options, auto tag, auto field) {
    field(options) = choose_parameter(get_parameter(np, tag), field(options));
  };
#define CGAL_SHAPE_CORRESPONDENCE_READ(name, Structure, member)                                                        \
  if constexpr (std::is_same<Options, Structure>::value)                                                               \
    set(result, name##_t(), [](auto& o) -> decltype((o.member)) { return o.member; });
  CGAL_SHAPE_CORRESPONDENCE_PARAMETERS(CGAL_SHAPE_CORRESPONDENCE_READ)
#undef CGAL_SHAPE_CORRESPONDENCE_READ
  return result;
}

#undef CGAL_SHAPE_CORRESPONDENCE_PARAMETERS

/// \endcond

} // namespace parameters

/// \ingroup PkgShapeCorrespondenceFunctions
/// Builds the structural graph of a segmented shape; named parameters replace `Structure_options`.
/// \tparam ConcurrencyTag `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result is bitwise identical
/// \param shape the shape
/// \param np named parameters, each of which sets a field, where its meaning, unit and default are documented
///
/// | parameter | field |
/// |---|---|
/// | `time_limit`, `progress` | fields of these names in `Abstraction_options` |
/// | `detect_symmetry` | `Symmetry_options::enabled` |
/// | `contact_tolerance` | `Contact_options::tolerance` |
///
/// \throw Invalid_input if the shape has fewer than two parts or more than 2000
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename T, typename Tag, typename Base>
Structural_graph build_structural_graph(const Segmented_shape& shape,
                                        const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return build_structural_graph<ConcurrencyTag>(shape, parameters::options_from<Structure_options>(np));
}

/// \ingroup PkgShapeCorrespondenceFunctions
/// Finds the part correspondence of two shapes; named parameters replace `Search_options`.
/// \param source,target the structural graphs of the shapes
/// \param np named parameters, each of which sets a field, where its meaning, unit and default are documented
///
/// | parameter | field |
/// |---|---|
/// | `search_method` | `Search_options::method` |
/// | `min_confidence`, `maximum_parts`, `alignments`, `front_is_sure`, `solutions` | same names in `Search_options` |
/// | `feature_weight` | `Part_cost_weights::features` |
/// | `beam_width`, `expansions` | fields of these names in `Beam_options` |
/// | `unmatched_cost`, `pinned`, `forbidden` | fields of these names in `Energy_options` |
///
/// \pre both graphs are valid (`is_valid_structural_graph()`)
/// \throw Invalid_input if an option is out of its range
template <typename T, typename Tag, typename Base>
Correspondence find_correspondence(const Structural_graph& source, const Structural_graph& target,
                                   const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return find_correspondence(source, target, parameters::options_from<Search_options>(np));
}

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_PARAMETERS_H
