// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings.h"
#include "options.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/version.h>

#include <filesystem>

namespace shape_correspondence_python {

namespace {

/// Makes errors of the library exceptions of Python, with the messages that the program prints.
void register_errors(py::module_& module)
{
  static py::exception<SC::Invalid_input> invalid_input(module, "InvalidInput", PyExc_ValueError);
  invalid_input.doc() = "An input or option cannot be used. The message says which one, why, and what to do.";
  py::register_exception_translator([](std::exception_ptr error) {
    try {
      if (error) std::rethrow_exception(error);
    } catch (const SC::Invalid_input& e) {
      invalid_input(e.what());
    } catch (const SC::cli::Usage_error& e) {
      invalid_input(e.what());
    } catch (const std::filesystem::filesystem_error& e) {
      const std::string message =
          e.path1().string() + ": it cannot be used (" + e.code().message() + "); check the path and its permissions";
      invalid_input(message.c_str());
    }
  });
}

} // namespace

PYBIND11_MODULE(_core, module)
{
  module.doc() = "The compiled part of shape_correspondence; use the package instead.";
  module.attr("__version__") = CGAL_SHAPE_CORRESPONDENCE_VERSION;
  register_errors(module);
  bind_shapes(module);
  bind_matches(module);
  bind_blends(module);
  bind_collections(module);
  bind_roles(module);
  module.def("options_of", options_of);
}

} // namespace shape_correspondence_python
