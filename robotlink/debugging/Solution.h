// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/debugging/DebugContext.h"
#include "robotlink/debugging/ParameterRules.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/process/Link.h"

namespace google::protobuf {
class Descriptor;
}

namespace robotlink {

struct FieldDescription;
struct GroundMap;

/// A package as the tasks of a process see it. Its address is valid as long as the process lives.
struct PackageSlot {
  /// Null before the first package.
  PackagePtr value;
  /// Whether the package arrived since the task last ran.
  bool isNew = false;
};

/// A package that a solution reads. A handle; valid as long as the process lives.
template <typename T>
class Input {
 public:
  explicit Input(const PackageSlot& slot) : slot_(&slot) {}
  /// Null before the first package. The cast is safe because packages have one type each.
  const T* get() const { return static_cast<const T*>(slot_->value.get()); }
  const T* operator->() const { return get(); }
  // Only if get() is not null.
  const T& operator*() const { return *get(); }
  explicit operator bool() const { return get() != nullptr; }
  /// Whether it arrived since the task last ran.
  bool isNew() const { return slot_->isNew; }

 private:
  const PackageSlot* slot_;
};

/// A package that a solution yields. A package that was sent is seen at once by the later tasks of its
/// process, and by other processes from then on. If nothing is sent in a frame, readers keep the previous
/// package.
template <typename T>
class Output {
 public:
  using Send = std::function<void(PackagePtr)>;
  explicit Output(Send send) : send_(std::move(send)) {}
  void send(std::shared_ptr<const T> package) { send_(PackagePtr(std::move(package))); }

 private:
  Send send_;
};

/// The properties of the robot that every solution may read. Immutable.
struct RobotSetup {
  std::string name;  ///< "red1"
  std::string team;  ///< one of the field's teams; empty: none
  RobotDescription description;
  std::shared_ptr<const FieldDescription> field;
  /// The map of the building that it drives in; null if it has none.
  std::shared_ptr<const GroundMap> map = {};
};

/// The environment of a solution, passed to its constructor: inputs and outputs, parameters, and the debug
/// context of its process. It outlives the solution, which may keep a reference. Only for the process's
/// thread.
class SolutionContext {
 public:
  virtual ~SolutionContext() = default;
  virtual const RobotSetup& robot() const = 0;
  virtual const Clock& clock() const = 0;
  virtual DebugContext& debug() = 0;

  /// Only packages that the solution's registration declares; any other throws std::logic_error.
  template <typename T>
  Input<T> input(Package<T> package) {
    return Input<T>(inputSlot(package.name));
  }
  template <typename T>
  Output<T> output(Package<T> package) {
    return Output<T>(outputSend(package.name));
  }
  /// The solution's parameters. The reference stays valid; the contents change only between frames.
  template <typename P>
  const P& parameters() {
    return static_cast<const P&>(parameterMessage());
  }

 protected:
  virtual const PackageSlot& inputSlot(const char* package) = 0;
  virtual std::function<void(PackagePtr)> outputSend(const char* package) = 0;
  virtual const google::protobuf::Message& parameterMessage() = 0;
};

/// A way to do a task. Constructed when it is selected and destroyed when another one is, so it always
/// starts in the same state. Runs in its process's thread. An exception stops the process. Constructors must
/// be free of side effects: they also run to check whether a solution can be selected.
class Solution {
 public:
  virtual ~Solution() = default;
  /// Called once a frame.
  virtual void execute() = 0;
};

/// The registered properties of a solution, known without running it.
struct SolutionDescription {
  std::string task;
  std::string name;
  /// A sentence for users: what it does and how.
  std::string help;
  /// The origin of the method: papers, books or other programs; "The simulator." for an oracle.
  std::string source;
  // Packages without which it cannot run.
  std::vector<std::string> required;
  // Packages that it uses if they are offered.
  std::vector<std::string> optional;
  // Packages that it may send.
  std::vector<std::string> outputs;
  /// The types of all these packages, as functions because descriptors exist only after main() has started.
  std::map<std::string, const google::protobuf::Descriptor* (*)()> types;
  /// Indices of its debug keys.
  std::vector<int> keys;
  /// The prototype of its parameter message; null if it has none.
  const google::protobuf::Message* parameters = nullptr;
  /// Built-in values and ranges of its parameters.
  ParameterRules parameterRules;
  std::function<std::unique_ptr<Solution>(SolutionContext&)> create;
};

/// Describes a solution for registration, one statement next to its class at namespace scope.
///
///     const SolutionRegistration kRegistration =
///         SolutionBuilder<ScanLineBallPerceptor>("ball-percept", "scan-lines", "Fits a circle to the ball's
///         edge.")
///             .source("A. Author: Circles, 1999.")
///             .needs(kCameraImage).needs(kCameraPose).uses(kOracleWorld).yields(kBallPercept)
///             .keys({&kCircleKey, &kEdgeKey}).parameters<robotcontrol::ScanLineBallParameters>();
template <typename S>
class SolutionBuilder {
 public:
  SolutionBuilder(std::string task, std::string name, std::string help) {
    description_.task = std::move(task);
    description_.name = std::move(name);
    description_.help = std::move(help);
    description_.create = [](SolutionContext& context) -> std::unique_ptr<Solution> {
      return std::make_unique<S>(context);
    };
  }
  /// Names whose method it is.
  SolutionBuilder& source(std::string source) {
    description_.source = std::move(source);
    return *this;
  }
  /// Declares a package without which the solution cannot run.
  template <typename T>
  SolutionBuilder& needs(Package<T> package) {
    description_.required.emplace_back(package.name);
    description_.types[package.name] = &T::descriptor;
    return *this;
  }
  /// Declares a package that the solution reads if it is offered.
  template <typename T>
  SolutionBuilder& uses(Package<T> package) {
    description_.optional.emplace_back(package.name);
    description_.types[package.name] = &T::descriptor;
    return *this;
  }
  /// Declares a package that the solution sends.
  template <typename T>
  SolutionBuilder& yields(Package<T> package) {
    description_.outputs.emplace_back(package.name);
    description_.types[package.name] = &T::descriptor;
    return *this;
  }
  /// Declares the debug keys of the solution; they must be constructed before, in the same file.
  SolutionBuilder& keys(std::initializer_list<const DebugKey*> keys) {
    for (const DebugKey* key : keys) description_.keys.push_back(key->index());
    return *this;
  }
  /// Declares the message type of the solution's parameters, and the rules for them; without rules, what is
  /// not set is 0.
  template <typename P>
  SolutionBuilder& parameters(ParameterRules rules = {}) {
    description_.parameters = &P::default_instance();
    description_.parameterRules = std::move(rules);
    return *this;
  }
  operator SolutionDescription() const { return description_; }  // NOLINT: the builder's purpose

 private:
  SolutionDescription description_;
};

/// All solutions of this program, sorted by task and name. Filled before main() starts, read-only afterward.
class SolutionRegistry {
 public:
  static const std::vector<SolutionDescription>& all();
  /// Null if there is none.
  static const SolutionDescription* find(const std::string& task, const std::string& solution);
};

/// Registers a solution when it is constructed, at namespace scope. A solution that is registered twice, or
/// that names keys of another file (which may not be constructed yet), aborts the program at its start with a
/// message.
class [[maybe_unused]] SolutionRegistration {
 public:
  SolutionRegistration(SolutionDescription description);  // NOLINT: reads like a declaration
  template <typename S>
  SolutionRegistration(const SolutionBuilder<S>& builder)  // NOLINT: the same
      : SolutionRegistration(SolutionDescription(builder)) {}
};

/// The purpose of a task in a sentence for users; all are listed in one file of the program.
struct TaskDescription {
  std::string task;
  std::string help;
};

/// The described tasks, sorted by name. Filled before main() starts, read-only afterward.
const std::vector<TaskDescription>& describedTasks();

/// Registers a description when it is constructed, at namespace scope.
class [[maybe_unused]] TaskRegistration {
 public:
  TaskRegistration(std::string task, std::string help);
};

}  // namespace robotlink
