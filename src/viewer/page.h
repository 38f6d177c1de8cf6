// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <iosfwd>
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

} // namespace CGAL::Shape_correspondence::IO
