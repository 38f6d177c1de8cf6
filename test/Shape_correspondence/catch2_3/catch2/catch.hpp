// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the tests take of Catch2 3, by the names that it has in Catch2 2
#pragma once

#include <catch2/catch_approx.hpp>
#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_all.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <catch2/matchers/catch_matchers_vector.hpp>

namespace Catch {
namespace Matchers {

inline StringContainsMatcher Contains(const std::string& text) { return ContainsSubstring(text); }

} // namespace Matchers

using Matchers::Contains;
using Matchers::EndsWith;
using Matchers::Message;
using Matchers::StartsWith;

} // namespace Catch

using Catch::Approx;
