// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/replay/ReplayRobot.h"

#include <algorithm>

#include "app/core/program/ColorTables.h"
#include "app/core/program/ProgramSetups.h"
#include "app/core/replay/ReplayRobotProgram.h"
#include "foxglove/Image.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotlink/debugging/RegisteredTasks.h"
#include "robotlink/debugging/Streams.h"
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
                         ReplayChoices choices, ProgramOverrides overrides, Listeners listeners)
    : log_(std::move(log)),
      logName_(std::move(logName)),
      name_(std::move(name)),
      listeners_(std::move(listeners)),
      types_(robotlink::packageTypes()),
      choices_(std::move(choices)),
      requests_(name_, std::move(overrides), [this](const Request& request) {
        // What another program recomputed is not compared any more.
        if (!request.has_set_key() && !request.has_record_packages()) differences_.clear();
      }) {
  for (const auto& stream : log_->streams()) {
    if (!stream.path.starts_with(logName_ + "/")) continue;
    const std::string path = below(stream.path);
    streams_.insert(path);
    const auto type = types_.find(path);
    if (type == types_.end() || !stream.isDecoded() || !fits(*type->second, stream.type) ||
        robotlink::isDebugPackage(path))
      continue;
    logged_.insert(path);
    // What was still in the queues when the recording ended is not in the log; it is not missed there.
    const bool untilTheEnd = log_->end() - stream.last < kQueueDelay;
    comparedUntil_[path] = untilTheEnd ? stream.last : Instant::max();
  }
}

ReplayRobot::~ReplayRobot() = default;

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

Errors ReplayRobot::readSetupAt(Instant time) {
  auto logged = loggedSetupAt(time);
  auto setup = readReplaySetup(logged ? &*logged : nullptr, logName_, choices_.layout);
  if (!setup) return setup.error();
  const ProgramOverrides chosen = overrides();
  for (auto& process : setup->layout.processes) {
    for (auto& task : process.tasks) {
      const auto solution = chosen.solutions().find(task.task);
      if (solution != chosen.solutions().end()) task.choose(solution->second);
    }
  }
  for (const auto& [solution, values] : chosen.parameters()) setup->parameters.recorded.push_back(values);
  if (setup->team.empty()) setup->team = setup->use.teamOf(logName_);
  setup->map = loggedMapAt(time);
  setup_ = std::make_shared<const ReplaySetup>(std::move(*setup));
  loggedSetup_ = std::move(logged);
  return {};
}

Errors ReplayRobot::start(Instant time) {
  return start(time, choices_);
}

Errors ReplayRobot::start(Instant time, ReplayChoices choices) {
  Errors errors = startWith(time, std::move(choices));
  if (errors.empty()) giveWhatIsBefore(time);
  return errors;
}

Errors ReplayRobot::startWith(Instant time, ReplayChoices choices) {
  // What was asked is decided, so that the next program is made with it.
  if (program_) (void)answersToCome();
  const auto before =
      std::tuple(std::exchange(choices_, std::move(choices)), loggedSetup_, setup_, clock_.now());
  clock_.set(time);
  Errors errors = readSetupAt(time);
  if (errors.empty()) {
    errors = makeProgram();
    const bool nothingChosen = choices_.packages.empty() && !choices_.recomputeAll;
    if (!errors.empty() && setup_->layoutFromLog && nothingChosen) errors = playOnly(errors);
  }
  if (!errors.empty()) {
    Instant then;
    std::tie(choices_, loggedSetup_, setup_, then) = before;
    clock_.set(then);
  }
  return errors;
}

// A log can be played even if its layout cannot run any more.
Errors ReplayRobot::playOnly(const Errors& why) {
  ReplaySetup setup = *setup_;
  setup.layout = emptyLayout(setup.layout);
  setup.notes.push_back("nothing is recomputed, as the log's layout cannot be run: " +
                        robotlink::describe(why));
  setup_ = std::make_shared<const ReplaySetup>(std::move(setup));
  return makeProgram();
}

std::vector<std::string> ReplayRobot::lostChoices() const {
  std::vector<std::string> lost;
  const ProgramOverrides chosen = overrides();
  for (const auto& [task, solution] : chosen.solutions()) {
    const auto uses = [&wanted = task, &choice = solution](const auto& process) {
      return std::any_of(process.tasks.begin(), process.tasks.end(),
                         [&](const auto& own) { return own.task == wanted && own.solution == choice; });
    };
    const auto& processes = setup_->layout.processes;
    if (std::any_of(processes.begin(), processes.end(), uses)) continue;
    lost.push_back(name_ + " could not keep solution " + solution + " of task " + task +
                   ": no process of this layout has " + task);
  }
  return lost;
}

ReplaySelection ReplayRobot::selection() const {
  ReplaySelection selection;
  selection.layout = setup_->layout;
  selection.fromLog = setup_->layoutFromLog;
  selection.logged = logged_;
  selection.debugOffers = robotlink::debugPackages();
  selection.packages = choices_.packages;
  selection.recomputeAll = choices_.recomputeAll;
  return selection;
}

Errors ReplayRobot::makeProgram() {
  const robotlink::TaskCatalog catalog = robotlink::registeredTasks();
  for (ReplaySelection requested = selection();;) {
    auto plan = planReplay(requested, catalog);
    if (!plan) return plan.error();
    auto program = programFor(*plan);
    if (program) {
      plan_ = std::move(*plan);
      paths_ = LoggedPaths(plan_);
      program_ = std::move(*program);
      describeProgram(*program_);
      due_.clear();
      differences_.dropInstant();
      requests_.beginOverridden();
      handRequests();
      return {};
    }
    const std::size_t before = requested.broken.size();
    for (const robotlink::Error& error : program.error()) {
      if (error.id != "solution.broken" || error.arguments.size() != 3) continue;
      requested.broken.emplace(std::pair(error.arguments[0], error.arguments[1]), error.arguments[2]);
    }
    if (requested.broken.size() == before) return program.error();
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

tl::expected<std::unique_ptr<ReplayRobot::Program>, Errors> ReplayRobot::programFor(const ReplayPlan& plan) {
  robotlink::LockstepExecutor::Options options;
  options.onStarved = [this](const auto& process, const auto& what) {
    listeners_.trouble(process, "waits for " + what);
  };
  options.onFailed = [this](const auto& process) {
    listeners_.trouble(process, "was stopped because it threw: " + process.failure());
  };
  auto made = std::make_unique<Program>(clock_, platformPackages(plan), std::move(options));
  const robotlink::RobotSetup robot{name_, setup_->team, *setup_->description, setup_->field, setup_->map};
  auto program = robotlink::RobotProgram::create(robot, plan.layout, made->platform, setup_->parameters);
  if (!program) return tl::unexpected(program.error());
  made->program = std::move(*program);
  const ProgramOverrides chosen = overrides();
  made->program->setKeys(chosen.keys());
  const auto& requested = chosen.recordedPackages();
  std::set<std::string> recorded(requested.begin(), requested.end());
  if (choices_.publishAllPackages) {
    const auto yielded = made->program->yieldedPackages();
    recorded.insert(yielded.begin(), yielded.end());
  }
  made->program->recordPackages(recorded);
  made->executor.add(made->platform);
  for (const auto& process : setup_->layout.processes) {
    if (robotlink::Process* turn = made->platform.turnOf(process.name)) made->executor.add(*turn);
    for (robotlink::Process* running : made->program->processes()) {
      if (running->name() == process.name) made->executor.add(*running);
    }
  }
  listen(*made, plan);
  return made;
}

void ReplayRobot::describeProgram(const Program& program) {
  auto own = std::make_shared<ProgramSetup>(
      programSetup(*program.program, program.platform, {{}, {}, {}, "lockstep"}));
  own->set_robot(name_);
  *own->mutable_layout() = setup_->files.layout();
  *own->mutable_description() = setup_->files.description();
  *own->mutable_field() = setup_->files.field();
  ownSetup_ = std::move(own);
}

void ReplayRobot::listen(Program& program, const ReplayPlan& plan) {
  program.program->debugProcess().setListener([this](const auto& queue) {
    requests_.answered(*queue);
    listeners_.queue(queue);
  });
  for (const robotlink::Process* process : program.program->processes()) {
    for (robotlink::AnySender* sender : process->senders()) {
      const auto* package = plan.find(sender->package());
      if (package == nullptr || !package->logged) continue;
      sender->addTap([this, name = package->name](const robotlink::PackagePtr& value) {
        const bool counts = countsDifferences_ && clock_.now() <= comparedUntil_.at(name);
        if (counts) differences_.addRecomputed(name, value);
      });
    }
  }
}

// Packages that are not published in every frame must be there from the start. Those that processes wait for
// are left out: they have triggered their frames already.
void ReplayRobot::giveWhatIsBefore(Instant time) {
  if (!computes()) return;
  std::set<std::string> awaited;
  for (const auto& process : plan_.layout.processes) {
    for (const auto& input : process.blocking) awaited.insert(input.package);
  }
  const auto before = [&](const std::string& package, Instant last) {
    return log_->latest(logName_ + "/" + package, last);
  };
  const Instant earlier = time - robotlink::Duration(1);
  for (const auto& package : plan_.packages) {
    if (package.source != ControlReplay::AS_LOGGED || awaited.contains(package.name)) continue;
    if (const auto message = before(package.name, earlier))
      program_->platform.put(package.name, message->value);
  }
  // Requests at `time` itself are taken from the log at that instant, if it contains requests.
  for (const std::string& package : robotlink::debugPackages()) {
    const auto message = before(package, hasRequests() ? earlier : time);
    if (!message) continue;
    const auto* table = dynamic_cast<const robotcontrol::ColorTable*>(message->value.get());
    const bool own = table != nullptr && !table->cells().empty();
    program_->program->debugProcess().offer(
        own ? std::make_shared<const robotcontrol::ColorTable>(colorTableOfLog(*table)) : message->value);
  }
  if (const auto table = overrides().colorTable()) program_->program->debugProcess().offer(table);
}

}  // namespace app
