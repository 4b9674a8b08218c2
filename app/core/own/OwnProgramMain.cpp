// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/own/OwnProgramMain.h"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <string>
#include <thread>

#include "app/core/own/CrashReport.h"
#include "app/core/own/MirrorPlatform.h"
#include "app/core/own/ProgramLink.h"
#include "app/core/program/ProgramSetups.h"
#include "app/core/program/RobotFiles.h"
#include "robotlink/base/GroundMap.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/debugging/program/RequestPreview.h"
#include "robotlink/debugging/program/RobotProgram.h"
#include "robotlink/process/LockstepExecutor.h"

namespace app {
namespace {

using robotcontrol::WireAnswer;
using robotcontrol::WireOrder;
using robotlink::Errors;

constexpr std::chrono::hours kForever{24 * 365};
/// How long a program may take to end after its host has gone.
constexpr std::chrono::milliseconds kGrace{1000};

robotlink::Instant orderedTime(std::int64_t nanoseconds) {
  return robotlink::Instant(robotlink::Duration(nanoseconds));
}

/// Ends this process when the host has gone, whatever the program does then.
void watchHost() {
  std::thread([] {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    pollfd look{kProgramSocket, 0, 0};
    while (::poll(&look, 1, -1) < 0) {
    }
    std::this_thread::sleep_for(kGrace);
    ::_exit(0);
  }).detach();
}

void limitMemory(std::uint64_t bytes) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  if (bytes == 0) return;
  const rlimit limit{bytes, bytes};
  ::setrlimit(RLIMIT_DATA, &limit);
#else
  (void)bytes;  // Sanitizers reserve far more than they use.
#endif
}

/// What a program is made of, read from the files that the host names.
struct Materials {
  robotlink::RobotSetup robot;
  robotlink::Layout layout;
  robotlink::ParameterSource parameters;
};

tl::expected<Materials, Errors> materialsOf(const robotcontrol::WireSetup& setup) {
  Materials made;
  auto description = readRobot(setup.kind());
  if (!description) return tl::unexpected(description.error());
  auto field = readField(setup.field_file());
  if (!field) return tl::unexpected(field.error());
  std::map<std::string, std::string> solutions;
  for (const auto& choice : setup.solutions()) solutions[choice.task()] = choice.solution();
  auto layout = readLayoutWith(setup.layout_file(), solutions);
  if (!layout) return tl::unexpected(layout.error());
  made.robot = {setup.robot(), setup.team(), **description, *field, nullptr};
  made.layout = std::move(*layout);
  made.parameters.folder = parameterFolder(**description);
  made.parameters.recorded.assign(setup.parameters().begin(), setup.parameters().end());
  if (setup.map_file().empty()) return made;
  auto map = robotlink::GroundMap::load(setup.map_file());
  if (!map) return tl::unexpected(map.error());
  made.robot.map = std::make_shared<const robotlink::GroundMap>(std::move(*map));
  return made;
}

/// The program of one robot with all that runs it.
class OwnProgramServer {
 public:
  OwnProgramServer(ProgramLink link, const robotcontrol::WireSetup& setup)
      : link_(std::move(link)),
        platform_(setup, clock_),
        executor_({.advance = {},
                   .onStarved = [this](const auto& process,
                                       const auto& what) { addTrouble(process, "waits for " + what); },
                   .onFailed =
                       [this](const auto& process) {
                         addTrouble(process, "was stopped because it threw: " + process.failure());
                       }}) {
    clock_.set(orderedTime(setup.time()));
  }

  /// Makes the program; what is wrong goes into the answer.
  void make(const robotcontrol::WireSetup& setup);
  /// Fulfills orders until the host has gone.
  void serve();

 private:
  void addTrouble(const robotlink::Process& process, const std::string& text);
  void describe(robotcontrol::WireProgram& to);
  void tapDebugProcess();
  void step(const robotcontrol::WireStep& step);
  void fulfill(const WireOrder& order);
  void preview(const WireOrder::Preview& order);
  void takePreview(robotlink::Instant now);
  void send() { (void)link_.send(answer_, kForever); }

  ProgramLink link_;
  robotlink::ManualClock clock_;
  MirrorPlatform platform_;
  std::unique_ptr<robotlink::RobotProgram> program_;
  robotlink::LockstepExecutor executor_;
  std::unique_ptr<robotlink::RequestPreview> preview_;
  /// The result of the current step.
  robotcontrol::WireResult result_;
  WireAnswer answer_;
};

void OwnProgramServer::addTrouble(const robotlink::Process& process, const std::string& text) {
  auto& trouble = *result_.add_events()->mutable_trouble();
  trouble.set_process(process.name());
  trouble.set_text(text);
}

void OwnProgramServer::make(const robotcontrol::WireSetup& setup) {
  auto& described = *answer_.mutable_program();
  auto materials = materialsOf(setup);
  tl::expected<std::unique_ptr<robotlink::RobotProgram>, Errors> program =
      tl::unexpected(materials ? Errors{} : materials.error());
  if (materials) {
    program = robotlink::RobotProgram::create(std::move(materials->robot), std::move(materials->layout),
                                              platform_, materials->parameters);
  }
  if (program) {
    program_ = std::move(*program);
    CrashReport::watch(program_->processes());
    executor_.add(platform_);
    for (robotlink::Process* process : program_->processes()) executor_.add(*process);
    tapDebugProcess();
    describe(described);
  } else {
    for (const robotlink::Error& error : program.error()) {
      auto& problem = *described.add_problems();
      problem.set_id(error.id);
      problem.set_text(error.text);
      problem.mutable_arguments()->Assign(error.arguments.begin(), error.arguments.end());
      problem.set_file(error.where.file);
      problem.set_line(error.where.line);
      problem.set_column(error.where.column);
    }
  }
  send();
}

void OwnProgramServer::describe(robotcontrol::WireProgram& to) {
  const auto yielded = program_->yieldedPackages();
  to.mutable_yielded()->Assign(yielded.begin(), yielded.end());
  for (auto& values : program_->parameters()) *to.add_parameters() = std::move(values);
  to.set_debug_process(program_->debugProcess().name());
  for (const auto* sender : program_->debugProcess().senders()) to.add_debug_senders(sender->package());
  for (const auto* process : program_->processes()) to.add_processes(process->name());
  platform_.connectedTo(*to.mutable_connected());
  platform_.fedTo(*to.mutable_fed());
}

void OwnProgramServer::tapDebugProcess() {
  program_->debugProcess().setListener(
      [this](const auto& queue) { *result_.add_events()->mutable_queue() = toWire(*queue); });
  const auto& senders = program_->debugProcess().senders();
  for (std::size_t i = 0; i < senders.size(); ++i) {
    if (senders[i]->package().starts_with("debug/")) continue;
    senders[i]->addTap([this, i](const robotlink::PackagePtr& package) {
      assign(*result_.add_events()->mutable_debug_package(), i, *package);
    });
  }
}

void OwnProgramServer::serve() {
  WireOrder order;
  while (program_ && link_.receive(order, kForever) == ProgramLink::Outcome::kDone) {
    answer_.Clear();
    fulfill(order);
    send();
  }
}

void OwnProgramServer::fulfill(const WireOrder& order) {
  switch (order.what_case()) {
    case WireOrder::kStep:
      return step(order.step());
    case WireOrder::kSetKeys:
      program_->setKeys({order.set_keys().modes().begin(), order.set_keys().modes().end()});
      return answer_.set_done(true);
    case WireOrder::kRecordPackages: {
      const auto& packages = order.record_packages().packages();
      program_->recordPackages({packages.begin(), packages.end()});
      return answer_.set_done(true);
    }
    case WireOrder::kBeginPreview:
      preview_ = std::make_unique<robotlink::RequestPreview>(*program_);
      return answer_.set_done(true);
    case WireOrder::kPreview:
      return preview(order.preview());
    case WireOrder::kTakePreview:
      return takePreview(orderedTime(order.take_preview()));
    default:
      return answer_.set_done(false);
  }
}

// As an executor does it that runs the platform itself: the sensors, then all processes that can run, then
// what goes to the actuators.
void OwnProgramServer::step(const robotcontrol::WireStep& step) {
  clock_.set(orderedTime(step.time()));
  preview_.reset();
  if (step.platform_ran()) {
    platform_.setPackages(step.packages());
    executor_.stepPlatforms();
  }
  for (const auto& request : step.requests()) (void)program_->debugProcess().request(request);
  executor_.runProcesses();
  platform_.takeTo(*result_.mutable_packages());
  platform_.connectedTo(*result_.mutable_connected());
  result_.set_debug_frames(program_->debugProcess().frames());
  answer_.mutable_result()->Swap(&result_);
  result_.Clear();
}

void OwnProgramServer::preview(const WireOrder::Preview& order) {
  if (!preview_) preview_ = std::make_unique<robotlink::RequestPreview>(*program_);
  if (order.with_result()) {
    answer_.set_refusal(preview_->answer(order.request()) ? "" : "refused");
  } else {
    answer_.set_refusal(preview_->add(order.request()));
  }
}

void OwnProgramServer::takePreview(robotlink::Instant now) {
  const auto queue = preview_ ? preview_->takeQueue(now) : nullptr;
  if (queue) {
    *answer_.mutable_queue() = toWire(*queue);
  } else {
    answer_.set_done(true);
  }
}

int run(const std::string& robot) {
  ::prctl(PR_SET_NAME, ("program " + robot).c_str());
  ::close_range(kProgramReports + 1, ~0U, 0);
  // Ctrl-C in a terminal is for the host, which then ends this process.
  for (const int signal : {SIGINT, SIGHUP, SIGQUIT, SIGPIPE}) std::signal(signal, SIG_IGN);
  CrashReport::install(kProgramReports);
  watchHost();
  ProgramLink link(kProgramSocket);
  WireOrder order;
  if (link.receive(order, kForever) != ProgramLink::Outcome::kDone || !order.has_setup()) ::_exit(0);
  limitMemory(order.setup().memory_limit());
  {
    OwnProgramServer server(std::move(link), order.setup());
    server.make(order.setup());
    server.serve();
  }
  // Not exit(): that would look as if the program had called it.
  ::_exit(0);
}

}  // namespace

std::optional<int> ownProgramMain(int argc, char** argv) {
  if (argc < 3 || std::string(argv[1]) != kProgramArgument) return std::nullopt;
  // Started by hand, there is no host at the other end.
  pollfd look{kProgramSocket, 0, 0};
  if (::poll(&look, 1, 0) < 0 || (look.revents & POLLNVAL) != 0) return 2;
  return run(argv[2]);
}

}  // namespace app
