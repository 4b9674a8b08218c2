// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/Error.h"
#include "robotlink/debugging/ParameterRules.h"

namespace robotlink {

struct RobotSetup;
struct SolutionDescription;

/// The sources of a program's parameters: files <task>.<solution>.textproto of a folder
/// (resources/parameters/<robot>; it may be missing), overridden by recorded values.
struct ParameterSource {
  std::filesystem::path folder = {};
  /// The values from a log; those of unknown solutions are ignored.
  std::vector<robotcontrol::ParameterValues> recorded = {};
};

/// The parameters of one solution on one robot: the built-in values that its registration states, overwritten
/// by a file in protobuf's text format if there is one. They persist while another solution is active. The
/// message's address never changes, even when this object is moved.
class SolutionParameters {
 public:
  /// The file <task>.<solution>.textproto or the whole folder may be missing. A number that makes no sense
  /// keeps its built-in value, because 0 stood for that in older files. Fails with all errors of the file,
  /// each with its line and column.
  static tl::expected<SolutionParameters, Errors> load(const SolutionDescription& solution,
                                                       const std::filesystem::path& folder,
                                                       const RobotSetup& robot);
  SolutionParameters(SolutionParameters&&) noexcept;
  SolutionParameters& operator=(SolutionParameters&&) noexcept;
  ~SolutionParameters();
  SolutionParameters clone() const;

  /// Null if the solution has no parameters.
  const google::protobuf::Message* message() const { return message_.get(); }
  /// Replaces the parameters; what is not set gets its built-in value. Fails without changing anything if
  /// there are none, or if the value has another type, is damaged, or contains a number that is not finite or
  /// makes no sense, or a text that is not UTF-8, or if the solution's own check finds something.
  Result<void> set(const robotcontrol::PackageCopy& value);
  /// The same with a value from a log, which may be older than the rules: a number that makes no sense gets
  /// its built-in value.
  Result<void> restore(const robotcontrol::PackageCopy& value);
  /// Makes the current value the default, since it was written to the file.
  void markSaved();
  /// Writes the current value, its schema, its limits and where they are from; the default is the value when
  /// it was loaded or saved.
  void describe(robotcontrol::ParameterValues& to) const;

 private:
  /// `builtIn` is null if there are no parameters.
  SolutionParameters(std::unique_ptr<google::protobuf::Message> builtIn, const ParameterRules& rules);
  /// The value as a message of the right type.
  Result<std::unique_ptr<google::protobuf::Message>> parse(const robotcontrol::PackageCopy& value) const;
  /// Replaces the parameters by what is set in a message, else by the built-in values.
  void apply(const google::protobuf::Message& wanted);
  /// Clears the numbers of a message that make no sense.
  void dropUnreasonable(google::protobuf::Message& message) const;

  /// Null, like message_, if there are no parameters. Its lists are empty.
  std::unique_ptr<google::protobuf::Message> builtIn_;
  ParameterRules rules_;
  std::unique_ptr<google::protobuf::Message> message_;
  /// The value when it was loaded or saved, serialized.
  std::string defaults_;
  /// Empty: there is no folder.
  std::string file_;
};

}  // namespace robotlink
