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

/// Where the parameters of a program come from: files <task>.<solution>.textproto of a folder
/// (resources/parameters/<robot>; it may be missing), and over them what was recorded.
struct ParameterSource {
  std::filesystem::path folder = {};
  std::vector<robotcontrol::ParameterValues> recorded = {};  ///< of solutions that are unknown: ignored
};

/// The parameters of one solution on one robot: the defaults of its message type, overwritten by a file in
/// protobuf's text format if there is one. They are kept while the solution is switched off. The message's
/// address never changes.
class SolutionParameters {
 public:
  /// `folder` may lack the file <task>.<solution>.textproto, or be missing itself. Fails with every error of
  /// the file, each with its line and column.
  static tl::expected<SolutionParameters, Errors> load(const SolutionDescription& solution,
                                                       const std::filesystem::path& folder);
  SolutionParameters(SolutionParameters&&) noexcept;
  SolutionParameters& operator=(SolutionParameters&&) noexcept;
  ~SolutionParameters();
  SolutionParameters clone() const;

  /// Null if the solution has none.
  const google::protobuf::Message* message() const { return message_.get(); }
  /// Fails, and changes nothing, if it has none, or if the value is of another type, damaged, or not finite.
  Result<void> set(const robotcontrol::PackageCopy& value);
  /// The value with its type's description, and what it was when it was loaded as the default.
  void describe(robotcontrol::ParameterValues& to) const;

 private:
  explicit SolutionParameters(std::unique_ptr<google::protobuf::Message> message);
  std::unique_ptr<google::protobuf::Message> message_;
  std::string defaults_;  // serialised
};

}  // namespace robotlink
