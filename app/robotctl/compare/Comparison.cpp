// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/compare/Comparison.h"

#include <algorithm>
#include <array>

namespace app {
namespace {

using nlohmann::json;

/// Figures of the run itself that are comparable, with their units.
constexpr std::array<std::pair<const char*, const char*>, 5> kOwn{{{"ball_contacts", ""},
                                                                   {"ms_per_step", "ms"},
                                                                   {"ms_per_image", "ms"},
                                                                   {"ms_per_step_of_programs", "ms"},
                                                                   {"real_time_factor", ""}}};

constexpr std::array<std::pair<const char*, const char*>, 4> kOfWalk{
    {{"forward", "m/s"}, {"sideward", "m/s"}, {"rotation", "rad/s"}, {"least_upright", ""}}};

/// Means of what several robots have, each with its weight.
class Means {
 public:
  void add(const std::string& name, const std::string& unit, double value, double weight = 1) {
    if (!(weight > 0)) return;
    auto found = std::ranges::find(
        all_, name, [](const Sum& sum) -> const auto& { return sum.figure.name; });
    if (found == all_.end()) found = all_.insert(found, {{name, unit, 0}, 0});
    found->figure.value += weight * value;
    found->weight += weight;
  }
  std::vector<Figure> result() const {
    std::vector<Figure> figures;
    for (const Sum& sum : all_) {
      figures.push_back(sum.figure);
      figures.back().value /= sum.weight;
    }
    return figures;
  }

 private:
  struct Sum {
    Figure figure;
    double weight = 0;
  };
  std::vector<Sum> all_;
};

/// Shares are weighted by how many things they are of, where that is known.
void addShares(const std::string& name, const json& figures, Means& means) {
  for (const auto& [share, all] : {std::pair("missed", "there"), std::pair("false", "reported")})
    if (figures.contains(share) && figures[share].is_number())
      means.add(name + " " + share, kShare, figures[share].get<double>(), figures.value(all, 1.0));
}

void addQuantity(const std::string& name, const json& quantity, Means& means) {
  const std::string unit = quantity.value("unit", "");
  for (const char* statistic : {"mean", "median", "p95"})
    if (quantity.contains(statistic) && quantity[statistic].is_number())
      means.add(name + " " + statistic, unit.empty() ? kShare : unit, quantity[statistic].get<double>(),
                quantity.value("count", 1.0));
  addShares(name, quantity, means);
}

void addErrors(const json& packages, Means& means) {
  for (const auto& [path, package] : packages.items()) {
    for (const auto& [name, quantity] : package.items())
      if (quantity.is_object()) addQuantity(path + " " + name, quantity, means);
    addShares(path, package, means);
  }
}

}  // namespace

std::vector<Figure> figuresIn(const json& printed) {
  Means means;
  if (printed.contains("errors"))
    for (const auto& [robot, packages] : printed["errors"].items()) addErrors(packages, means);
  if (printed.contains("goals"))
    for (const auto& [team, count] : printed["goals"].items())
      if (count.is_number()) means.add("goals of " + team, "", count.get<double>());
  if (const auto walk = printed.find("walk"); walk != printed.end()) {
    for (const auto& [name, unit] : kOfWalk)
      if (walk->contains(name) && (*walk)[name].is_number())
        means.add(std::string("walk ") + name, unit, (*walk)[name].get<double>());
    if (walk->contains("fell")) means.add("walk fell", "", walk->at("fell") == true ? 1 : 0);
  }
  if (printed.contains("trials") && printed["trials"].is_number() && printed["trials"] > 0)
    for (const char* name : {"touched", "scored"})
      if (printed.contains(name))
        means.add(std::string("share of trials ") + name, "",
                  printed[name].get<double>() / printed["trials"].get<double>());
  for (const auto& [name, unit] : kOwn)
    if (printed.contains(name) && printed[name].is_number())
      means.add(name, unit, printed[name].get<double>());
  return means.result();
}

void Comparison::add(const std::string& variant, const std::string& subject,
                     const std::vector<Figure>& figures) {
  if (std::ranges::find(variants_, variant) == variants_.end()) variants_.push_back(variant);
  for (const Figure& figure : figures) {
    auto row = std::ranges::find(rows_, figure.name, &Row::name);
    if (row == rows_.end()) row = rows_.insert(row, {figure.name, figure.unit, {}});
    Cell& cell = row->byVariant[variant];
    cell.bySubject[subject] = figure.value;
    cell.mean.reset();
  }
}

MeanInterval Comparison::meanOf(const Row& row, const std::string& variant) {
  const auto cell = row.byVariant.find(variant);
  if (cell == row.byVariant.end()) return bootstrapMean({});
  if (!cell->second.mean) {
    std::vector<double> values;
    for (const auto& [subject, value] : cell->second.bySubject) values.push_back(value);
    cell->second.mean = bootstrapMean(values);
  }
  return *cell->second.mean;
}

std::optional<double> Comparison::Row::constant() const {
  std::optional<double> common;
  for (const auto& [variant, cell] : byVariant) {
    for (const auto& [subject, value] : cell.bySubject) {
      if (value != common.value_or(value)) return std::nullopt;
      common = value;
    }
  }
  return common;
}

std::vector<Difference> Comparison::differences() const {
  std::vector<Difference> all;
  std::vector<double> chances;
  for (const Row& row : rows_) {
    // Constant figures would only make the correction for multiple comparisons stricter.
    if (row.constant()) continue;
    for (std::size_t i = 0; i < variants_.size(); ++i) {
      for (std::size_t j = i + 1; j < variants_.size(); ++j) {
        const auto first = row.byVariant.find(variants_[i]), second = row.byVariant.find(variants_[j]);
        if (first == row.byVariant.end() || second == row.byVariant.end()) continue;
        std::vector<double> changes;
        for (const auto& [subject, value] : first->second.bySubject)
          if (const auto other = second->second.bySubject.find(subject);
              other != second->second.bySubject.end())
            changes.push_back(other->second - value);
        all.push_back({row.name, row.unit, variants_[i], variants_[j], changes.size(), bootstrapMean(changes),
                       chanceOf(changes)});
        chances.push_back(all.back().chance);
      }
    }
  }
  const std::vector<double> together = corrected(chances);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].chance = together[i];
  return all;
}

}  // namespace app
