// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/replay/ReplayComputation.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "app/core/program/Abandoned.h"
#include "app/platforms/replay/ReplayRun.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Resources.h"
#include "robotlink/debugging/DebugRoutes.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/process/Process.h"
#include "robotlink/session/QueueMessages.h"

namespace app {
namespace {

using robotcontrol::HostingStatus;
using robotlink::Result;
using robotlink::StreamMessage;

constexpr std::size_t kMaxTroubles = 20;

robotlink::Error firstOf(const robotlink::Errors& errors) {
  return errors.empty() ? robotlink::Error{"replay.failed", "the program cannot be made", {}, {}}
                        : errors.front();
}

/// The run and what it has computed since the last instant. Modules that never return keep it.
struct Computed {
  ReplayRun::Listeners listeners() {
    ReplayRun::Listeners listeners;
    listeners.logged = [this](const std::vector<StreamMessage>& published) { take(published); };
    listeners.queue = [this](const std::string& robot, const auto& queue) {
      if (run) take(messagesOf(robot, *queue, run->now()).messages);
    };
    listeners.trouble = [this](const std::string& robot, const robotlink::Process&, const std::string& text) {
      const std::string sentence = robot + ": " + text;
      if (troubles.size() < kMaxTroubles && std::ranges::find(troubles, sentence) == troubles.end())
        troubles.push_back(sentence);
    };
    listeners.hosting = [this](const std::string&, robotlink::Instant, const HostingStatus& status) {
      const bool isOver =
          status.state() == HostingStatus::NOT_ANSWERING || status.state() == HostingStatus::ENDED;
      if (isOver && !end) end = robotlink::Error{"replay.program", status.text(), {}, {}};
    };
    return listeners;
  }
  void take(const std::vector<StreamMessage>& published) {
    for (const StreamMessage& message : published) {
      if (wanted.contains(message.path)) messages.push_back(message);
    }
  }

  std::set<std::string> wanted;
  std::vector<StreamMessage> messages;
  std::vector<std::string> troubles;
  /// The reason why a program cannot continue.
  std::optional<robotlink::Error> end;
  /// Declared last, since its end calls the listeners.
  std::unique_ptr<ReplayRun> run;
};

class ReplayComputation final : public logplayer::Computation {
 public:
  static Result<std::unique_ptr<logplayer::Computation>> make(const std::shared_ptr<logplayer::LogFile>& log,
                                                              const ComputationOptions& options) {
    if (const auto found = robotlink::checkResources(); !found) return tl::unexpected(found.error());
    ReplayOptions replay;
    replay.logs = {{.file = log->path(), .offsetChosen = true, .opened = log}};
    replay.layout = options.layout;
    replay.solutions = options.solutions;
    replay.patience = options.patience;
    auto computed = std::make_shared<Computed>();
    auto run = ReplayRun::create(std::move(replay), computed->listeners());
    if (!run) return tl::unexpected(firstOf(run.error()));
    computed->run = std::move(*run);
    return std::unique_ptr<logplayer::Computation>(new ReplayComputation(std::move(computed)));
  }
  ~ReplayComputation() override {
    computed_->run->stop();
    if (computed_->run->hasEnded()) return;
    abandon(computed_, [run = computed_->run.get()] { return run->hasEnded(); });
  }
  ReplayComputation(const ReplayComputation&) = delete;
  ReplayComputation& operator=(const ReplayComputation&) = delete;

  std::vector<std::string> streams() const override {
    robotcontrol::ReplayStatus status;
    computed_->run->describe(status);
    std::vector<std::string> paths;
    for (const auto& package : status.packages()) {
      if (!package.logged() && package.can_recompute()) paths.push_back(package.package());
    }
    return paths;
  }

  Result<std::vector<std::string>> run(const std::set<std::string>& streams, const Visit& visit) override {
    ReplayRun& run = *computed_->run;
    computed_->wanted = streams;
    if (const auto asked = askFor(streams); !asked) return tl::unexpected(asked.error());
    // A jump makes the programs again, with the keys on from their first frame.
    if (const auto errors = run.jump(run.begin()); !errors.empty()) return tl::unexpected(firstOf(errors));
    do {
      if (const auto done = visit(run.now(), std::exchange(computed_->messages, {})); !done)
        return tl::unexpected(done.error());
      if (computed_->end) return tl::unexpected(*computed_->end);
    } while (run.step());
    return computed_->troubles;
  }

 private:
  explicit ReplayComputation(std::shared_ptr<Computed> computed) : computed_(std::move(computed)) {}

  /// Switches the debug keys of these packages on.
  Result<void> askFor(const std::set<std::string>& streams) {
    std::uint64_t id = 0;
    for (const std::string& stream : streams) {
      const auto slash = stream.find('/');
      if (slash == std::string::npos) continue;
      robotcontrol::Request request;
      request.set_id(++id);
      request.set_robot(stream.substr(0, slash));
      request.mutable_set_key()->set_name(robotlink::packageKey(stream.substr(slash + 1)));
      request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
      if (const auto asked = computed_->run->request(request); !asked) return asked;
    }
    return {};
  }

  const std::shared_ptr<Computed> computed_;
};

}  // namespace

logplayer::MakeComputation computationByReplay(ComputationOptions options) {
  return [options = std::move(options)](const std::shared_ptr<logplayer::LogFile>& log) {
    return ReplayComputation::make(log, options);
  };
}

}  // namespace app
