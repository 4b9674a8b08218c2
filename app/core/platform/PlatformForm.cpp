// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/PlatformForm.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace app {
namespace {

/// The value of a field if it has this type, otherwise null.
template <typename T>
const T* valueOf(const FormValues& values, const std::string& field) {
  const auto found = values.find(field);
  return found == values.end() ? nullptr : std::get_if<T>(&found->second);
}

/// "both, red or blue"
std::string listed(const PlatformField::Items& items) {
  std::string list;
  for (std::size_t i = 0; i < items.size(); ++i)
    list += (i == 0 ? "" : i + 1 == items.size() ? " or " : ", ") + items[i].value;
  return list;
}

/// A number as people write it: "9000000000000000", "0.5".
std::string written(double number) {
  std::ostringstream text;
  if (number == std::floor(number)) text << std::fixed << std::setprecision(0);
  text << number;
  return text.str();
}

bool hasRange(const PlatformField& field) {
  return field.min < field.max;
}

std::string problemOfNumber(const PlatformField& field, double number) {
  // Written so that a NaN is out of range, too. 0 says that a field with a toggle does not count.
  const bool whole = field.decimals > 0 || number == std::floor(number);
  const bool inRange = hasRange(field) ? number >= field.min && number <= field.max : std::isfinite(number);
  if ((whole && inRange) || (!field.toggle.empty() && number == 0)) return {};
  std::string text = "the " + field.noun + " must be a " + (field.decimals > 0 ? "" : "whole ") + "number";
  if (hasRange(field)) text += " between " + written(field.min) + " and " + written(field.max);
  if (!field.unit.empty()) text += " " + field.unit;
  if (!field.toggle.empty()) text += ", or 0 for none";
  return text;
}

}  // namespace

PlatformField ownProcessField() {
  return {.name = "own",
          .kind = PlatformField::Kind::kFlag,
          .help =
              "The program of each robot runs in its own process: if it crashes or hangs, only that robot "
              "stops",
          .initial = false,
          .isArgument = false,
          .isShown = false,
          .option = "--own-process"};
}

bool flagOf(const FormValues& values, const std::string& field, bool fallback) {
  const bool* value = valueOf<bool>(values, field);
  return value != nullptr ? *value : fallback;
}

double numberOf(const FormValues& values, const std::string& field, double fallback) {
  const double* value = valueOf<double>(values, field);
  return value != nullptr ? *value : fallback;
}

std::string textOf(const FormValues& values, const std::string& field, const std::string& fallback) {
  const std::string* value = valueOf<std::string>(values, field);
  return value != nullptr ? *value : fallback;
}

const PlatformField* PlatformForm::field(const std::string& wanted) const {
  const auto found = std::ranges::find(fields, wanted, &PlatformField::name);
  return found == fields.end() ? nullptr : &*found;
}

std::vector<const PlatformField*> PlatformForm::arguments() const {
  std::vector<const PlatformField*> all;
  for (const PlatformField& field : fields) {
    if (field.isArgument) all.push_back(&field);
  }
  return all;
}

FormValues initialValues(const PlatformForm& form) {
  FormValues values;
  for (const PlatformField& field : form.fields) {
    const bool number = std::holds_alternative<double>(field.initial);
    values[field.name] = field.toggle.empty() ? field.initial : number ? FormValue(0.0) : std::string();
  }
  return values;
}

std::string rangeOf(const PlatformField& field) {
  return hasRange(field) ? written(field.min) + " to " + written(field.max) : "";
}

std::string problemOf(const PlatformField& field, const FormValue& value) {
  if (value.index() != field.initial.index()) return "the " + field.noun + " has a value of another type";
  if (const auto* number = std::get_if<double>(&value)) return problemOfNumber(field, *number);
  const auto* text = std::get_if<std::string>(&value);
  if (text != nullptr && field.check) return field.check(*text);
  if (text == nullptr || text->empty() || field.kind != PlatformField::Kind::kChoice || field.editable)
    return {};
  const PlatformField::Items items = field.items ? field.items() : PlatformField::Items{};
  if (std::ranges::find(items, *text, &PlatformField::Item::value) != items.end()) return {};
  return "the " + field.noun + " must be " + listed(items) + ", not '" + *text + "'";
}

std::string problemOf(const PlatformForm& form, const FormValues& values) {
  for (const PlatformField& field : form.fields) {
    const auto value = values.find(field.name);
    if (value == values.end()) continue;
    if (std::string problem = problemOf(field, value->second); !problem.empty()) return problem;
  }
  return {};
}

}  // namespace app
