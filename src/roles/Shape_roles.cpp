// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "roles/Shape_roles.h"
#include "base/quantized.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

namespace {

// Drops the fine labels of a role where at least half of them repeat, as of a table with four front legs: they do not
// distinguish its parts.
void drop_repeated_fine_labels(std::vector<Part_label>& labels)
{
  std::map<std::string, std::vector<std::size_t>> parts_of_role;
  for (std::size_t part = 0; part < labels.size(); ++part)
    parts_of_role[labels[part].coarse].push_back(part);
  for (const auto& [role, parts] : parts_of_role) {
    std::set<std::string> distinct;
    for (std::size_t part : parts)
      distinct.insert(labels[part].fine);
    if (2 * distinct.size() > parts.size()) continue;
    for (std::size_t part : parts)
      labels[part].fine.clear();
  }
}

// For each role, the number of labelled parts, and the number of those that stand on the ground.
Eigen::MatrixX2i parts_of_roles(const Category_roles& category)
{
  Eigen::MatrixX2i result = Eigen::MatrixX2i::Zero(Eigen::Index(category.roles.size()), 2);
  for (const Role_example& example : category.examples) {
    const Eigen::Index role = category.classes[example.role].role;
    ++result(role, 0);
    result(role, 1) += example.features[ON_GROUND] > 0;
  }
  return result;
}

// Votes of a part on the ground for roles of which hardly a labelled part stands there, such as the seat of a chair,
// go to the likeliest other role.
void move_votes_on_ground(const Eigen::MatrixX2i& known, Eigen::Ref<Eigen::RowVectorXi, 0, Eigen::InnerStride<>> votes)
{
  // Least number of labelled parts of a role to judge by; "hardly" means at most one of `most_rarely` parts
  constexpr int least_parts = 20, most_rarely = 50;
  const auto never_stands = [&](Eigen::Index role) {
    return known(role, 0) >= least_parts && known(role, 1) * most_rarely <= known(role, 0);
  };
  Eigen::Index best = -1;
  for (Eigen::Index role = 0; role < votes.size(); ++role)
    if (!never_stands(role) &&
        (best < 0 || std::make_pair(votes[role], known(role, 1)) > std::make_pair(votes[best], known(best, 1))))
      best = role;
  for (Eigen::Index role = 0; role < votes.size() && best >= 0; ++role)
    if (never_stands(role)) {
      votes[best] += votes[role];
      votes[role] = 0;
    }
}

Role_votes counted(const Role_evidence& evidence, const Category_roles& category)
{
  const Eigen::MatrixXi of_classes = category.forest.votes(evidence.features, int(category.classes.size()));
  Role_votes result;
  result.roles = Eigen::MatrixXi::Zero(of_classes.rows(), Eigen::Index(category.roles.size()));
  for (Eigen::Index k = 0; k < of_classes.cols(); ++k)
    result.roles.col(category.classes[std::size_t(k)].role) += of_classes.col(k);
  const Eigen::MatrixX2i known = parts_of_roles(category);
  for (Eigen::Index part = 0; part < of_classes.rows(); ++part) {
    if (evidence.features(part, ON_GROUND) > 0) move_votes_on_ground(known, result.roles.row(part));
    Eigen::Index role = 0;
    result.roles.row(part).maxCoeff(&role);
    const Role_class* best = nullptr;
    int most = -1;
    for (std::size_t k = 0; k < category.classes.size(); ++k)
      if (category.classes[k].role == role && of_classes(part, Eigen::Index(k)) > most) {
        most = of_classes(part, Eigen::Index(k));
        best = &category.classes[k];
      }
    const Side side = evidence.sides[std::size_t(part)];
    const char* const suffix = !best->has_side       ? ""
                               : side == Side::LEFT  ? "_left"
                               : side == Side::RIGHT ? "_right"
                                                     : "";
    result.labels.push_back({category.roles[std::size_t(role)], best->fine + suffix});
  }
  drop_repeated_fine_labels(result.labels);
  return result;
}

std::vector<Part_label> chosen(const std::vector<Part_label>& labels, const std::vector<std::size_t>& parts)
{
  std::vector<Part_label> result;
  for (std::size_t part : parts)
    result.push_back(labels[part]);
  return result;
}

} // namespace

Shape_roles::Shape_roles(const Structural_graph& graph, const Role_model& model, int quarter_turns)
    : Shape_roles(role_evidence(graph, quarter_turns), model)
{}

Shape_roles::Shape_roles(Role_evidence evidence, const Role_model& model)
    : Shape_roles(std::function<Role_evidence()>(), model)
{
  has_evidence_([&] { evidence_ = std::move(evidence); });
}

Shape_roles::Shape_roles(std::function<Role_evidence()> find_evidence, const Role_model& model)
    : model_(model),
      find_evidence_(std::move(find_evidence)),
      findings_(std::make_unique<Findings[]>(Role_model_access::data(model).categories.size()))
{}

const Role_evidence& Shape_roles::evidence() const
{
  has_evidence_([&] { evidence_ = find_evidence_(); });
  return evidence_;
}

double Shape_roles::distance(std::size_t category) const
{
  Findings& found = findings_[category];
  found.distance_is_found(
      [&] { found.distance = Role_model_access::distances(model_).mean_distance(evidence().features, category); });
  return found.distance;
}

bool Shape_roles::is_nearest(std::size_t category) const
{
  for (std::size_t other = 0; other < Role_model_access::data(model_).categories.size(); ++other)
    if (distance(other) < distance(category)) return false;
  return true;
}

const Role_votes& Shape_roles::votes(std::size_t category) const
{
  Findings& found = findings_[category];
  found.votes_are_counted(
      [&] { found.votes = counted(evidence(), Role_model_access::data(model_).categories[category]); });
  return found.votes;
}

namespace {

double distance_of(const Shape_roles& shape, std::size_t category) { return shape.distance(category); }

// Mean over the parts of the logarithm of the share of trees that vote for the likeliest role.
double agreement_of_trees(const Shape_roles& shape, std::size_t category, int trees)
{
  const Eigen::MatrixXi& votes = shape.votes(category).roles;
  return (votes.rowwise().maxCoeff().cast<double>().array() / trees).log().mean();
}

// The least distance of a shape from a category over the quarter turns.
double distance_of(const Turned_roles& shape, std::size_t category)
{
  double least = shape[0]->distance(category);
  for (const auto& turned : shape)
    least = std::min(least, turned->distance(category));
  return least;
}

Steps clear_difference(const Role_options& options) { return -quantized(std::log(1 - options.clearly_better)); }

} // namespace

int likely_front(const Turned_roles& shape, std::size_t category, int trees, const Role_options& options)
{
  const auto agreement = [&](int turn) { return agreement_of_trees(*shape[std::size_t(turn)], category, trees); };
  const auto likeness = [&](int turn, double agreement) {
    return quantized((agreement - shape[std::size_t(turn)]->distance(category)) / 2);
  };
  Steps most = likeness(0, agreement(0)) + clear_difference(options);
  int best = 0;
  // The likeness is at most half of the agreement, which is at most 0: turns that cannot be clearly better are skipped
  for (int turn = 1; turn < 4 && most < 0; ++turn) {
    const double agreed = agreement(turn);
    if (quantized(agreed / 2) <= most) continue;
    const Steps found = likeness(turn, agreed);
    if (found > most) most = found, best = turn;
  }
  if (best == 0 || !shape[std::size_t(best)]->is_nearest(category)) return 0;
  // Trees agree on what they have not seen, too: no turn to where the parts are clearly less like labelled ones
  const auto distance = [&](int turn) { return shape[std::size_t(turn)]->distance(category); };
  if (quantized((1 - options.clearly_better) * distance(best)) > quantized(distance(0))) return 0;
  // A shape that is nearly as likely at another turn, like a table seen from behind, has no clear front
  for (int turn = 1; turn < 4; ++turn)
    if (turn != best && likeness(turn, agreement(turn)) > most - clear_difference(options)) return 0;
  return best;
}

namespace {

// Distances and indices of the categories, the nearest first. \param distance function of the index of a category
template <typename Distance>
std::vector<std::pair<double, std::size_t>> by_distance(const Role_model_data& model, const Distance& distance)
{
  std::vector<std::pair<double, std::size_t>> result;
  for (std::size_t category = 0; category < model.categories.size(); ++category)
    result.emplace_back(distance(category), category);
  std::sort(result.begin(), result.end());
  return result;
}

// Whether the first of sorted categories is near, and much nearer than the second one.
bool is_clear(const std::vector<std::pair<double, std::size_t>>& categories, const Role_options& options)
{
  return !categories.empty() && categories[0].first <= options.category_distance &&
         (categories.size() == 1 || categories[0].first <= options.category_ratio * categories[1].first);
}

// The category to which a shape clearly belongs; the number of categories if there is none.
template <typename Roles>
std::size_t clear_category(const Roles& shape, const Role_model_data& model, const Role_options& options)
{
  const auto categories = by_distance(model, [&](std::size_t category) { return distance_of(shape, category); });
  return is_clear(categories, options) ? categories[0].second : categories.size();
}

template <typename Roles>
Pair_category category_of_both(const Roles& source, const Roles& target, const Role_model_data& model,
                               const Role_options& options)
{
  const std::size_t none = model.categories.size();
  if (none == 0) return {none, "The role model knows no category; the parts were matched by geometry alone.", none};
  const auto categories = by_distance(
      model, [&](std::size_t category) { return (distance_of(source, category) + distance_of(target, category)) / 2; });
  const std::size_t nearest = categories[0].second;
  const std::size_t a = clear_category(source, model, options), b = clear_category(target, model, options);
  if (a != b && a != none && b != none)
    return {none,
            "The parts of one shape are like those of the category " + model.categories[std::min(a, b)].name +
                ", those of the other like " + model.categories[std::max(a, b)].name +
                "; the parts were matched by geometry alone.",
            nearest};
  if (is_clear(categories, options)) return {nearest, "", nearest};
  return {none,
          "The shapes are not clearly of a category that the role model knows (the nearest is " +
              model.categories[nearest].name + "); the parts were matched by geometry alone.",
          nearest};
}

} // namespace

Pair_category category_of_pair(const Shape_roles& source, const Shape_roles& target, const Role_model_data& model,
                               const Role_options& options)
{
  return category_of_both(source, target, model, options);
}

Pair_category category_of_pair(const Turned_roles& source, const Turned_roles& target, const Role_model_data& model,
                               const Role_options& options)
{
  return category_of_both(source, target, model, options);
}

std::vector<int> front_turns(const Turned_roles& shape, std::size_t category, int trees, const Role_options& options)
{
  std::array<Steps, 4> agreement{};
  for (std::size_t turn = 0; turn < 4; ++turn)
    agreement[turn] = quantized(agreement_of_trees(*shape[turn], category, trees));
  const Steps least = *std::max_element(agreement.begin(), agreement.end()) - clear_difference(options);
  std::vector<int> result;
  for (int turn = 0; turn < 4; ++turn)
    if (agreement[std::size_t(turn)] >= least) result.push_back(turn);
  return result;
}

Eigen::MatrixXd agreement_of_votes(const Role_votes& source, const Role_votes& target)
{
  Eigen::MatrixXd result(source.roles.rows(), target.roles.rows());
  for (Eigen::Index i = 0; i < result.rows(); ++i)
    for (Eigen::Index j = 0; j < result.cols(); ++j) {
      const auto a = source.roles.row(i), b = target.roles.row(j);
      result(i, j) = a.dot(b) / std::sqrt(double(a.squaredNorm()) * b.squaredNorm());
    }
  return result;
}

Pair_terms role_terms(const Role_votes& source, const std::vector<std::size_t>& source_parts, const Role_votes& target,
                      const std::vector<std::size_t>& target_parts)
{
  const std::size_t m = target_parts.size();
  const auto row = [m](std::size_t i, std::size_t j) { return Eigen::Index(i * m + j); };
  Pair_terms result = Pair_terms::Zero(row(source_parts.size(), 0), PAIR_TERM_COUNT);
  const Eigen::MatrixXd agreement = agreement_of_votes(source, target);
  for (std::size_t i = 0; i < source_parts.size(); ++i)
    for (std::size_t j = 0; j < m; ++j) {
      result(row(i, j), VOTES_AGREE) = agreement(Eigen::Index(source_parts[i]), Eigen::Index(target_parts[j]));
      result(row(i, j), SAME_ROLE) = source.labels[source_parts[i]].coarse == target.labels[target_parts[j]].coarse;
    }
  for (const auto& [i, j] :
       ground_truth(chosen(source.labels, source_parts), chosen(target.labels, target_parts)).pairs)
    result(row(i, j), SAME_LABEL) = 1;
  result.col(CONSTANT).setOnes();
  return result;
}

Pair_terms with_geometric_terms(Pair_terms terms, const Eigen::MatrixXd& costs,
                                const std::vector<Part_correspondence>& pairs)
{
  const Eigen::MatrixXd excess = excess_of_pairs(costs);
  const auto row = [m = excess.cols()](Eigen::Index i, Eigen::Index j) { return i * m + j; };
  for (Eigen::Index i = 0; i < excess.rows(); ++i)
    for (Eigen::Index j = 0; j < excess.cols(); ++j)
      terms(row(i, j), EXCESS) = excess(i, j);
  for (const Part_correspondence& pair : pairs)
    terms(row(Eigen::Index(pair.source), Eigen::Index(pair.target)), GEOMETRIC_PAIR) = 1;
  return terms;
}

} // namespace CGAL::Shape_correspondence::internal
