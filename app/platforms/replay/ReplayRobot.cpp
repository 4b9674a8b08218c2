// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/replay/ReplayRobot.h"

#include <algorithm>

#include "app/core/program/ColorTables.h"
#include "app/core/program/ProgramSetups.h"
#include "foxglove/Image.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotlink/debugging/RegisteredTasks.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/debugging/program/RobotProgram.h"
#include "robotlink/packages/MapConversions.h"

namespace app {

namespace streams = robotlink::streams;

using robotcontrol::ControlReplay;
using robotcontrol::ProgramSetup;
using robotcontrol::Request;
using robotlink::Errors;
using robotlink::Instant;
using robotlink::StreamMessage;

namespace {

/// The longest time for which published packages wait in the queue of a process.
constexpr robotlink::Duration kQueueDelay = std::chrono::milliseconds(100);

/// Whether the messages of a stream can be used as packages of `type`. Compressed images can, since they are
/// decoded.
bool fits(const google::protobuf::Descriptor& type, const std::string& streamType) {
  const bool isImage = &type == foxglove::RawImage::descriptor();
  return streamType == type.full_name() ||
         (isImage && streamType == foxglove::CompressedImage::descriptor()->full_name());
}

}  // namespace

ReplayRobot::ReplayRobot(std::shared_ptr<logplayer::LogFile> log, std::string logName, std::string name,
                         ReplayChoices choices, ProgramOverrides overrides, RobotHost::Listeners listeners)
    : log_(std::move(log)),
      logName_(std::move(logName)),
      types_(robotlink::packageTypes()),
      host_({.name = std::move(name)}, inTurns(comparing(std::move(listeners))), nullptr,
            std::move(overrides)) {
  started_.choices = std::move(choices);
  for (const auto& stream : log_->streams()) {
    if (!stream.path.starts_with(logName_ + "/")) continue;
    const std::string path = below(stream.path);
    streams_.insert(path);
    const auto type = types_.find(path);
    if (type == types_.end() || !stream.isDecoded() || !fits(*type->second, stream.type) ||
        robotlink::isDebugPackage(path))
      continue;
    logged_.insert(path);
    // Packages that were still in queues when the recording ended are not in the log, and not missed there.
    const bool untilTheEnd = log_->end() - stream.last < kQueueDelay;
    comparedUntil_[path] = untilTheEnd ? stream.last : Instant::max();
  }
}

ReplayRobot::~ReplayRobot() {
  end();
}

void ReplayRobot::end() {
  leftOver_.end(std::move(executor_), {&host_}, LeftOverPrograms::Platforms::kReplaced);
  events_.beginProgram();
}

RobotHost::Listeners ReplayRobot::inTurns(RobotHost::Listeners listeners) {
  const auto pass = [this](auto listener) {
    return [this, listener = std::move(listener)](const auto&... values) {
      events_.add([listener, values...] { listener(values...); });
    };
  };
  if (listeners.queue) listeners.queue = pass(std::move(listeners.queue));
  if (listeners.overridden) listeners.overridden = pass(std::move(listeners.overridden));
  // A robot for which nothing is computed has no program that anybody could be interested in.
  if (listeners.hosting) {
    listeners.hosting = [this, listener = std::move(listeners.hosting)](const std::string& robot,
                                                                        Instant time, const auto& status) {
      if (computes()) listener(robot, time, status);
    };
  }
  if (!listeners.trouble) return listeners;
  listeners.trouble = [this, listener = std::move(listeners.trouble)](const std::string& robot,
                                                                      const robotlink::Process& process,
                                                                      const std::string& text) {
    events_.add([listener, robot, &process, text] { listener(robot, process, text); });
  };
  return listeners;
}

RobotHost::Listeners ReplayRobot::comparing(RobotHost::Listeners listeners) {
  listeners.overridden = [this](const Request& request) {
    // Results of another program are not compared any more.
    if (robotlink::kindOf(request).effect == robotlink::RequestEffect::kBehavior) differences_.clear();
  };
  return listeners;
}

// ---- Making the program

std::optional<ProgramSetup> ReplayRobot::loggedSetupAt(Instant time) const {
  const std::string stream = logName_ + "/" + streams::kProgram;
  auto message = log_->latest(stream, time);
  // Some recorders write it with the first frame only.
  if (!message) {
    if (const auto first = log_->timeAfter(stream, time)) message = log_->latest(stream, *first);
  }
  const auto* setup = message ? dynamic_cast<const ProgramSetup*>(message->value.get()) : nullptr;
  return setup != nullptr ? std::optional(*setup) : std::nullopt;
}

std::shared_ptr<const robotlink::GroundMap> ReplayRobot::loggedMapAt(Instant time) const {
  auto message = log_->latest(streams::kMap, time);
  if (!message) {
    if (const auto first = log_->timeAfter(streams::kMap, time))
      message = log_->latest(streams::kMap, *first);
  }
  const auto* map = message ? dynamic_cast<const robotcontrol::GroundMap*>(message->value.get()) : nullptr;
  return map != nullptr ? std::make_shared<const robotlink::GroundMap>(robotlink::groundMap(*map)) : nullptr;
}

Errors ReplayRobot::readSetup(Start& start) const {
  start.logged = loggedSetupAt(start.time);
  auto setup = readReplaySetup(start.logged ? &*start.logged : nullptr, logName_, start.choices.layout);
  if (!setup) return setup.error();
  const ProgramOverrides chosen = host_.overrides();
  const std::map<std::string, std::string> solutions = chosen.solutions();
  std::map<std::string, std::string> active;
  for (auto& process : setup->layout.processes) {
    for (auto& task : process.tasks) {
      if (const auto solution = solutions.find(task.task); solution != solutions.end())
        task.choose(solution->second);
      active[task.task] = task.solution;
    }
  }
  for (auto& values : chosen.parameters()) {
    if (values.solution().empty()) values.set_solution(active[values.task()]);
    setup->parameters.push_back(std::move(values));
  }
  setup->robot.name = name();
  setup->robot.map = loggedMapAt(start.time);
  start.setup = std::move(*setup);
  return {};
}

tl::expected<ReplayRobot::Start, Errors> ReplayRobot::prepare(Instant time, ReplayChoices choices) {
  // Open requests are decided now, so that the next program is made with them.
  if (host_.program() != nullptr) (void)host_.answersToCome();
  Start start;
  start.time = time;
  start.choices = std::move(choices);
  const Instant now = clock_.now();
  clock_.set(time);
  Errors errors = readSetup(start);
  if (errors.empty()) errors = makeProgram(start);
  clock_.set(now);
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return start;
}

void ReplayRobot::begin(Start start) {
  adopt(std::move(start));
  giveWhatIsBefore();
}

void ReplayRobot::adopt(Start start) {
  leftOver_.forgetEnded();
  leftOver_.end(std::move(executor_), {&host_}, LeftOverPrograms::Platforms::kReplaced);
  events_.beginProgram();
  clock_.set(start.time);
  host_.adopt(std::move(start.program));
  started_ = std::move(start);
  makeExecutor();
  paths_ = LoggedPaths(plan());
  due_.clear();
  differences_.dropInstant();
  compare();
  (void)host_.begin(*executor_);
}

void ReplayRobot::makeExecutor() {
  executor_ = std::make_unique<ProgramExecutor>(ProgramExecutor::Options{
      .trouble = [this](const auto& process, const auto& text) { host_.reportTrouble(process, text); },
      .patience = computes() ? choices().hosting.patience : std::chrono::milliseconds(0),
      .stuck = [this](const auto&, const std::string& what) { host_.noteStuck(what); }});
}

HostedProgram::Maker ReplayRobot::makerOf(const Start& start) {
  const ReplayHosting& hosting = start.choices.hosting;
  const auto& processes = start.plan.layout.processes;
  const bool computes =
      std::ranges::any_of(processes, [](const auto& process) { return !process.tasks.empty(); });
  if (!hosting.ownProcess || !computes) {
    spare_.reset();
    return nullptr;
  }
  if (!spare_) spare_ = std::make_shared<SpareChild>();
  OwnProgram::Options own = hosting.own;
  own.spare = spare_;
  own.texts = std::make_shared<const ProgramSetup>(start.setup.files);
  for (const auto& process : start.setup.layout.processes) own.order.push_back(process.name);
  for (const auto& package : platformPackages(start.plan)) {
    if (!package.process.empty()) own.turns[package.name] = package.process;
  }
  return OwnProgram::maker(std::move(own));
}

Errors ReplayRobot::makeProgram(Start& start) {
  Errors errors = makeAvailable(start);
  const bool nothingChosen = start.choices.packages.empty() && !start.choices.recomputeAll;
  if (errors.empty() || !start.setup.layoutFromLog || !nothingChosen) return errors;
  // A log can be played even if its layout can no longer run.
  start.setup.layout = emptyLayout(start.setup.layout);
  start.setup.notes.push_back("nothing is recomputed, because the log's layout cannot be run: " +
                              robotlink::describe(errors));
  return makeAvailable(start);
}

std::vector<std::string> ReplayRobot::lostChoices() const {
  std::vector<std::string> lost;
  for (const auto& [task, solution] : host_.overrides().solutions()) {
    const auto uses = [&wanted = task, &choice = solution](const auto& process) {
      return std::ranges::any_of(
          process.tasks, [&](const auto& own) { return own.task == wanted && own.solution == choice; });
    };
    const auto& processes = setup().layout.processes;
    if (std::ranges::any_of(processes, uses)) continue;
    lost.push_back(name() + " could not keep solution " + solution + " of task " + task +
                   ": no process of this layout has " + task);
  }
  return lost;
}

Errors ReplayRobot::makeAvailable(Start& start) {
  const robotlink::TaskCatalog catalog = robotlink::registeredTasks();
  ReplaySelection selection{.layout = start.setup.layout,
                            .logged = logged_,
                            .debugOffers = robotlink::debugPackages(),
                            .broken = {},
                            .fromLog = start.setup.layoutFromLog,
                            .packages = start.choices.packages,
                            .recomputeAll = start.choices.recomputeAll};
  for (;;) {
    auto plan = planReplay(selection, catalog);
    if (!plan) return plan.error();
    start.plan = std::move(*plan);
    Errors errors = makeProgramOfPlan(start);
    const std::size_t before = selection.broken.size();
    for (const robotlink::Error& error : errors) {
      if (error.id != "solution.broken" || error.arguments.size() != 3) continue;
      selection.broken.emplace(std::pair(error.arguments[0], error.arguments[1]), error.arguments[2]);
    }
    if (selection.broken.size() == before) return errors;
  }
}

std::vector<logplayer::LogPlatform::Package> ReplayRobot::platformPackages(const ReplayPlan& plan) const {
  std::vector<logplayer::LogPlatform::Package> packages;
  for (const auto& package : plan.packages) {
    if (package.source != ControlReplay::AS_LOGGED) continue;
    packages.push_back({package.name, package.process, types_.at(package.name)});
  }
  return packages;
}

Errors ReplayRobot::makeProgramOfPlan(Start& start) {
  auto platform = std::make_unique<logplayer::LogPlatform>(clock_, platformPackages(start.plan));
  start.platform = platform.get();
  auto made = host_.make({.platform = std::move(platform),
                          .file = {},
                          .layout = start.plan.layout,
                          .robot = start.setup.robot,
                          .parameters = start.setup.parameters,
                          .overridden = true,
                          .maker = makerOf(start)});
  if (!made) return made.error();
  HostedProgram& program = *made->program;
  if (start.choices.publishAllPackages) {
    const auto yielded = program.yieldedPackages(), chosen = host_.overrides().recordedPackages();
    std::set<std::string> all(yielded.begin(), yielded.end());
    all.insert(chosen.begin(), chosen.end());
    program.recordPackages(all);
  }
  // The stand-in for a remote program runs after all turns, which it gets together.
  const bool isElsewhere = program.inside() == nullptr;
  made->processes.clear();
  for (const auto& process : start.setup.layout.processes) {
    if (robotlink::Process* turn = start.platform->turnOf(process.name)) made->processes.push_back(turn);
    for (robotlink::Process* running : program.processes()) {
      if (!isElsewhere && running->name() == process.name) made->processes.push_back(running);
    }
  }
  if (isElsewhere) made->processes.push_back(program.processes().front());
  start.program = std::move(*made);
  return {};
}

std::shared_ptr<const ProgramSetup> ReplayRobot::ownSetup() const {
  auto own = std::make_shared<ProgramSetup>(programSetup(host_.robot(), *host_.program(), *host_.platform(),
                                                         {{}, {}, {}, nameOf(executor_->kind())}));
  *own->mutable_layout() = setup().files.layout();
  *own->mutable_description() = setup().files.description();
  *own->mutable_field() = setup().files.field();
  return own;
}

void ReplayRobot::compare() {
  std::set<std::string> packages;
  for (const auto& package : plan().packages) {
    if (package.logged) packages.insert(package.name);
  }
  const auto compareOne = [this](const std::string& name, const robotlink::PackagePtr& value) {
    const bool counts = countsDifferences_ && clock_.now() <= comparedUntil_.at(name);
    if (counts) differences_.addRecomputed(name, value);
  };
  host_.program()->tap(
      packages, [this, compareOne, program = events_.program()](const std::string& name, const auto& value) {
        events_.add(program, [compareOne, name, value] { compareOne(name, value); });
      });
}

// Packages that are not published in every frame must be there from the start. Those that processes wait for
// are left out: they have triggered their frames already.
void ReplayRobot::giveWhatIsBefore() {
  if (!computes()) return;
  std::set<std::string> awaited;
  for (const auto& process : plan().layout.processes) {
    for (const auto& input : process.blocking) awaited.insert(input.package);
  }
  const auto before = [&](const std::string& package, Instant last) {
    return log_->latest(logName_ + "/" + package, last);
  };
  const Instant time = started_.time, earlier = time - robotlink::Duration(1);
  for (const auto& package : plan().packages) {
    if (package.source != ControlReplay::AS_LOGGED || awaited.contains(package.name)) continue;
    if (const auto message = before(package.name, earlier))
      started_.platform->put(package.name, message->value);
  }
  HostedProgram& program = *host_.program();
  // Requests at `time` itself are taken from the log at that instant, if it contains requests.
  for (const std::string& package : robotlink::debugPackages()) {
    const auto message = before(package, hasRequests() ? earlier : time);
    if (!message) continue;
    const auto* table = dynamic_cast<const robotcontrol::ColorTable*>(message->value.get());
    const bool own = table != nullptr && !table->cells().empty();
    program.offer(own ? std::make_shared<const robotcontrol::ColorTable>(colorTableOfLog(*table))
                      : message->value);
  }
  if (const auto table = host_.overrides().colorTable()) program.offer(table);
  if (const auto motions = host_.overrides().motions()) program.offer(motions);
}

}  // namespace app
