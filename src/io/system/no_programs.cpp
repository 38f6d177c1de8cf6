// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/system/run_program.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

// For browsers, in place of run_program.cpp

namespace CGAL::Shape_correspondence::IO {
namespace {

[[noreturn]] void fail_to_run(const std::string& program)
{
  throw Invalid_input("it is read by another program (" + program +
                      "), and a browser runs none; save it as GLB without compression, OBJ, PLY, STL or OFF");
}

} // namespace

Program_run run_program(const std::string& program, const std::vector<std::string>&, std::chrono::milliseconds)
{
  fail_to_run(program);
}

std::string own_program(const std::string& name, const char*) { fail_to_run(name); }

} // namespace CGAL::Shape_correspondence::IO
