// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/own/OwnProgramServer.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <set>

#include "app/core/own/CrashReport.h"
#include "app/core/own/ProgramMaterials.h"
#include "robotlink/debugging/SharedDebugQueue.h"

namespace app {

using robotcontrol::WireAnswer;
using robotcontrol::WireOrder;
using robotlink::Errors;

namespace {

constexpr std::chrono::hours kServeForever{24 * 365};
/// The maximum number of events that wait for a host that does not read.
constexpr int kMaxWaitingEvents = 5000;

robotlink::Instant orderedTime(std::int64_t nanoseconds) {
  return robotlink::Instant(robotlink::Duration(nanoseconds));
}

}  // namespace

OwnProgramServer::OwnProgramServer(ProgramLink link, int socket, const robotcontrol::WireSetup& setup)
    : link_(std::move(link)),
      socket_(socket),
      clock_(setup.real_time()),
      platform_(setup, clock_),
      lockstep_(
          {.advance = {},
           .onStarved = [this](const auto& process,
                               const auto& what) { addTrouble(process, "waits for " + what); },
           .onFailed =
               [this](const auto& process) { addTrouble(process, kStoppedText + process.failure()); }}) {
  clock_.set(orderedTime(setup.time()));
  if (!setup.threads()) return;
  news_ = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  platform_.setWakeUp([this] { wakeUp(); });
  threads_ = std::make_unique<ProgramExecutor>(threadOptions(setup));
}

OwnProgramServer::~OwnProgramServer() {
  if (news_ >= 0) ::close(news_);
}

ProgramExecutor::Options OwnProgramServer::threadOptions(const robotcontrol::WireSetup& setup) {
  return {.kind = ExecutorKind::kThreads,
          .trouble = [this](const auto& process, const auto& text) { addTrouble(process, text); },
          .patience = std::chrono::duration_cast<std::chrono::milliseconds>(
              std::chrono::duration<double>(setup.patience())),
          .stuck = [this](const auto&, const std::string& what) { noteStuck(what); },
          .started = [](const robotlink::Process& process) { CrashReport::enterThread(process); }};
}

// ---- What happens in the program

void OwnProgramServer::addEvent(const std::function<void(robotcontrol::WireResult::Event& event)>& fill) {
  {
    const std::lock_guard lock(mutex_);
    if (threads_ && events_.events_size() >= kMaxWaitingEvents) return;
    fill(*events_.add_events());
  }
  wakeUp();
}

void OwnProgramServer::addTrouble(const robotlink::Process& process, const std::string& text) {
  addEvent([&](auto& event) {
    event.mutable_trouble()->set_process(process.name());
    event.mutable_trouble()->set_text(text);
  });
}

void OwnProgramServer::noteStuck(const std::string& what) {
  const auto& all = program_->processes();
  const auto stuck = std::ranges::find_if(all, [&](const robotlink::Process* process) {
    return !what.empty() && what.ends_with("process " + process->name());
  });
  CrashReport::suspect(stuck == all.end() ? nullptr : *stuck);
  addEvent([&](auto& event) { event.mutable_stuck()->set_what(what); });
}

void OwnProgramServer::tapDebugProcess() {
  program_->debugProcess().setListener([this](const auto& queue) {
    auto wire = toWire(*queue);
    addEvent([&](auto& event) { event.mutable_queue()->Swap(&wire); });
  });
  const auto& senders = program_->debugProcess().senders();
  for (std::size_t i = 0; i < senders.size(); ++i) {
    if (senders[i]->package().starts_with("debug/")) continue;
    senders[i]->addTap([this, i](const robotlink::PackagePtr& package) {
      addEvent([&](auto& event) { assign(*event.mutable_debug_package(), i, *package); });
    });
  }
}

// ---- Making it

void OwnProgramServer::make(const robotcontrol::WireSetup& setup) {
  auto& described = *answer_.mutable_program();
  auto materials = programMaterials(setup);
  tl::expected<std::unique_ptr<robotlink::RobotProgram>, Errors> program =
      tl::unexpected(materials ? Errors{} : materials.error());
  if (materials) {
    program = robotlink::RobotProgram::create(std::move(materials->robot), std::move(materials->layout),
                                              platform_, materials->parameters);
  }
  if (program) {
    program_ = std::move(*program);
    CrashReport::watch(program_->processes());
    if (threads_) threads_->add(platform_, program_->processes());
    lockstep_.add(platform_);
    addInOrder(setup);
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

void OwnProgramServer::addInOrder(const robotcontrol::WireSetup& setup) {
  const auto& processes = program_->processes();
  if (setup.order().empty()) {
    for (robotlink::Process* process : processes) lockstep_.add(*process);
  }
  for (const std::string& name : setup.order()) {
    if (robotlink::Process* turn = platform_.turnOf(name)) lockstep_.add(*turn);
    const auto found = std::ranges::find_if(
        processes, [&](const robotlink::Process* process) { return process->name() == name; });
    if (found != processes.end()) lockstep_.add(**found);
  }
}

void OwnProgramServer::tapPackages(const robotcontrol::RecordPackages& wanted) {
  const std::set<std::string> packages(wanted.packages().begin(), wanted.packages().end());
  for (const robotlink::Process* process : program_->processes()) {
    for (robotlink::AnySender* sender : process->senders()) {
      if (!packages.contains(sender->package())) continue;
      sender->addTap([this, name = sender->package()](const robotlink::PackagePtr& package) {
        addEvent([&](auto& event) {
          event.mutable_tapped()->set_name(name);
          assign(*event.mutable_tapped()->mutable_package(), 0, *package);
        });
      });
    }
  }
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

// ---- Orders

void OwnProgramServer::send() {
  (void)link_.send(answer_, kServeForever);
}

void OwnProgramServer::serve() {
  if (threads_) return serveThreads();
  WireOrder order;
  while (program_ && link_.receive(order, kServeForever) == ProgramLink::Outcome::kDone) {
    answer_.Clear();
    fulfill(order);
    send();
  }
}

void OwnProgramServer::serveThreads() {
  WireOrder order;
  while (program_) {
    pollfd look[2] = {{socket_, POLLIN, 0}, {news_, POLLIN, 0}};
    if (::poll(look, 2, -1) < 0) continue;
    if (look[1].revents != 0) sendNews();
    if (look[0].revents == 0) continue;
    const auto outcome = link_.receive(order, std::chrono::milliseconds(0));
    if (outcome == ProgramLink::Outcome::kEnded) break;
    if (outcome == ProgramLink::Outcome::kTimeout) continue;  // the rest is received later
    answer_.Clear();
    fulfill(order);
    send();
  }
  (void)threads_->stop();
}

void OwnProgramServer::wakeUp() const {
  const std::uint64_t one = 1;
  if (news_ >= 0) (void)!::write(news_, &one, sizeof one);
}

void OwnProgramServer::sendNews() {
  std::uint64_t count = 0;
  (void)!::read(news_, &count, sizeof count);
  answer_.Clear();
  auto& result = *answer_.mutable_result();
  takeResult(result);
  if (result.events().empty() && result.packages().empty()) return;
  result.set_unasked(true);
  send();
}

void OwnProgramServer::fulfill(const WireOrder& order) {
  switch (order.what_case()) {
    case WireOrder::kStep:
      return threads_ ? stepThreads(order.step()) : step(order.step());
    case WireOrder::kSetKeys:
      program_->setKeys({order.set_keys().modes().begin(), order.set_keys().modes().end()});
      return answer_.set_done(true);
    case WireOrder::kRecordPackages: {
      const auto& packages = order.record_packages().packages();
      program_->recordPackages({packages.begin(), packages.end()});
      return answer_.set_done(true);
    }
    case WireOrder::kTap:
      tapPackages(order.tap());
      return answer_.set_done(true);
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

void OwnProgramServer::takeRequests(const robotcontrol::WireStep& step) {
  for (const auto& wire : step.offers()) {
    if (const auto package = packageIn(wire)) program_->debugProcess().offer(package);
  }
  for (const auto& request : step.requests()) (void)program_->debugProcess().request(request);
}

// Works like an executor that runs the platform itself: the sensors, then all processes that can run, then
// what goes to the actuators.
void OwnProgramServer::step(const robotcontrol::WireStep& step) {
  clock_.set(orderedTime(step.time()));
  preview_.reset();
  if (step.platform_ran()) {
    platform_.setPackages(step.packages());
    lockstep_.stepPlatforms();
  }
  takeRequests(step);
  lockstep_.runProcesses();
  takeResult(*answer_.mutable_result());
}

void OwnProgramServer::stepThreads(const robotcontrol::WireStep& step) {
  clock_.set(orderedTime(step.time()));
  preview_.reset();
  if (!std::exchange(isStarted_, true)) threads_->start();
  takeRequests(step);
  platform_.setPackages(step.packages());
  threads_->step();
  takeResult(*answer_.mutable_result());
}

void OwnProgramServer::takeResult(robotcontrol::WireResult& result) {
  {
    const std::lock_guard lock(mutex_);
    result.Swap(&events_);
    events_.Clear();
  }
  platform_.takeTo(*result.mutable_packages());
  platform_.connectedTo(*result.mutable_connected());
  result.set_missing_process(program_->missingProcess());
  result.set_debug_frames(program_->debugProcess().frames());
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

}  // namespace app
