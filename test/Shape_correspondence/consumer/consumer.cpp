// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Matches two handwritten graphs, without reading files.
#include "../hand_made_graphs.h"

#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <iostream>

int main()
{
  const auto result = CGAL::Shape_correspondence::find_correspondence(hand_made::chair(), hand_made::slatted_chair());
  std::cout << result.pairs.size() << " pairs\n";
  return result.pairs.size() == 8 ? 0 : 1;
}
