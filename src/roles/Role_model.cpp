// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "roles/Role_model_data.h"
#include "roles/Shape_roles.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <iterator>
#include <limits>
#include <ostream>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace internal {

namespace {

constexpr double steps_per_deviation = 32; // steps of a byte per standard deviation, so that it covers four either way
constexpr double least_area_that_counts = 4; // added to the area of a part in its weight, in steps of the feature

} // namespace

std::size_t Role_model_data::index(const std::string& category) const
{
  const auto found =
      std::find_if(categories.begin(), categories.end(), [&](const Category_roles& c) { return c.name == category; });
  return std::size_t(found - categories.begin());
}

Role_distances::Role_distances(const std::vector<Category_roles>& categories)
{
  double count = 0;
  std::array<std::uint64_t, ROLE_FEATURE_COUNT> sums{}, sums_of_squares{};
  for (const Category_roles& category : categories) {
    count += double(category.examples.size());
    for (const Role_example& example : category.examples)
      for (std::size_t feature = 0; feature < ROLE_FEATURE_COUNT; ++feature) {
        const std::uint64_t value = example.features[feature];
        sums[feature] += value;
        sums_of_squares[feature] += value * value;
      }
  }
  for (std::size_t feature = 0; feature < ROLE_FEATURE_COUNT; ++feature) {
    const auto sum = double(sums[feature]), squares = double(sums_of_squares[feature]);
    const double variance = count > 0 ? squares / count - (sum / count) * (sum / count) : 0;
    const double scale = steps_per_deviation / std::sqrt(std::max(1., variance));
    for (int value = 0; value < 256; ++value)
      standard_[feature][std::size_t(value)] =
          std::uint8_t(std::lround(std::clamp((value - 127.) * scale + 127, 0., 255.)));
  }
  for (const Category_roles& category : categories)
    examples_.push_back(standardised(Eigen::Index(category.examples.size()), [&](Eigen::Index i) {
      return category.examples[std::size_t(i)].features.data();
    }));
}

template <typename Features>
Role_distances::Rows Role_distances::standardised(Eigen::Index rows, const Features& features) const
{
  Rows result = Rows::Zero(rows, row_length);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const std::uint8_t* const of_row = features(i);
    for (std::size_t feature = 0; feature < ROLE_FEATURE_COUNT; ++feature)
      result(i, Eigen::Index(feature)) = standard_[feature][of_row[feature]];
  }
  return result;
}

double Role_distances::mean_distance(const Role_features& parts, std::size_t category) const
{
  const Rows queries = standardised(parts.rows(), [&](Eigen::Index i) { return &parts(i, 0); });
  const Rows& examples = examples_[category];
  double sum = 0, weights = 0;
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
    const double weight = std::sqrt(parts(i, AREA) + least_area_that_counts);
    sum += weight * least;
    weights += weight;
  }
  return sum / (weights * int(ROLE_FEATURE_COUNT) * steps_per_deviation);
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
  throw Invalid_input("the role model does not have the category '" + name + "'; " +
                      (known.empty() ? "train it" : "use one of these: " + known));
}

constexpr const char* magic = "shape_correspondence roles 8";
constexpr std::uint32_t most_categories = 1000, most_examples = 1000000, most_example_weight = 1000000000;
constexpr long most_weight_steps = 1000000000; // limit of the absolute value of a weight, in `pair_weight_unit`

// Writes little-endian numbers, and texts with their lengths.
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
  Binary_reader(Stored_bytes bytes, const std::string& name) : bytes_(std::move(bytes)), name_(name) {}

  [[noreturn]] void fail() const
  {
    throw Invalid_input(name_ + ": it is not a whole role model of this version; train it again, or get it again");
  }

  // Reads a number; fails if it is more than `most`.
  std::uint32_t number(std::uint32_t most)
  {
    const std::uint8_t* const bytes = take(4);
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i)
      value |= std::uint32_t(bytes[i]) << 8 * i;
    if (value > most) fail();
    return value;
  }

  std::string text()
  {
    constexpr std::uint32_t longest_text = 1000;
    const std::uint32_t size = number(longest_text);
    return std::string(reinterpret_cast<const char*>(take(size)), size);
  }

  template <typename Weights>
  void weights(Weights& values)
  {
    for (double& weight : values)
      weight = double(long(number(2 * most_weight_steps)) - most_weight_steps) * pair_weight_unit;
  }

  // Takes the next bytes.
  const std::uint8_t* take(std::size_t size)
  {
    if (bytes_.size() < size) fail();
    bytes_.next += size;
    return bytes_.next - size;
  }

  Role_forest forest(int trees, std::size_t classes)
  {
    Role_forest result;
    if (!result.read(bytes_, trees, int(classes))) fail();
    return result;
  }

  std::shared_ptr<const Part_model> parts()
  {
    const auto result = std::make_shared<Part_model>();
    if (!result->read(bytes_)) fail();
    return result;
  }

  std::vector<Role_example> examples(std::size_t classes)
  {
    constexpr std::size_t example_size = ROLE_FEATURE_COUNT + 1 + 4;
    const std::uint32_t count = number(most_examples);
    if (bytes_.size() / example_size < count) fail(); // before memory is allocated
    std::vector<Role_example> result(count);
    for (Role_example& example : result) {
      std::copy_n(take(ROLE_FEATURE_COUNT), std::size_t(ROLE_FEATURE_COUNT), example.features.begin());
      example.role = *take(1);
      if (example.role >= classes) fail();
      example.weight = number(most_example_weight);
    }
    return result;
  }

private:
  Stored_bytes bytes_;
  const std::string& name_;
};

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
  write.number(data_->parts != nullptr);
  if (data_->parts) data_->parts->write(out);
}

Role_model_data internal::read_role_model_data(Stored_bytes bytes, const std::string& name)
{
  Binary_reader read(std::move(bytes), name);
  if (read.text() != magic) read.fail();
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
    category.forest = read.forest(data.trees, category.classes.size());
    category.examples = read.examples(category.classes.size());
  }
  if (read.number(1) == 1) data.parts = read.parts();
  return data;
}

Role_model Role_model::read(std::istream& in, const std::string& name)
{
  const auto bytes =
      std::make_shared<const std::string>(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  const auto* const begin = reinterpret_cast<const std::uint8_t*>(bytes->data());
  return Role_model(read_role_model_data({begin, begin + bytes->size(), bytes}, name));
}

Part_roles part_roles(const Structural_graph& graph, const Role_model& model, const std::string& category)
{
  const Shape_roles shape(graph, model);
  Part_roles result;
  const std::size_t index = category.empty() ? category_of_pair(shape, shape, Role_model_access::data(model)).index
                                             : std::size_t(&category_of(Role_model_access::data(model), category) -
                                                           Role_model_access::data(model).categories.data());
  if (index == Role_model_access::data(model).categories.size()) return result;
  const Category_roles& known = Role_model_access::data(model).categories[index];
  result.category = known.name;
  result.roles = known.roles;
  result.probabilities = shape.votes(index).roles.cast<double>() / double(Role_model_access::data(model).trees);
  result.labels = shape.votes(index).labels;
  result.distance = shape.distance(index);
  return result;
}

} // namespace CGAL::Shape_correspondence
