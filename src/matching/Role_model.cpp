// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/Role_model_data.h"
#include "matching/Shape_roles.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <limits>
#include <ostream>
#include <streambuf>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace internal {

namespace {

constexpr double steps_per_deviation = 32; // of a standardised feature, a byte: it reaches over four deviations

Role_features features_of(const std::vector<Role_example>& examples)
{
  Role_features result(Eigen::Index(examples.size()), ROLE_FEATURE_COUNT);
  for (std::size_t i = 0; i < examples.size(); ++i)
    std::copy(examples[i].features.begin(), examples[i].features.end(), &result(Eigen::Index(i), 0));
  return result;
}

} // namespace

std::size_t Role_model_data::index(const std::string& category) const
{
  const auto found =
      std::find_if(categories.begin(), categories.end(), [&](const Category_roles& c) { return c.name == category; });
  return std::size_t(found - categories.begin());
}

Role_distances::Role_distances(const std::vector<Category_roles>& categories)
{
  for (int feature = 0; feature < ROLE_FEATURE_COUNT; ++feature) {
    double count = 0, sum = 0, squares = 0; // whole numbers: exact
    for (const Category_roles& category : categories)
      for (const Role_example& example : category.examples) {
        const double value = example.features[std::size_t(feature)];
        count += 1;
        sum += value;
        squares += value * value;
      }
    const double variance = count > 0 ? squares / count - (sum / count) * (sum / count) : 0;
    const double scale = steps_per_deviation / std::sqrt(std::max(1., variance));
    for (int value = 0; value < 256; ++value)
      standard_[std::size_t(feature)][std::size_t(value)] =
          std::uint8_t(std::lround(std::clamp((value - 127.) * scale + 127, 0., 255.)));
  }
  for (const Category_roles& category : categories)
    examples_.push_back(standardised(features_of(category.examples)));
}

Role_distances::Rows Role_distances::standardised(const Role_features& parts) const
{
  Rows result = Rows::Zero(parts.rows(), row_length);
  for (Eigen::Index i = 0; i < parts.rows(); ++i)
    for (Eigen::Index feature = 0; feature < ROLE_FEATURE_COUNT; ++feature)
      result(i, feature) = standard_[std::size_t(feature)][parts(i, feature)];
  return result;
}

double Role_distances::mean_distance(const Role_features& parts, std::size_t category) const
{
  const Rows queries = standardised(parts);
  const Rows& examples = examples_[category];
  double sum = 0;
  for (Eigen::Index i = 0; i < queries.rows(); ++i) {
    const std::uint8_t* const query = &queries(i, 0);
    int least = std::numeric_limits<int>::max();
    for (Eigen::Index j = 0; j < examples.rows(); ++j) {
      const std::uint8_t* const example = &examples(j, 0);
      int distance = 0;
      for (int k = 0; k < row_length; ++k)
        distance += std::abs(int(query[k]) - int(example[k]));
      least = std::min(least, distance);
    }
    sum += least;
  }
  return sum / (double(queries.rows()) * int(ROLE_FEATURE_COUNT) * steps_per_deviation);
}

Role_evidence role_evidence(const Structural_graph& graph, const Aligned_shape& shape)
{
  return {role_features(graph, shape), part_sides(shape)};
}

Role_evidence role_evidence(const Structural_graph& graph, int quarter_turns)
{
  return role_evidence(graph, align_shape(graph, given_quarter_turns(structure(graph).frame) + quarter_turns));
}

} // namespace internal

Role_model::Role_model() : Role_model(Role_model_data()) {}

Role_model::Role_model(Role_model_data data)
    : data_(std::make_shared<Role_model_data>(std::move(data))),
      distances_(std::make_shared<Role_distances>(data_->categories))
{}

namespace {

const Category_roles& category_of(const Role_model_data& data, const std::string& name)
{
  const std::size_t index = data.index(name);
  if (index < data.categories.size()) return data.categories[index];
  std::string known;
  for (const Category_roles& category : data.categories)
    known += (known.empty() ? "" : ", ") + category.name;
  throw Invalid_input("the role model does not have the category '" + name + "'; it has " +
                      (known.empty() ? "none" : known));
}

constexpr long most_weight_steps = 1000000000; // of a weight, either way

// Numbers and texts one after the other, the least byte of a number first.
class Binary_writer
{
public:
  explicit Binary_writer(std::ostream& out) : out_(out) {}

  void number(std::uint32_t value)
  {
    for (int shift = 0; shift < 32; shift += 8)
      out_.put(char(value >> shift & 255));
  }

  void text(const std::string& value)
  {
    number(std::uint32_t(value.size()));
    out_ << value;
  }

  template <typename Weights>
  void weights(const Weights& values)
  {
    for (double weight : values)
      number(std::uint32_t(std::clamp(std::lround(weight / pair_weight_unit), -most_weight_steps, most_weight_steps) +
                           most_weight_steps));
  }

private:
  std::ostream& out_;
};

class Binary_reader
{
public:
  // Not from the stream itself, which would look at its state at every byte.
  Binary_reader(std::streambuf& in, const std::string& name) : in_(in), name_(name) {}

  [[noreturn]] void fail() const
  {
    throw Invalid_input(name_ + ": it is not a whole role model of this version; train it again, or get it again");
  }

  // \param most the largest value that it may have
  std::uint32_t number(std::uint32_t most)
  {
    std::uint32_t value = 0;
    for (int shift = 0; shift < 32; shift += 8)
      value |= std::uint32_t(byte()) << shift;
    if (value > most) fail();
    return value;
  }

  std::string text()
  {
    constexpr std::uint32_t longest_text = 1000;
    std::string value(number(longest_text), ' ');
    for (char& c : value)
      c = char(byte());
    return value;
  }

  template <typename Weights>
  void weights(Weights& values)
  {
    for (double& weight : values)
      weight = double(long(number(2 * most_weight_steps)) - most_weight_steps) * pair_weight_unit;
  }

  std::uint8_t byte()
  {
    const int value = in_.sbumpc();
    if (value < 0) fail();
    return std::uint8_t(value);
  }

private:
  std::streambuf& in_;
  const std::string& name_;
};

constexpr const char* magic = "shape_correspondence roles 5";
constexpr std::uint32_t most_categories = 1000, most_examples = 1000000, most_example_weight = 1000000000;

} // namespace

std::vector<std::string> Role_model::categories() const
{
  std::vector<std::string> result;
  for (const Category_roles& category : data_->categories)
    result.push_back(category.name);
  return result;
}

const std::vector<std::string>& Role_model::roles(const std::string& category) const
{
  return category_of(*data_, category).roles;
}

void Role_model::write(std::ostream& out) const
{
  Binary_writer write(out);
  write.text(magic);
  write.number(ROLE_FEATURE_COUNT);
  write.number(std::uint32_t(data_->trees));
  write.weights(data_->geometric_confidence);
  write.number(std::uint32_t(data_->categories.size()));
  for (const Category_roles& category : data_->categories) {
    write.text(category.name);
    write.number(std::uint32_t(category.roles.size()));
    for (const std::string& role : category.roles)
      write.text(role);
    write.number(std::uint32_t(category.classes.size()));
    for (const Role_class& known : category.classes) {
      write.number(known.role);
      write.text(known.fine);
      write.number(known.has_side);
    }
    write.weights(category.weights);
    write.weights(category.confidence);
    write.weights(category.geometric_confidence);
    category.forest.write(out);
    write.number(std::uint32_t(category.examples.size()));
    for (const Role_example& example : category.examples) {
      out.write(reinterpret_cast<const char*>(example.features.data()), std::streamsize(example.features.size()));
      out.put(char(example.role));
      write.number(std::uint32_t(std::min(example.weight, double(most_example_weight))));
    }
  }
}

Role_model Role_model::read(std::istream& in, const std::string& name)
{
  std::streambuf& bytes = *in.rdbuf();
  Binary_reader read(bytes, name);
  if (!in || read.text() != magic) read.fail();
  if (read.number(ROLE_FEATURE_COUNT) != ROLE_FEATURE_COUNT) read.fail();
  Role_model_data data;
  data.trees = int(read.number(maximum_trees));
  read.weights(data.geometric_confidence);
  data.categories.resize(read.number(most_categories));
  for (Category_roles& category : data.categories) {
    category.name = read.text();
    category.roles.resize(read.number(maximum_classes));
    for (std::string& role : category.roles)
      role = read.text();
    category.classes.resize(read.number(maximum_classes));
    for (Role_class& known : category.classes) {
      if (category.roles.empty()) read.fail();
      known.role = std::uint8_t(read.number(std::uint32_t(category.roles.size() - 1)));
      known.fine = read.text();
      known.has_side = read.number(1) == 1;
    }
    read.weights(category.weights);
    read.weights(category.confidence);
    read.weights(category.geometric_confidence);
    if (!category.forest.read(bytes, data.trees, int(category.classes.size()))) read.fail();
    const std::uint32_t count = read.number(most_examples);
    for (std::uint32_t i = 0; i < count; ++i) { // not reserved: a damaged file may promise more than it has
      Role_example& example = category.examples.emplace_back();
      for (std::uint8_t& value : example.features)
        value = read.byte();
      example.role = read.byte();
      if (example.role >= category.classes.size()) read.fail();
      example.weight = read.number(most_example_weight);
    }
  }
  return Role_model(std::move(data));
}

Part_roles part_roles(const Structural_graph& graph, const Role_model& model, const std::string& category)
{
  const Shape_roles shape(graph, model);
  Part_roles result;
  const std::size_t index = category.empty()
                                ? category_of_pair(shape, shape, model.data()).index
                                : std::size_t(&category_of(model.data(), category) - model.data().categories.data());
  if (index == model.data().categories.size()) return result;
  const Category_roles& known = model.data().categories[index];
  result.category = known.name;
  result.roles = known.roles;
  result.probabilities = shape.votes(index).roles.cast<double>() / double(model.data().trees);
  result.labels = shape.votes(index).labels;
  result.distance = shape.distance(index);
  return result;
}

} // namespace CGAL::Shape_correspondence
