// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// How a program ended.
struct Program_run
{
  std::string output;         ///< standard output of the program
  int status = 0;             ///< as returned by `waitpid()`
  bool took_too_long = false; ///< whether it was ended because of the time limit
};

/// Runs a program to its end, with only its standard output open; standard error is discarded.
/// \param limit time after which it is killed
/// \throw Invalid_input if it cannot be started; the message gives the reason
Program_run run_program(const std::string& program, const std::vector<std::string>& arguments,
                        std::chrono::milliseconds limit);

/// A helper program of the package: the file named by the environment variable `variable`, or else the file of this
/// name beside the program or library with this code, in the package's folder of helpers, or in the build folder.
/// \throw Invalid_input if there is none; the message says what to do
std::string own_program(const std::string& name, const char* variable);

} // namespace CGAL::Shape_correspondence::IO
