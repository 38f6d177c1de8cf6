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
  std::string output;         ///< of its standard output
  int status = 0;             ///< as `waitpid()` gives it
  bool took_too_long = false; ///< it has been ended for that
};

/// Runs a program to its end, with no file open but its standard output; standard error is discarded.
/// \param limit the time after which it is ended
/// \throw Invalid_input if it cannot be started; the message says why
Program_run run_program(const std::string& program, const std::vector<std::string>& arguments,
                        std::chrono::milliseconds limit);

/// A program of the package that is installed for its own use: the file that the environment variable `variable` names;
/// or else that of this name beside the program or library that this code is part of, in the package's folder of such
/// programs, or where it was built.
/// \throw Invalid_input if there is none; the message says what to do
std::string own_program(const std::string& name, const char* variable);

} // namespace CGAL::Shape_correspondence::IO
