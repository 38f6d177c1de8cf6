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

namespace CGAL {
namespace Shape_correspondence {

/// CGAL named parameters of this package, an alternative to the option structures; each sets one of their fields, and
/// all other fields keep their defaults. Chain them: `parameters::beam_width(40).expansions(8)`.
namespace parameters {

/// \cond SKIP_IN_MANUAL

/// A parameter pack of CGAL that can be chained with the parameters of this package.
template <typename T, typename Tag, typename Base = CGAL::internal_np::No_property>
struct Named_parameters;

// name, option structure, field
#define CGAL_SHAPE_CORRESPONDENCE_PARAMETERS(X)                                                                        \
  X(search_method, Search_options, method)                                                                             \
  X(min_confidence, Search_options, min_confidence)                                                                    \
  X(beam_width, Search_options, beam.beam_width)                                                                       \
  X(expansions, Search_options, beam.expansions)                                                                       \
  X(distortion_weight, Search_options, matching.weights.distortion)                                                    \
  X(connectedness_weight, Search_options, matching.weights.connectedness)                                              \
  X(split_weight, Search_options, matching.weights.split)                                                              \
  X(role_weight, Search_options, matching.weights.roles)                                                               \
  X(energy_norm, Search_options, matching.norm)                                                                        \
  X(cut_curves, Search_options, matching.cut_curves)                                                                   \
  X(unmatched_cost, Search_options, matching.unmatched_cost)                                                           \
  X(pinned, Search_options, matching.pinned)                                                                           \
  X(forbidden, Search_options, matching.forbidden)                                                                     \
  X(both_directions, Search_options, both_directions)                                                                  \
  X(maximum_parts, Search_options, maximum_parts)                                                                      \
  X(coarse_target, Search_options, coarse_target)                                                                      \
  X(source_parts, Search_options, source_parts)                                                                        \
  X(target_parts, Search_options, target_parts)                                                                        \
  X(alignments, Search_options, alignments)                                                                            \
  X(front_is_sure, Search_options, front_is_sure)                                                                      \
  X(solutions, Search_options, solutions)                                                                              \
  X(min_marginals, Search_options, min_marginals)                                                                      \
  X(edge_length, Structure_options, abstraction.edge_length)                                                           \
  X(stop_volume, Structure_options, abstraction.stop_volume)                                                           \
  X(time_limit, Structure_options, abstraction.time_limit)                                                             \
  X(progress, Structure_options, abstraction.progress)                                                                 \
  X(detect_symmetry, Structure_options, symmetry.enabled)                                                              \
  X(symmetry_tolerance, Structure_options, symmetry.tolerance)                                                         \
  X(detect_reflections, Structure_options, symmetry.reflection)                                                        \
  X(detect_rotations, Structure_options, symmetry.rotation)                                                            \
  X(detect_translations, Structure_options, symmetry.translation)                                                      \
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
CGAL_SHAPE_CORRESPONDENCE_START(part_names, , ) // of Segmented_shape::from_segmentation()
#undef CGAL_SHAPE_CORRESPONDENCE_START

/// The option structure (`Search_options` or `Structure_options`) that a parameter pack describes.
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
/// Builds the structural graph of a segmented shape; named parameters take the place of `Structure_options`.
/// \tparam ConcurrencyTag `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result is bitwise identical
/// \param shape the shape
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{edge_length}
///     \cgalParamDescription{edge length of the remeshed part, as a fraction of the diagonal of the part's bounding
///                           box}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0.02`}
///   \cgalParamNEnd
///   \cgalParamNBegin{stop_volume}
///     \cgalParamDescription{fraction of the volume at which the mean curvature flow is stopped to detect sheets and
///                           hollow parts}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0.02`}
///   \cgalParamNEnd
///   \cgalParamNBegin{time_limit}
///     \cgalParamDescription{seconds for one part; a part that needs more is represented by its bounding box}
///     \cgalParamType{`double`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{progress}
///     \cgalParamDescription{called after every part with the number of parts done and their total, by one thread at a
///                           time}
///     \cgalParamType{`std::function<void(std::size_t, std::size_t)>`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{detect_symmetry}
///     \cgalParamDescription{whether to look for symmetry groups; if `false`, every part is a group of its own}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{symmetry_tolerance}
///     \cgalParamDescription{largest distance of a part from its image, as a fraction of the diagonal of the part}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0.05`}
///   \cgalParamNEnd
///   \cgalParamNBegin{detect_reflections}
///     \cgalParamDescription{whether to look for reflections}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{detect_rotations}
///     \cgalParamDescription{whether to look for rotations}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{detect_translations}
///     \cgalParamDescription{whether to look for translations}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{contact_tolerance}
///     \cgalParamDescription{largest gap between parts in contact, as a fraction of the diagonal of the shape's
///                           bounding box}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0.02`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \throw Invalid_input if the shape has fewer than two parts or more than 2000
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename T, typename Tag, typename Base>
Structural_graph build_structural_graph(const Segmented_shape& shape,
                                        const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return build_structural_graph<ConcurrencyTag>(shape, parameters::options_from<Structure_options>(np));
}

/// \ingroup PkgShapeCorrespondenceFunctions
/// Finds the part correspondence of two shapes; named parameters take the place of `Search_options`.
/// \param source,target the structural graphs of the shapes
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{search_method}
///     \cgalParamDescription{how the correspondence is found}
///     \cgalParamType{`Search_method`}
///     \cgalParamDefault{`Search_method::PARTS`}
///   \cgalParamNEnd
///   \cgalParamNBegin{min_confidence}
///     \cgalParamDescription{pairs of lower confidence are left out; for `Search_method::PARTS`}
///     \cgalParamType{`double` in [0, 1]}
///     \cgalParamDefault{`0`}
///   \cgalParamNEnd
///   \cgalParamNBegin{beam_width}
///     \cgalParamDescription{K of the paper, the partial solutions kept at each level of the beam search}
///     \cgalParamType{`int`}
///     \cgalParamDefault{`20`}
///   \cgalParamNEnd
///   \cgalParamNBegin{expansions}
///     \cgalParamDescription{k of the paper, the expansions kept of each partial solution}
///     \cgalParamType{`int`}
///     \cgalParamDefault{`4`}
///   \cgalParamNEnd
///   \cgalParamNBegin{distortion_weight}
///     \cgalParamDescription{weight of E_d in Eq. 1}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`1`}
///   \cgalParamNEnd
///   \cgalParamNBegin{connectedness_weight}
///     \cgalParamDescription{w_c, weight of E_c in Eq. 1}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0.6`}
///   \cgalParamNEnd
///   \cgalParamNBegin{split_weight}
///     \cgalParamDescription{w_s, weight of E_s in Eq. 1}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0.4`}
///   \cgalParamNEnd
///   \cgalParamNBegin{role_weight}
///     \cgalParamDescription{weight of the disagreement of roles in the energy}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0`}
///   \cgalParamNEnd
///   \cgalParamNBegin{energy_norm}
///     \cgalParamDescription{whether energies are summed over connected pairs of parts, or pooled in one norm over all
///                           rods}
///     \cgalParamType{`Energy_norm`}
///     \cgalParamDefault{`Energy_norm::SUM`}
///   \cgalParamNEnd
///   \cgalParamNBegin{cut_curves}
///     \cgalParamDescription{whether curves may be cut into segments and joined, in addition to splitting and merging}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{unmatched_cost}
///     \cgalParamDescription{the energy of leaving a group unmatched, for each of its contacts}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`Matching_options::never`: every group is matched}
///   \cgalParamNEnd
///   \cgalParamNBegin{pinned}
///     \cgalParamDescription{pairs that must correspond, and to no other parts, see `Matching_options::pinned`}
///     \cgalParamType{`std::vector<Part_pair>`}
///     \cgalParamDefault{empty}
///   \cgalParamNEnd
///   \cgalParamNBegin{forbidden}
///     \cgalParamDescription{pairs that must not correspond}
///     \cgalParamType{`std::vector<Part_pair>`}
///     \cgalParamDefault{empty}
///   \cgalParamNEnd
///   \cgalParamNBegin{both_directions}
///     \cgalParamDescription{whether either shape is deformed into the other, and the one with the lower energy per
///                           pair of connected parts is taken}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_parts}
///     \cgalParamDescription{number of largest parts to match; `0`: all parts}
///     \cgalParamType{`int`}
///     \cgalParamDefault{`0`}
///   \cgalParamNEnd
///   \cgalParamNBegin{coarse_target}
///     \cgalParamDescription{whether `maximum_parts` applies to both shapes, or to the source only, as in the paper}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{source_parts}
///     \cgalParamDescription{only these parts of the source are matched, by their index; empty: all}
///     \cgalParamType{`std::vector<std::size_t>`}
///     \cgalParamDefault{empty}
///   \cgalParamNEnd
///   \cgalParamNBegin{target_parts}
///     \cgalParamDescription{only these parts of the target are matched, by their index; empty: all}
///     \cgalParamType{`std::vector<std::size_t>`}
///     \cgalParamDefault{empty}
///   \cgalParamNEnd
///   \cgalParamNBegin{alignments}
///     \cgalParamDescription{number of turns of the target about the up axis to try, the one nearest to the given
///                           orientation first; `0`: all}
///     \cgalParamType{`int`}
///     \cgalParamDefault{`1`}
///   \cgalParamNEnd
///   \cgalParamNBegin{front_is_sure}
///     \cgalParamDescription{whether the given orientation is right; otherwise a shape is turned by a multiple of 90° if
///                           the roles of its parts clearly say that its front is another side}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{solutions}
///     \cgalParamDescription{number of best solutions that the search ranks, see `find_correspondences()`; this
///                           function returns the first}
///     \cgalParamType{`int`}
///     \cgalParamDefault{`1`}
///   \cgalParamNEnd
///   \cgalParamNBegin{min_marginals}
///     \cgalParamDescription{whether `Group_match::min_marginal` is computed}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \pre both graphs are valid (`is_valid_structural_graph()`)
/// \throw Invalid_input if an option is out of its range
template <typename T, typename Tag, typename Base>
Correspondence find_correspondence(const Structural_graph& source, const Structural_graph& target,
                                   const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return find_correspondence(source, target, parameters::options_from<Search_options>(np));
}

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_PARAMETERS_H
