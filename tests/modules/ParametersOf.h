// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fstream>
#include <string>

#include "robotlink/debugging/Solution.h"
#include "robotlink/debugging/SolutionParameters.h"
#include "tests/TestFolder.h"

namespace modules {

/// The parameters of a registered solution, as a program has them: the test writes their file, and sets them
/// as a user does.
template <typename P>
class ParametersOf {
 public:
  ParametersOf(const std::string& task, const std::string& name, const std::string& file = "",
               const robotlink::RobotSetup& robot = {})
      : parameters_(load(task, name, file, robot)) {}

  /// Returns the reason why the values are refused; empty if they are not.
  std::string set(const P& values) {
    const auto result = parameters_.set(packed(values));
    return result ? "" : result.error().text;
  }
  /// The same with values from a log.
  std::string restore(const P& values) {
    const auto result = parameters_.restore(packed(values));
    return result ? "" : result.error().text;
  }
  const P& values() const { return static_cast<const P&>(*parameters_.message()); }
  /// The defaults that a view is told.
  P defaults() const {
    robotcontrol::ParameterValues described;
    parameters_.describe(described);
    P values;
    values.ParseFromString(described.defaults().data());
    return values;
  }

 private:
  static robotlink::SolutionParameters load(const std::string& task, const std::string& name,
                                            const std::string& file, const robotlink::RobotSetup& robot) {
    const TestFolder folder;
    if (!file.empty()) std::ofstream(folder / (task + "." + name + ".textproto")) << file;
    return std::move(robotlink::SolutionParameters::load(*robotlink::SolutionRegistry::find(task, name),
                                                         folder.path(), robot)
                         .value());
  }
  static robotcontrol::PackageCopy packed(const P& values) {
    robotcontrol::PackageCopy packed;
    packed.set_type(values.GetTypeName());
    packed.set_data(values.SerializeAsString());
    return packed;
  }

  robotlink::SolutionParameters parameters_;
};

/// The names of the fields of a message that are not set, apart from those without presence.
inline std::string namesOfUnset(const google::protobuf::Message& message) {
  std::string unset;
  const auto& descriptor = *message.GetDescriptor();
  for (int i = 0; i < descriptor.field_count(); ++i) {
    const auto* field = descriptor.field(i);
    if (field->has_presence() && !message.GetReflection()->HasField(message, field))
      unset += field->name() + " ";
  }
  return unset;
}

}  // namespace modules
