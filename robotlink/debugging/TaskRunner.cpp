// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/TaskRunner.h"

#include <google/protobuf/message.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/Spelling.h"
#include "robotlink/base/TextParts.h"
#include "robotlink/debugging/DebugRoutes.h"

namespace robotlink {
namespace {

/// Follows the name of a solution whose time as a shadow is measured.
constexpr char kInShadow[] = " (shadow)";

/// Adds how long something took, in real time, when it is over.
class Measured {
 public:
  Measured(robotcontrol::StopwatchTimes* times, const std::string& task, std::string solution)
      : times_(times), task_(task), solution_(std::move(solution)) {
    if (times_ != nullptr) begin_ = std::chrono::steady_clock::now();
  }
  ~Measured() {
    if (times_ == nullptr) return;
    auto& entry = *times_->add_entries();
    entry.set_task(task_);
    entry.set_solution(solution_);
    entry.set_seconds(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count());
  }
  Measured(const Measured&) = delete;
  Measured& operator=(const Measured&) = delete;

 private:
  robotcontrol::StopwatchTimes* times_;
  const std::string& task_;
  const std::string solution_;
  std::chrono::steady_clock::time_point begin_;
};

[[noreturn]] void undeclared(const SolutionDescription& solution, const std::string& what) {
  throw std::logic_error(solution.task + " (" + solution.name + ") uses " + what +
                         ", which its registration does not name");
}

}  // namespace

/// The context that is passed to a solution's constructor. A solution that is only tried, or that runs in the
/// shadow of another, gets a debug context of its own; the former sends nothing, the latter publishes in
/// place of sending.
class TaskRunner::Context final : public SolutionContext {
 public:
  enum class Use { kRun, kTrial, kShadow };
  Context(const TaskRunner& runner, const TaskInputs& inputs, const SolutionDescription& solution,
          DebugContext& debug, Use use)
      : runner_(runner), inputs_(inputs), solution_(solution), debug_(debug), use_(use) {}

  const RobotSetup& robot() const override { return runner_.environment_.robot; }
  const Clock& clock() const override { return runner_.environment_.clock; }
  DebugContext& debug() override { return debug_; }

 protected:
  const PackageSlot& inputSlot(const char* package) override {
    if (!contains(solution_.required, package) && !contains(solution_.optional, package)) {
      undeclared(solution_, std::string("the input ") + package);
    }
    return inputs_.at(package).slot;
  }
  std::function<void(PackagePtr)> outputSend(const char* package) override {
    if (!contains(solution_.outputs, package)) undeclared(solution_, std::string("the output ") + package);
    if (use_ == Use::kShadow)
      return
          [this, name = std::string(package)](PackagePtr value) { debug_.package(name, std::move(value)); };
    if (use_ == Use::kTrial || runner_.environment_.withheld.contains(package))
      return [](const PackagePtr&) {};
    PackageBoard& board = runner_.environment_.board;
    PackageBoard::Entry& entry = board.entry(package);
    return [&board, &entry](PackagePtr value) { board.send(entry, std::move(value)); };
  }
  const google::protobuf::Message& parameterMessage() override {
    const auto* message = runner_.parameters_.at(solution_.name).message();
    if (message == nullptr) undeclared(solution_, "parameters");
    return *message;
  }

 private:
  const TaskRunner& runner_;
  const TaskInputs& inputs_;
  const SolutionDescription& solution_;
  DebugContext& debug_;
  const Use use_;
};

struct TaskRunner::Shadow {
  Shadow(const TaskRunner& runner, const SolutionDescription& described)
      : description(described),
        debug("", runner.environment_.clock, {}),
        inputs(runner.unseenInputs()),
        context(runner, inputs, described, debug, Context::Use::kShadow) {}

  const SolutionDescription& description;
  ModeCounter mode;
  DebugContext debug;
  TaskInputs inputs;
  Context context;
  std::unique_ptr<Solution> solution;
};

class TaskRunner::Busy {
 public:
  Busy(const TaskRunner& runner, const std::string& solution) : slot_(runner.environment_.activity) {
    if (slot_ != nullptr)
      before_ = slot_->exchange(&runner.activities_.at(solution), std::memory_order_relaxed);
  }
  ~Busy() {
    if (slot_ != nullptr) slot_->store(before_, std::memory_order_relaxed);
  }
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;

 private:
  std::atomic<const std::string*>* slot_;
  const std::string* before_ = nullptr;
};

TaskRunner::TaskRunner(std::string task, const Environment& environment)
    : task_(std::move(task)), environment_(environment) {
  for (const SolutionDescription& solution : SolutionRegistry::all()) {
    if (solution.task != task_) continue;
    solutions_.push_back(&solution);
    activities_[solution.name] = task_ + " (" + solution.name + ")";
  }
  inputs_ = unseenInputs();
}

TaskRunner::~TaskRunner() = default;

TaskRunner::TaskInputs TaskRunner::unseenInputs() const {
  TaskInputs inputs;
  for (const SolutionDescription* solution : solutions_) {
    for (const auto* packages : {&solution->required, &solution->optional}) {
      for (const std::string& package : *packages) inputs[package].entry = &environment_.board.entry(package);
    }
  }
  return inputs;
}

SolutionParameters* TaskRunner::parameters(const std::string& solution) {
  const auto found = parameters_.find(solution);
  return found == parameters_.end() ? nullptr : &found->second;
}

const SolutionParameters* TaskRunner::parameters(const std::string& solution) const {
  const auto found = parameters_.find(solution);
  return found == parameters_.end() ? nullptr : &found->second;
}

Errors TaskRunner::loadParameters(const ParameterSource& source) {
  Errors errors = filesOfNoSolution(source.folder);
  for (const SolutionDescription* solution : solutions_) {
    auto loaded = SolutionParameters::load(*solution, source.folder, environment_.robot);
    if (loaded) {
      parameters_.emplace(solution->name, std::move(*loaded));
    } else {
      errors.insert(errors.end(), loaded.error().begin(), loaded.error().end());
    }
  }
  takeRecorded(source);
  return errors;
}

/// Recorded values of solutions or types that no longer exist are ignored.
void TaskRunner::takeRecorded(const ParameterSource& source) {
  for (const robotcontrol::ParameterValues& values : source.recorded) {
    SolutionParameters* known = values.task() == task_ ? parameters(values.solution()) : nullptr;
    if (known != nullptr) (void)known->restore(values.value());
  }
}

/// Without this check, a file with a misspelled name would be ignored silently.
Errors TaskRunner::filesOfNoSolution(const std::filesystem::path& folder) const {
  std::vector<std::string> known;
  for (const SolutionDescription* solution : solutions_) known.push_back(solution->name);
  Errors errors;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string file = entry.path().filename().string();
    if (!file.starts_with(task_ + ".") || entry.path().extension() != ".textproto") continue;
    const std::string name = entry.path().stem().string().substr(task_.size() + 1);
    if (contains(known, name)) continue;
    errors.push_back({"parameters.unknown-solution",
                      "task " + task_ + " has no solution '" + name + "'" + suggestion(name, known),
                      {task_, name},
                      {entry.path().string(), 0, 0}});
  }
  std::sort(errors.begin(), errors.end(),
            [](const Error& a, const Error& b) { return a.where.file < b.where.file; });
  return errors;
}

Result<const SolutionDescription*> TaskRunner::known(const std::string& solution) const {
  const SolutionDescription* description = SolutionRegistry::find(task_, solution);
  if (description != nullptr) return description;
  return failure("solution.unknown", "task " + task_ + " has no solution '" + solution + "'", {},
                 {task_, solution});
}

Result<std::unique_ptr<Solution>> TaskRunner::make(const SolutionDescription& solution,
                                                   Context& context) const {
  const auto broken = [&](const std::string& why) {
    return failure("solution.broken",
                   "solution " + solution.name + " of task " + task_ + " could not be made: " + why, {},
                   {task_, solution.name, why});
  };
  const Busy busy(*this, solution.name);
  try {
    std::unique_ptr<Solution> made = solution.create(context);
    if (!made) return broken("nothing was made");
    return made;
  } catch (const std::exception& exception) {
    return broken(exception.what());
  } catch (...) {
    return broken("an exception of unknown type");
  }
}

Result<void> TaskRunner::select(const std::string& solution) {
  const auto description = known(solution);
  if (!description) return tl::unexpected(description.error());
  auto context =
      std::make_unique<Context>(*this, inputs_, **description, environment_.debug, Context::Use::kRun);
  auto made = make(**description, *context);
  if (!made) return tl::unexpected(made.error());
  solution_ = std::move(*made);
  context_ = std::move(context);
  active_ = solution;
  return {};
}

Result<void> TaskRunner::trySolution(const std::string& solution) const {
  const auto description = known(solution);
  if (!description) return tl::unexpected(description.error());
  DebugContext unheard("", environment_.clock, {});
  unheard.setRobot(environment_.robot.name);
  Context context(*this, inputs_, **description, unheard, Context::Use::kTrial);
  if (const auto made = make(**description, context); !made) return tl::unexpected(made.error());
  return {};
}

void TaskRunner::refresh(TaskInputs& inputs) {
  for (auto& [package, input] : inputs) {
    input.slot.isNew = input.entry->arrivals != input.seen;
    if (input.slot.isNew) input.slot.value = input.entry->value;
    input.seen = input.entry->arrivals;
  }
}

/// All solutions see the inputs as they are before one of them has sent anything.
void TaskRunner::execute(robotcontrol::StopwatchTimes* times) {
  refresh(inputs_);
  std::vector<Shadow*> due;
  for (auto& [solution, shadow] : shadows_) {
    if (solution == active_ || !shadow->mode.due(environment_.debug.frameTime())) continue;
    refresh(shadow->inputs);
    due.push_back(shadow.get());
  }
  {
    const Measured measured(times, task_, active_);
    executeActive();
  }
  for (Shadow* shadow : due) {
    const Measured measured(times, task_, shadow->description.name + kInShadow);
    executeShadow(*shadow);
  }
  const std::size_t before = shadows_.size();
  std::erase_if(shadows_, [](const auto& entry) {
    return entry.second->mode.mode().kind() == robotcontrol::KeyMode::OFF;
  });
  shadowEnded_ |= shadows_.size() != before;
}

void TaskRunner::executeActive() {
  const Busy busy(*this, active_);
  try {
    solution_->execute();
  } catch (const std::exception& exception) {
    throw std::runtime_error(task_ + " (" + active_ + "): " + exception.what());
  }
}

// ---- Shadow mode

void TaskRunner::executeShadow(Shadow& shadow) {
  const std::string& name = shadow.description.name;
  const Busy busy(*this, name);
  const auto end = [&](const std::string& why) {
    shadow.debug.text(Level::kError, task_, "it was switched off as a shadow of " + active_ + ": " + why);
    shadow.mode.set({});
  };
  shadow.debug.beginFrame(environment_.debug.frameTime(), 0);
  try {
    shadow.solution->execute();
  } catch (const std::exception& exception) {
    end(exception.what());
  } catch (...) {
    end("an exception of unknown type");
  }
  environment_.debug.take(shadow.debug, shadowPrefix(name), name);
}

Result<void> TaskRunner::setShadow(const std::string& solution, const robotcontrol::KeyMode& mode) {
  const auto description = known(solution);
  if (!description) return tl::unexpected(description.error());
  ModeCounter counter;
  counter.set(mode);
  if (counter.mode().kind() == robotcontrol::KeyMode::OFF) {
    shadows_.erase(solution);
    return {};
  }
  std::unique_ptr<Shadow>& shadow = shadows_[solution];
  if (!shadow) {
    auto made = std::make_unique<Shadow>(*this, **description);
    made->debug.setRobot(environment_.robot.name);
    auto constructed = make(**description, made->context);
    if (!constructed) {
      shadows_.erase(solution);
      return tl::unexpected(constructed.error());
    }
    made->solution = std::move(*constructed);
    for (const int key : (*description)->keys) made->debug.setMode(key, environment_.debug.mode(key));
    shadow = std::move(made);
  }
  shadow->mode = counter;
  return {};
}

robotcontrol::KeyMode TaskRunner::shadowMode(const std::string& solution) const {
  const auto found = shadows_.find(solution);
  return found == shadows_.end() ? robotcontrol::KeyMode() : found->second->mode.mode();
}

void TaskRunner::setKey(int key, const robotcontrol::KeyMode& mode) {
  for (auto& [solution, shadow] : shadows_) shadow->debug.setMode(key, mode);
}

}  // namespace robotlink
