// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/energy_matrix.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// Finished tiles by name, in a folder or, without one, in memory. In a folder a tile is there as a whole or not at
/// all, whenever the program is killed, and many processes may use it at a time. One that is damaged counts as missing.
class Tile_store
{
public:
  /// \param folder is made if there is none; empty: in memory \throw Invalid_input if it cannot be used
  explicit Tile_store(std::string folder);

  bool has(const std::string& name) const;
  std::optional<std::vector<Rated_map>> find(const std::string& name) const;
  /// Two maps in turn that are each other's inverse take the room of one. Confidences are kept to 16 bits; `find()`
  /// returns what is kept, in memory as in a folder.
  void insert(const std::string& name, const std::vector<Rated_map>& pairs);

private:
  std::string path(const std::string& name) const;

  std::string folder_;
  std::map<std::string, std::string> in_memory_;
};

} // namespace CGAL::Shape_correspondence::cli
