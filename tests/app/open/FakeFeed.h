// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "app/core/platform/PlatformFeed.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/session/Session.h"

namespace app::test {

/// What happened to platforms that a test has opened, and how they behave. Any thread.
class FeedNotes {
 public:
  void add(const std::string& event) {
    const std::lock_guard lock(mutex_);
    events_.push_back(event);
  }
  void add(const robotcontrol::Request& request) {
    const std::lock_guard lock(mutex_);
    requests_.push_back(request);
  }
  std::vector<std::string> events() const {
    const std::lock_guard lock(mutex_);
    return events_;
  }
  std::vector<robotcontrol::Request> requests() const {
    const std::lock_guard lock(mutex_);
    return requests_;
  }

  /// Whether the programs answer, rather than leaving their requests open.
  std::atomic<bool> answers = true;
  /// How far PlatformFeed::reload() comes.
  enum class Reload : std::uint8_t { kInPlace, kOpened, kFails };
  std::atomic<Reload> reload = Reload::kInPlace;

 private:
  /// Protects the members below.
  mutable std::mutex mutex_;
  std::vector<std::string> events_;
  std::vector<robotcontrol::Request> requests_;
};

/// A platform without time: it notes what is asked of it.
class FakeFeed final : public PlatformFeed {
 public:
  using Overrides = std::map<std::string, ProgramOverrides>;

  FakeFeed(LoadedPlatform loaded, robotlink::Session& session, std::shared_ptr<FeedNotes> notes,
           Overrides overrides)
      : loaded_(std::move(loaded)),
        session_(session),
        notes_(std::move(notes)),
        overrides_(std::move(overrides)) {}

  void begin() override { note("begin"); }
  std::optional<robotlink::PacedThread::Clock::time_point> due() override { return std::nullopt; }
  void step() override {}
  std::vector<std::string> end() override {
    note("end");
    return {loaded_.title + " was shut down."};
  }
  robotlink::Errors setLayout(const std::filesystem::path& file) override {
    if (file == "bad.yaml") return {{"layout.bad", "the layout is bad", {}, {}}};
    loaded_.layout = file;
    return {};
  }
  tl::expected<bool, robotlink::Errors> reload(FileTexts, bool) override {
    if (notes_->reload == FeedNotes::Reload::kFails)
      return tl::unexpected(robotlink::Errors{{"scene.bad", "the scene is bad", {}, {}}});
    return notes_->reload == FeedNotes::Reload::kInPlace;
  }
  PlatformOpening reopening(FileTexts texts) const override;
  LoadedPlatform describe() const override { return loaded_; }
  std::shared_ptr<StopSwitch> stopSwitch() const override { return stop_; }
  void publishStatus() override {}
  void setDemand(const Demand& demand) override {
    note(demand.transforms ? "everything is read" : "nobody reads transforms");
  }
  void makeWay() override { note("makes way"); }
  robotlink::Errors restoreAfterMakeWay() override {
    note("is restored");
    return {{"port.taken", "the port was taken meanwhile", {}, {}}};
  }
  Going going() const override { return {true, 3}; }
  void inheritPlayback(const Going& going) override {
    note(going.running && going.speed == 3 ? "goes on" : "stands");
  }
  Overrides overrides() const override { return overrides_; }
  void connectNow() override { note("connects"); }

 protected:
  robotlink::Result<void> requestRobot(const robotcontrol::Request& request) override {
    if (!loaded_.robots.contains(request.robot()))
      return robotlink::failure("robot.unknown", "there is no robot " + request.robot());
    notes_->add(request);
    if (notes_->answers && robotlink::kindOf(request).isOfProgram()) {
      robotcontrol::RequestResult result;
      result.set_id(request.id());
      result.set_accepted(true);
      session_.pushResult(result);
    }
    return {};
  }
  robotlink::Result<void> requestReplay(const robotcontrol::Request& request) override {
    notes_->add(request);
    return {};
  }

 private:
  void note(const std::string& what) { notes_->add(loaded_.title + ": " + what); }

  LoadedPlatform loaded_;
  robotlink::Session& session_;
  const std::shared_ptr<FeedNotes> notes_;
  const Overrides overrides_;
  /// Says at once, in any thread, that it was used.
  const std::shared_ptr<StopSwitch> stop_ = std::make_shared<StopSwitch>(
      "red1", [notes = notes_](bool engaged) { notes->add(engaged ? "switch: stop" : "switch: go"); });
};

/// A platform with one robot, red1, and one source, which is its title.
inline LoadedPlatform fakePlatform(const std::string& title, TimeKind time = TimeKind::kReal) {
  LoadedPlatform loaded;
  loaded.adapter = "fake";
  loaded.time = time;
  loaded.sources = {title};
  loaded.title = title;
  loaded.robots = {{"red1", nullptr}};
  return loaded;
}

/// Opens it. Its feed has these overrides, besides those that it is given.
inline PlatformOpening fakeOpening(const LoadedPlatform& loaded, const std::shared_ptr<FeedNotes>& notes,
                                   const FakeFeed::Overrides& overrides = {}) {
  PlatformOpening opening;
  opening.adapter = loaded.adapter;
  opening.sources = loaded.sources;
  opening.make = [loaded, notes, overrides](const PlatformContext& context) -> PlatformOpening::Made {
    for (const auto& [robot, given] : context.overrides) notes->add(loaded.title + " gets those of " + robot);
    auto all = context.overrides;
    all.insert(overrides.begin(), overrides.end());
    return std::make_unique<FakeFeed>(loaded, context.session, notes, std::move(all));
  };
  return opening;
}

inline PlatformOpening FakeFeed::reopening(FileTexts) const {
  LoadedPlatform again = loaded_;
  again.title += " again";
  return fakeOpening(again, notes_);
}

/// What cannot be opened.
inline PlatformOpening failingOpening(const std::string& id, const std::string& why) {
  PlatformOpening opening;
  opening.adapter = "fake";
  opening.make = [id, why](const PlatformContext&) -> PlatformOpening::Made {
    return tl::unexpected(robotlink::Errors{{id, why, {}, {}}});
  };
  return opening;
}

}  // namespace app::test
