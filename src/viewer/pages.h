// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/write/pictures.h"

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>
#include <CGAL/Shape_correspondence/split_parts.h>

#include <algorithm>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// The contents of a web page; the viewer (`src/viewer/page/`) finds the documents by their ids.
struct Page
{
  struct Document
  {
    std::string id, content;
  };

  std::string title;
  std::vector<Document> json; ///< JSON documents, as the package writes them into files
  std::vector<Document> glb;  ///< binary glTF, as the package writes it into files
  std::string summary = {};   ///< lines of text that are shown where no scripts run
};

/// Writes a page as one file that needs no network and runs no script but the viewer's, whatever names it contains.
/// \throw Invalid_input if the library was built without three.js
void write_page(std::ostream& out, const Page& page);

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

/// The page of a match: its JSON, and its GLB, in which large surfaces are simplified.
/// \param ranked the best one first \param source_shape may be null \param target_shape may be null
/// \param add_scenes adds further scenes to the GLB, such as shapes with their materials; may be empty
Page match_page(const std::vector<Correspondence>& ranked, const Structural_graph& source,
                const Structural_graph& target, const Segmented_shape* source_shape,
                const Segmented_shape* target_shape, const std::string& source_file, const std::string& target_file,
                const Match_seconds& seconds, const Add_scenes& add_scenes = {});

/// Adds the blend of the matched shapes to the page of a match. \param json as `write_blend_json()` writes it
void add_blend(Page& page, const std::string& json, const Shape_blend& blend, const Correspondence& correspondence,
               int frames);

/// A web page with several models, one colour for each part, and a table of their objects.
class Parts_sheet
{
public:
  /// \param models number of models that are going to be added
  explicit Parts_sheet(std::size_t models);

  /// Adds a model. \param objects its objects, for their names \param roles roles of the parts; empty if they are not
  /// known \param summary text that is shown above the parts
  void add(const std::string& title, const Segmented_shape& objects, const Part_split& split,
           const std::vector<std::string>& roles, const std::string& summary);
  /// Adds a model that cannot be used.
  void add(const std::string& title, const std::string& complaint);

  void write(std::ostream& out) const;

private:
  std::size_t triangles_of_model_;
  Json models_ = Json::array();
  Glb_file glb_;
  std::vector<int> roots_;
};

} // namespace CGAL::Shape_correspondence::IO
