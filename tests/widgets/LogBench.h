// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "tests/widgets/Bench.h"
#include "widgets/log/OpenLogs.h"

namespace widgets::test {

/// A LogReading whose results the test sets.
class FakeReading final : public LogReading {
 public:
  struct Wanted {
    std::string stream;
    std::vector<robotlink::Instant> times;
  };
  std::shared_ptr<const LogOverview> overview() override { return published; }
  void wantThumbnails(const std::string& stream, std::vector<robotlink::Instant> times, int) override {
    if (stream != wanted.stream) thumbnails.clear();
    wanted = {stream, std::move(times)};
  }
  std::vector<LogThumbnail> takeThumbnails() override { return std::exchange(thumbnails, {}); }
  std::optional<robotlink::Result<logplayer::Bookmarks>> takeBookmarks() override {
    return std::exchange(bookmarks, std::nullopt);
  }

  std::shared_ptr<const LogOverview> published;
  Wanted wanted;
  std::vector<LogThumbnail> thumbnails;
  std::optional<robotlink::Result<logplayer::Bookmarks>> bookmarks;
};

/// A log that is no file.
inline constexpr char kFile[] = "/logs/game.mcap";

inline robotlink::Instant at(double seconds) {
  return robotlink::Instant(robotlink::fromSeconds(seconds));
}

/// A log from 10 to 40 s: images at 5 Hz, joints at 100 Hz with a gap from 20 to 25 s, a warning and an
/// error.
inline LogOverview overviewOfTest(const std::string& file) {
  using robotlink::Instant;
  LogOverview overview;
  overview.file = file;
  overview.stage = LogOverview::Stage::kDone;
  overview.robots = {"nao"};
  overview.begin = at(10);
  overview.end = at(40);
  const auto add = [&](const char* path, const char* type, double rate, double gapFrom, double gapTo) {
    std::vector<Instant> times;
    for (double t = 10; t <= 40 + 1e-9; t += 1 / rate) {
      if (t < gapFrom || t >= gapTo) times.push_back(at(t));
    }
    LogOverview::Stream stream{path, type, times.size(), times.size() * 1000, times.front(), times.back()};
    stream.density = MessageDensity(times);
    overview.streams.push_back(std::move(stream));
  };
  add("nao/camera/image", "foxglove.CompressedImage", 5, 50, 50);
  add("nao/frames/cognition", "robotcontrol.FrameInfo", 10, 50, 50);
  add("nao/joints/states", "foxglove.JointStates", 100, 20, 25);
  add("nao/log", "foxglove.Log", 0.5, 50, 50);
  overview.said.push_back({at(18), LogEntry::Level::kWarning, QStringLiteral("nao"),
                           QStringLiteral("cognition"), QStringLiteral("the ball was lost")});
  overview.said.push_back({at(31), LogEntry::Level::kError, QStringLiteral("nao"), QStringLiteral("motion"),
                           QStringLiteral("a servo does not answer")});
  return overview;
}

/// A Bench with logs: the test publishes the status of the replay; requests have no effect by themselves.
class LogBench : public Bench {
 public:
  LogBench() {
    context.logs = std::make_shared<OpenLogs>(session, [this](const std::filesystem::path& file) {
      auto reading = std::make_unique<FakeReading>();
      auto overview = overviewOfTest(file.string());
      if (shapeOverview) shapeOverview(overview);
      reading->published = std::make_shared<const LogOverview>(std::move(overview));
      readings[file.string()] = reading.get();
      return reading;
    });
    status.set_begin(at(10).time_since_epoch().count());
    status.set_end(at(40).time_since_epoch().count());
    status.set_time(status.begin());
    status.set_speed(1);
    status.set_step_process("nao/cognition");
    auto& process = *status.add_processes();
    process.set_name("nao/cognition");
    process.set_frames(301);
    status.add_processes()->set_name("nao/motion");
  }

  void openLog(const std::string& path, double offset = 0) {
    auto& log = *status.add_logs();
    log.set_path(path);
    log.set_offset(robotlink::fromSeconds(offset).count());
    status.set_end(std::max(status.end(), at(40 + offset).time_since_epoch().count()));
    publish();
  }
  void showTime(double seconds) {
    status.set_time(at(seconds).time_since_epoch().count());
    publish();
  }
  void setRange(double from, double to) {
    status.mutable_range()->set_from(at(from).time_since_epoch().count());
    status.mutable_range()->set_to(at(to).time_since_epoch().count());
    publish();
  }
  /// Publishes the current status and updates session and logs.
  void publish() {
    push("replay", status, 1);
    session.tick();
    context.logs->tick();
  }
  void tick(View& view) {
    session.tick();
    context.logs->tick();
    view.tick();
  }
  template <typename V>
  std::unique_ptr<V> openView(QSize size = {1000, 400}) {
    auto view = open<V>(size);
    tick(*view);
    return view;
  }
  /// The last request to the replay; aborts the test if there is none.
  const robotcontrol::ControlReplay& asked() const {
    if (requests.empty() || !requests.back().has_control_replay()) qFatal("nothing was asked of the replay");
    return requests.back().control_replay();
  }
  OpenLogs& logs() { return *context.logs; }

  robotcontrol::ReplayStatus status;
  std::map<std::string, FakeReading*> readings;
  std::function<void(LogOverview&)> shapeOverview;
};

}  // namespace widgets::test
