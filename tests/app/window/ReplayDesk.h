// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "tests/app/window/Desk.h"

namespace app::test {

/// A desk on which the test is the replay: it publishes the status of a log that is no file, and records the
/// requests.
class ReplayDesk : public EmptyDesk {
 public:
  static constexpr char kFile[] = "/no/such/folder/game.mcap";

  explicit ReplayDesk(const std::filesystem::path& home) : EmptyDesk(home) {
    workbench.session().setRequestSink([this](const robotcontrol::Request& request) {
      if (request.has_control_replay()) asked.push_back(request.control_replay());
      requests.push_back(request);
    });
    window.resize(1400, 900);
    status.set_begin(at(10));
    status.set_end(at(40));
    status.set_time(at(20));
    status.set_speed(1);
    status.set_frame(309);
    status.set_frame_index(101);
    status.set_step_process("nao/cognition");
    for (const char* name : {"nao/cognition", "nao/motion"}) {
      auto& process = *status.add_processes();
      process.set_name(name);
      process.set_frames(434);
    }
  }
  static std::int64_t at(double seconds) { return robotlink::fromSeconds(seconds).count(); }
  void openLog() {
    status.add_logs()->set_path(kFile);
    publish();
  }
  void publish() {
    workbench.session().push({"replay", robotlink::Instant(robotlink::fromSeconds(1)),
                              std::make_shared<const robotcontrol::ReplayStatus>(status)});
    window.tick();
  }
  /// Accepts all requests: the replay is asked for one jump after the other.
  void answer() {
    for (const auto& request : std::exchange(requests, {})) {
      robotcontrol::RequestResult result;
      result.set_id(request.id());
      result.set_accepted(true);
      workbench.session().pushResult(result);
    }
    workbench.session().tick();
  }
  const robotcontrol::ControlReplay& last() const {
    if (asked.empty()) qFatal("nothing was asked of the replay");
    return asked.back();
  }

  robotcontrol::ReplayStatus status;
  std::vector<robotcontrol::ControlReplay> asked;
  std::vector<robotcontrol::Request> requests;
};

}  // namespace app::test
