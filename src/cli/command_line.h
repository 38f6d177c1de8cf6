// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"

#include <boost/program_options.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// A group of options, without any as yet.
boost::program_options::options_description option_group(const std::string& title);

/// An option for a number, with the variable's value as its default.
boost::program_options::typed_value<double>* number(double& variable);
boost::program_options::typed_value<int>* number(int& variable);
boost::program_options::typed_value<std::size_t>* number(std::size_t& variable);

/// The options that all commands share.
boost::program_options::options_description common_options(Common_options& options);

/// Options on model files: the upright axis and the parts.
boost::program_options::options_description reading_options(Common_options& options);

/// All options on models: how they are read, their parts abstracted, and their structural graphs built.
boost::program_options::options_description model_options(Common_options& options);

/// Options on the source and the target of a pair.
boost::program_options::options_description pair_options(Common_options& options);

/// The arguments of a command, parsed.
struct Arguments
{
  boost::program_options::variables_map values;
  std::vector<std::string> inputs;
  bool help = false;
};

/// The most inputs of a command that takes any number.
constexpr std::size_t any_number = std::size_t(-1);

/// Parses the arguments of a command and fills the variables that the options are bound to.
/// \param least,most how many inputs the command takes \throw Usage_error
Arguments parse(const std::vector<std::string>& arguments, const boost::program_options::options_description& options,
                std::size_t least, std::size_t most);

/// Refuses options of part abstraction if all inputs are structural graphs. \throw Usage_error
void refuse_abstraction_of_graphs(const Arguments& arguments);

/// Whether an option is given, rather than left at its default.
bool is_given(const boost::program_options::variables_map& values, const std::string& option);

} // namespace CGAL::Shape_correspondence::cli
