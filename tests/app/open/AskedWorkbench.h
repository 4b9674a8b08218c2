// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/core/Workbench.h"
#include "robotcontrol/Requests.pb.h"
#include "tests/TestFolder.h"
#include "tests/app/TickUntil.h"
#include "tests/app/open/FakeFeed.h"

namespace app::test {

/// A workbench without platforms whose requests are seen, and to whose session a test publishes.
struct AskedWorkbench {
  AskedWorkbench() {
    workbench.session().setRequestSink(
        [this](const robotcontrol::Request& request) { asked.push_back(request); });
  }

  /// What a line asks for, without the numbers of requests, or the id and the text of why it is refused.
  std::string run(const std::string& line) {
    asked.clear();
    const auto done = workbench.commands().runLine(line);
    if (!done) return done.error().id + ": " + done.error().text;
    std::string text;
    for (robotcontrol::Request& request : asked) {
      request.clear_id();
      text += (text.empty() ? "" : "; ") + request.ShortDebugString();
    }
    return text;
  }
  /// What can be completed in a command after these arguments.
  std::vector<std::string> offered(const std::string& command, const std::vector<std::string>& before = {}) {
    return workbench.commands().find(command)->offer(before);
  }
  template <typename T>
  void publish(const std::string& path, const T& message, robotlink::Instant time = kNow) {
    workbench.session().push({path, time, std::make_shared<const T>(message)});
    workbench.session().tick();
  }
  /// A simulation runs, as far as commands can tell; false: it does not in time.
  bool openSimulation() {
    LoadedPlatform loaded = fakePlatform("field", TimeKind::kSimulated);
    loaded.adapter = "simulation";
    workbench.open(fakeOpening(loaded, std::make_shared<FeedNotes>()));
    return tickUntil(workbench, [this] { return !workbench.loading(); });
  }

  static constexpr robotlink::Instant kNow{std::chrono::seconds(5)};
  const TestFolder home;
  std::vector<robotcontrol::Request> asked;
  Workbench workbench{home.path()};
};

}  // namespace app::test
