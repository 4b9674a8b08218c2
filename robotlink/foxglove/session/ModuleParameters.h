// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/foxglove/protocol/Value.h"

namespace google::protobuf {
class FieldDescriptor;
class Message;
}  // namespace google::protobuf
namespace robotcontrol {
class ParameterValues;
class Request;
class SolutionTable;
}  // namespace robotcontrol

namespace robotlink::websocket {

/// The parameters of solutions as parameters of the protocol: each field is one, by its path, as in
/// "red1/parameters/walking/gait/step/height". Numbers, bools and texts are what they are, enumerations are
/// their names, lists of these are arrays; the elements of lists of messages have their numbers in the path.
/// Fields of bytes are not offered. One thread.
class ModuleParameters {
 public:
  ModuleParameters();
  ~ModuleParameters();

  /// Takes a robot's report on a solution's parameters. Returns the changes for clients; those gone have
  /// no value.
  std::vector<Parameter> take(const std::string& robot, const robotcontrol::ParameterValues& values);
  /// The newest table of a robot's solutions: forgets what is not in it, and returns that.
  std::vector<Parameter> keep(const std::string& robot, const robotcontrol::SolutionTable& table);
  /// Forgets a robot.
  std::vector<Parameter> remove(const std::string& robot);

  /// A request for parameters that were never asked for; nothing if there is none.
  std::optional<robotcontrol::Request> nextToGet(const std::string& robot);

  /// A request that sets some was made: further ones change what it sets. take() brings what holds.
  void expect(const robotcontrol::Request& setting);

  bool has(const std::string& name) const { return places_.contains(name); }
  /// The requests that set them: one for each solution. Fails if a value does not fit its parameter; whether
  /// it makes sense the robot decides.
  Result<std::vector<robotcontrol::Request>> requestsFor(const std::vector<Parameter>& parameters) const;

 private:
  /// Robot, task, solution.
  using SolutionId = std::tuple<std::string, std::string, std::string>;
  using MessagePtr = std::unique_ptr<google::protobuf::Message>;
  struct Step {
    const google::protobuf::FieldDescriptor* field = nullptr;
    /// Negative: the field itself.
    int element = -1;
  };
  struct Place {
    SolutionId solution;
    std::vector<Step> path;
  };
  struct Known {
    MessagePtr message;
    std::map<std::string, Value> values;
  };
  void collect(const google::protobuf::Message& message, const std::string& prefix, Place place,
               std::map<std::string, Value>& values);
  void forget(const SolutionId& id, std::vector<Parameter>& changes);
  static Result<void> assign(google::protobuf::Message& message, const Place& place,
                             const Parameter& parameter);

  std::map<SolutionId, Known> solutions_;
  std::map<std::string, Place> places_;
  /// The solutions of the newest tables, each with whether its parameters were requested.
  std::map<SolutionId, bool> tables_;
};

}  // namespace robotlink::websocket
