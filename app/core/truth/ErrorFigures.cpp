// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/truth/ErrorFigures.h"

#include <fmt/format.h>

#include <algorithm>

#include "robotlink/truth/TruthErrors.h"

namespace app {
namespace {

using nlohmann::json;
using robotlink::ErrorSamples;
using robotlink::PackageErrors;
using robotlink::TruthErrors;

constexpr char kMissed[] = "missed", kFalse[] = "false", kLatency[] = "latency";

json figuresOf(const ErrorSamples& samples, const std::string& unit) {
  json figures{{"unit", unit}, {"count", samples.count()}, {"mean", samples.mean()}};
  if (unit == robotlink::kShareOfTime) return figures;
  figures["median"] = samples.quantile(0.5);
  figures["p95"] = samples.quantile(0.95);
  figures["max"] = samples.maximum();
  return figures;
}

/// Adds shares, and of how many they are.
void addShares(const robotlink::ErrorCounts& counts, json& figures) {
  const auto share = [](std::size_t part, std::size_t all) {
    return static_cast<double>(part) / static_cast<double>(all);
  };
  if (counts.there > 0) {
    figures[kMissed] = share(counts.missed, counts.there);
    figures["there"] = counts.there;
  }
  if (counts.reported > 0) {
    figures[kFalse] = share(counts.invented, counts.reported);
    figures["reported"] = counts.reported;
  }
}

json figuresOf(const PackageErrors& errors) {
  json figures = json::object();
  for (const auto& [name, quantity] : errors.quantities) {
    figures[name] = figuresOf(quantity.amounts, quantity.unit);
    addShares(quantity.own, figures[name]);
  }
  addShares(errors, figures);
  if (errors.latency.count() > 0) figures[kLatency] = figuresOf(errors.latency, "s");
  return figures;
}

/// The path of a stream, with the solution where several have published it.
std::string titleOfErrors(const robotlink::ErrorSource& source, const TruthErrors::Packages& all) {
  const auto several =
      std::ranges::count(all, source.path, [](const auto& entry) { return entry.first.path; });
  return several > 1 ? fmt::format("{} ({})", source.path, source.solution) : source.path;
}

std::string shareText(const json& package, const char* name) {
  return package.contains(name) ? fmt::format("{:.1f} %", 100 * package[name].get<double>())
                                : std::string("-");
}

/// A number of an error in the unit that users read: mm, degrees, ms, or a share in percent.
std::string amountText(const json& quantity, const char* name) {
  if (!quantity.contains(name) || quantity["count"] == 0) return "-";
  const double amount = quantity[name];
  const std::string unit = quantity["unit"];
  if (unit == "m") return fmt::format("{:.0f} mm", 1000 * amount);
  if (unit == "rad") return fmt::format("{:.1f}°", amount * 180 / 3.14159265358979);
  if (unit == "s") return fmt::format("{:.0f} ms", 1000 * amount);
  return fmt::format("{:.1f} %", 100 * amount);
}

}  // namespace

json errorFigures(const TruthErrors& errors) {
  json figures = json::object();
  for (const auto& [robot, packages] : errors.errors())
    for (const auto& [source, package] : packages)
      figures[robot][titleOfErrors(source, packages)] = figuresOf(package);
  return figures;
}

std::string errorsText(const json& figures) {
  std::string text;
  const auto line = [&](const std::string& robot, const std::string& package, const std::string& quantity,
                        const auto&... columns) {
    text += fmt::format("{:<8} {:<22} {:<15}", robot, package, quantity);
    ((text += fmt::format(" {:>9}", columns)), ...);
    text += "\n";
  };
  if (!figures.empty()) line("robot", "package", "error", "mean", "median", "95 %", "missed", "false");
  for (const auto& [robot, packages] : figures.items()) {
    for (const auto& [path, package] : packages.items()) {
      for (const auto& [name, quantity] : package.items()) {
        if (!quantity.is_object()) continue;
        const bool hasOwn = quantity.contains(kMissed) || quantity.contains(kFalse);
        line(robot, path, name, amountText(quantity, "mean"), amountText(quantity, "median"),
             amountText(quantity, "p95"), shareText(hasOwn ? quantity : package, kMissed),
             shareText(hasOwn ? quantity : package, kFalse));
      }
    }
  }
  return text;
}

}  // namespace app
