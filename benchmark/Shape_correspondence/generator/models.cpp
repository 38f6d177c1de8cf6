// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "models.h"

#include "designs.h"

namespace CGAL::Shape_correspondence::generator {

const std::vector<Model>& models()
{
  static const std::vector<Model> all{{"airplane_propeller", airplane_propeller},
                                      {"airplane_twin_engine", airplane_twin_engine},
                                      {"bed_slatted", bed_slatted},
                                      {"bicycle", bicycle},
                                      {"chair_four_legged", chair_four_legged},
                                      {"chair_slatted", chair_slatted},
                                      {"chair_spindle", chair_spindle},
                                      {"chair_swivel", chair_swivel},
                                      {"lamp_desk", lamp_desk},
                                      {"stool", stool},
                                      {"table_four_legged", table_four_legged},
                                      {"table_pedestal", table_pedestal},
                                      {"table_trestle", table_trestle},
                                      {"tricycle", tricycle}};
  return all;
}

} // namespace CGAL::Shape_correspondence::generator
