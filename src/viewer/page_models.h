// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/write/pictures.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// The most triangles of all surfaces of a page of one or two shapes; each takes about 60 bytes.
constexpr std::size_t largest_page_triangles = 100000;

/// The most triangles of a page of a blend, whose surfaces move; each takes about 250 bytes.
constexpr std::size_t largest_blend_page_triangles = 60000;

/// The likeliest roles of a shape's parts by the model that comes with the package; none where the category is not
/// clear.
std::vector<std::string> likeliest_roles(const Structural_graph& graph);

/// Models as pages show them: all simplified by the same factor if together they have too many triangles.
class Page_models
{
public:
  /// \param models null for shapes without surfaces \param most_triangles limit for all models together
  Page_models(const std::vector<const Segmented_shape*>& models, std::size_t most_triangles) : models_(models)
  {
    std::size_t all = 0;
    for (const Segmented_shape* model : models_)
      all += model ? number_of_triangles(*model) : 0;
    simplified_.resize(models_.size());
    for (std::size_t i = 0; all > most_triangles && i < models_.size(); ++i) {
      if (!models_[i]) continue;
      const double share = double(number_of_triangles(*models_[i])) / double(all);
      simplified_[i] = simplified_shape(*models_[i], std::size_t(share * double(most_triangles)));
      models_[i] = &*simplified_[i];
    }
  }
  Page_models(const Page_models&) = delete;
  Page_models& operator=(const Page_models&) = delete;

  const Segmented_shape* operator[](std::size_t i) const { return models_[i]; }

  bool are_simplified() const
  {
    return std::any_of(simplified_.begin(), simplified_.end(), [](const auto& shape) { return shape.has_value(); });
  }

private:
  std::vector<const Segmented_shape*> models_;
  std::vector<std::optional<Segmented_shape>> simplified_;
};

} // namespace CGAL::Shape_correspondence::IO
