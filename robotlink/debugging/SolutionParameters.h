// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/Error.h"

namespace robotlink {

struct SolutionDescription;

/// The sources of a program's parameters: files <task>.<solution>.textproto of a folder
/// (resources/parameters/<robot>; it may be missing), overridden by recorded values.
struct ParameterSource {
  std::filesystem::path folder = {};
  /// From a log; values of unknown solutions are ignored.
  std::vector<robotcontrol::ParameterValues> recorded = {};
};

/// The parameters of one solution on one robot: the defaults of its message type, overwritten by a file in
/// protobuf's text format if there is one. They persist while another solution is active. The message's
/// address never changes, even when this object is moved.
class SolutionParameters {
 public:
  /// The file <task>.<solution>.textproto or the whole folder may be missing. Fails with all errors of the
  /// file, each with its line and column.
  static tl::expected<SolutionParameters, Errors> load(const SolutionDescription& solution,
                                                       const std::filesystem::path& folder);
  SolutionParameters(SolutionParameters&&) noexcept;
  SolutionParameters& operator=(SolutionParameters&&) noexcept;
  ~SolutionParameters();
  SolutionParameters clone() const;

  /// Null if the solution has no parameters.
  const google::protobuf::Message* message() const { return message_.get(); }
  /// Replaces the parameters. Fails without changing anything if there are none, or if the value has another
  /// type, is damaged, or contains a number that is not finite or a text that is not UTF-8.
  Result<void> set(const robotcontrol::PackageCopy& value);
  /// Writes the current value, its schema, and as the default the value when it was loaded.
  void describe(robotcontrol::ParameterValues& to) const;

 private:
  explicit SolutionParameters(std::unique_ptr<google::protobuf::Message> message);
  std::unique_ptr<google::protobuf::Message> message_;
  /// The value when it was loaded, serialized.
  std::string defaults_;
};

}  // namespace robotlink
