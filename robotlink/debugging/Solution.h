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
#include "robotlink/packages/Packages.h"
#include "robotlink/process/Link.h"

namespace google::protobuf {
class Descriptor;
}

namespace robotlink {

struct FieldDescription;
struct GroundMap;

/// A package as the tasks of one process see it. Its address stays the same as long as the process lives.
struct PackageSlot {
  PackagePtr value;    ///< null before the first
  bool isNew = false;  ///< it came in this frame
};

/// What a solution reads.
template <typename T>
class Input {
 public:
  explicit Input(const PackageSlot& slot) : slot_(&slot) {}
  /// Null if nobody has sent one yet.
  const T* get() const { return static_cast<const T*>(slot_->value.get()); }
  const T* operator->() const { return get(); }
  const T& operator*() const { return *get(); }
  explicit operator bool() const { return get() != nullptr; }
  /// It came in this frame.
  bool isNew() const { return slot_->isNew; }

 private:
  const PackageSlot* slot_;
};

/// What a solution yields. What it sends is seen by the later tasks of its process at once and by other
/// processes from then on; what it does not send in a frame stays as it was.
template <typename T>
class Output {
 public:
  using Send = std::function<void(PackagePtr)>;
  explicit Output(Send send) : send_(std::move(send)) {}
  void send(std::shared_ptr<const T> package) { send_(PackagePtr(std::move(package))); }

 private:
  Send send_;
};

/// What every solution of a robot's program may know of the robot it runs on. Immutable.
struct RobotSetup {
  std::string name;  ///< "red1"
  std::string team;  ///< "red" or "blue"
  RobotDescription description;
  std::shared_ptr<const FieldDescription> field;
  std::shared_ptr<const GroundMap> map = {};  ///< of the building that it drives in; null: it knows none
};

/// What the constructor of a solution is given: its inputs and outputs, its parameters, its process's debug
/// context.
class SolutionContext {
 public:
  virtual ~SolutionContext() = default;
  virtual const RobotSetup& robot() const = 0;
  virtual const Clock& clock() const = 0;
  virtual DebugContext& debug() = 0;

  /// Only packages that the solution's description names; anything else is a programming error.
  template <typename T>
  Input<T> input(Package<T> package) {
    return Input<T>(inputSlot(package.name));
  }
  template <typename T>
  Output<T> output(Package<T> package) {
    return Output<T>(outputSend(package.name));
  }
  /// The solution's parameters; the reference stays valid and its contents change only between frames.
  template <typename P>
  const P& parameters() {
    return static_cast<const P&>(parameterMessage());
  }

 protected:
  virtual const PackageSlot& inputSlot(const char* package) = 0;
  virtual std::function<void(PackagePtr)> outputSend(const char* package) = 0;
  virtual const google::protobuf::Message& parameterMessage() = 0;
};

/// One way to do a task. Constructed when it is switched on, destroyed when it is switched off, so that it
/// always starts from the same state. Runs in its process's thread. What it throws stops its process.
class Solution {
 public:
  virtual ~Solution() = default;
  virtual void execute() = 0;
};

/// What is known of a solution without running it.
struct SolutionDescription {
  std::string task;
  std::string name;
  std::string help;  ///< a sentence: what it does and how
  std::vector<std::string> required;
  std::vector<std::string> optional;
  std::vector<std::string> outputs;
  /// The types of all these packages, as functions: descriptors exist only after main() has started.
  std::map<std::string, const google::protobuf::Descriptor* (*)()> types;
  std::vector<int> keys;                                  ///< indices of its debug keys
  const google::protobuf::Message* parameters = nullptr;  ///< prototype; null if it has none
  std::function<std::unique_ptr<Solution>(SolutionContext&)> create;
};

/// Registers a solution: one line beside its class, at namespace scope.
///
///     const SolutionRegistration kRegistration =
///         SolutionBuilder<ScanLineBallPerceptor>("ball-percept", "scan-lines", "Fits a circle to the ball's
///         edge.")
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
  template <typename T>
  SolutionBuilder& needs(Package<T> package) {
    description_.required.emplace_back(package.name);
    description_.types[package.name] = &T::descriptor;
    return *this;
  }
  template <typename T>
  SolutionBuilder& uses(Package<T> package) {
    description_.optional.emplace_back(package.name);
    description_.types[package.name] = &T::descriptor;
    return *this;
  }
  template <typename T>
  SolutionBuilder& yields(Package<T> package) {
    description_.outputs.emplace_back(package.name);
    description_.types[package.name] = &T::descriptor;
    return *this;
  }
  SolutionBuilder& keys(std::initializer_list<const DebugKey*> keys) {
    for (const DebugKey* key : keys) description_.keys.push_back(key->index());
    return *this;
  }
  template <typename P>
  SolutionBuilder& parameters() {
    description_.parameters = &P::default_instance();
    return *this;
  }
  operator SolutionDescription() const { return description_; }  // NOLINT: the builder's purpose

 private:
  SolutionDescription description_;
};

/// All solutions of this program. Filled before main() starts, read-only after.
class SolutionRegistry {
 public:
  static const std::vector<SolutionDescription>& all();
  static const SolutionDescription* find(const std::string& task, const std::string& solution);
};

/// Registers a solution when it is constructed, at namespace scope. One that is registered twice, or that
/// names keys of another file, which may not be constructed yet, ends the program at its start with a text
/// that says so.
class SolutionRegistration {
 public:
  SolutionRegistration(SolutionDescription description);  // NOLINT: reads like a declaration
  template <typename S>
  SolutionRegistration(const SolutionBuilder<S>& builder)  // NOLINT: the same
      : SolutionRegistration(SolutionDescription(builder)) {}
};

/// What a task is for, in a sentence; one line in the file that lists the program's tasks.
struct TaskDescription {
  std::string task;
  std::string help;
};

/// The tasks that were described, by name. Filled before main() starts, read-only after.
const std::vector<TaskDescription>& describedTasks();

class TaskRegistration {
 public:
  TaskRegistration(std::string task, std::string help);
};

}  // namespace robotlink
