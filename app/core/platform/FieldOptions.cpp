// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/FieldOptions.h"

#include <CLI/CLI.hpp>

namespace app {
namespace {

using Kind = PlatformField::Kind;

template <typename T>
CLI::Option* addValueOption(CLI::App& command, const PlatformField& field, FieldOptions& options) {
  if (field.several) {
    return command.add_option_function<std::vector<T>>(
        field.option,
        [&list = options.lists, name = field.name](const std::vector<T>& values) {
          list[name].assign(values.begin(), values.end());
        },
        field.help);
  }
  return command.add_option_function<T>(
      field.option, [&values = options.values, name = field.name](const T& value) { values[name] = value; },
      field.help);
}

/// Returns the problem with the text of a number; empty if there is none, or if it is not a number, which the
/// parser reports.
std::string problemOfText(const PlatformField& field, const std::string& text) {
  double number = 0;
  return CLI::detail::lexical_cast(text, number) ? problemOf(field, number) : "";
}

void addNumberOption(CLI::App& command, const PlatformField& field, FieldOptions& options) {
  CLI::Option* option = addValueOption<double>(command, field, options);
  const std::string range = rangeOf(field);
  option->type_name(std::string(field.decimals > 0 ? "FLOAT" : "INT") + (range.empty() ? "" : ":" + range));
  option->check([field](const std::string& text) { return problemOfText(field, text); });
}

void addTextOption(CLI::App& command, const PlatformField& field, FieldOptions& options) {
  CLI::Option* option = addValueOption<std::string>(command, field, options);
  if (field.check) option->check(field.check);
  if (!field.items || field.editable) return;
  std::vector<std::string> allowed;
  for (const auto& item : field.items()) allowed.push_back(item.value);
  option->check(CLI::IsMember(allowed));
}

}  // namespace

void FieldOptions::addTo(CLI::App& command, const PlatformField& field) {
  if (command.get_option_no_throw(field.option) != nullptr) return;
  if (field.kind == Kind::kFlag) {
    command.add_flag_callback(
        field.option, [this, name = field.name] { values[name] = true; }, field.help);
  } else if (field.kind == Kind::kNumber) {
    addNumberOption(command, field, *this);
  } else {
    addTextOption(command, field, *this);
  }
}

bool FieldOptions::given(const PlatformField& field) const {
  return values.contains(field.name) || lists.contains(field.name);
}

}  // namespace app
