// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/message.h>

#include <type_traits>
#include <variant>
#include <vector>

#include "robotlink/debugging/ParameterRules.h"

namespace robotlink {

/// How the fields of a parameter message correspond to the options of an algorithm: which field sets which
/// option, and in what range it makes sense. The built-in values are those of the options themselves, so that
/// they are in one place.
///
///     const ParameterTable<Wanderer::Options> kTable{
///         {robotcontrol::WanderParameters::kSpeedFieldNumber, &Wanderer::Options::speed, kAtLeastZero},
///         ...};
///     ... .parameters<robotcontrol::WanderParameters>(kTable.rules<robotcontrol::WanderParameters>());
///     options = kTable.read(parameters_);
///
/// Fields have the type double or int32 and are `optional`: 0 is a value like others. Immutable.
template <typename Options>
class ParameterTable {
 public:
  /// A member of the options, or a function that finds it in a part of them.
  using Place = std::variant<double Options::*, int Options::*, double& (*)(Options&), int& (*)(Options&)>;
  struct Entry {
    ParameterField field;
    Place place;
    ParameterRange range = {};
  };
  ParameterTable(std::initializer_list<Entry> entries) : entries_(entries) {}

  /// Returns the options that the parameters set. Values that are unset, or out of range, stay as built in.
  Options read(const google::protobuf::Message& parameters, Options builtIn = {}) const {
    for (const Entry& entry : entries_) {
      const std::optional<double> number = numberIn(parameters, entry.field);
      if (!number || !entry.range.has(*number)) continue;
      visit(entry, builtIn,
            [&](auto& option) { option = static_cast<std::remove_reference_t<decltype(option)>>(*number); });
    }
    return builtIn;
  }

  /// The rules for a solution whose parameters are of type P; `builtIn` computes the options of a robot where
  /// they depend on it.
  template <typename P>
  ParameterRules rules(std::function<Options(const RobotSetup&)> builtIn = {}) const {
    ParameterRules rules;
    for (const Entry& entry : entries_) rules.ranges[entry.field] = entry.range;
    rules.builtIn = [entries = entries_, builtIn](const RobotSetup& robot) {
      Options options = builtIn ? builtIn(robot) : Options{};
      auto message = std::make_unique<P>();
      for (const Entry& entry : entries)
        visit(entry, options, [&](const auto& option) { setNumber(*message, entry.field, option); });
      return message;
    };
    return rules;
  }

 private:
  template <typename Use>
  static void visit(const Entry& entry, Options& options, Use use) {
    std::visit(
        [&](auto place) {
          if constexpr (std::is_member_object_pointer_v<decltype(place)>) {
            use(options.*place);
          } else {
            use(place(options));
          }
        },
        entry.place);
  }

  std::vector<Entry> entries_;
};

// The usual ranges.
inline constexpr ParameterRange kAtLeastZero{};
inline constexpr ParameterRange kAboveZero{0, std::numeric_limits<double>::infinity(), true};
inline constexpr ParameterRange kAtLeastOne{1};
/// A share of a whole.
inline constexpr ParameterRange kShare{0, 1};

}  // namespace robotlink
