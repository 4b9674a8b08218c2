// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/recordings/RecordingJobs.h"

#include <utility>

namespace app {

using robotlink::Result;

RecordingJobs::RecordingJobs(RecordingFetch::Call call) : call_(std::move(call)) {}

RecordingJobs::~RecordingJobs() {
  isEnding_ = true;
  quick_.close();
  fetches_.close();
}

void RecordingJobs::publish(Outcome outcome) {
  const std::lock_guard lock(mutex_);
  outcomes_.push_back(std::move(outcome));
}

void RecordingJobs::act(Kind kind, const std::string& name, const Action& action) {
  quick_.add([this, kind, name, action] {
    RecordingFetch robot(call_);
    const RecordingFetch::Progress proceed = [this](double) { return !isEnding_; };
    const auto done = action(robot, proceed);
    if (kind == Kind::kList && done) return;
    publish({kind, name, {}, {}, done ? std::nullopt : std::optional(done.error())});
    if (kind != Kind::kList) list();
  });
}

void RecordingJobs::list() {
  if (isListing_.exchange(true)) return;
  act(Kind::kList, {}, [this](RecordingFetch& robot, const RecordingFetch::Progress& proceed) {
    // Changes from now on are seen by the next listing.
    isListing_ = false;
    auto entries = robot.list(proceed);
    if (!entries) return Result<void>(tl::unexpected(entries.error()));
    const std::lock_guard lock(mutex_);
    recordings_ = *std::move(entries);
    return Result<void>();
  });
}

void RecordingJobs::start() {
  act(Kind::kStart, {}, [](RecordingFetch& robot, const auto& proceed) { return robot.start(proceed); });
}

void RecordingJobs::stop() {
  act(Kind::kStop, {}, [](RecordingFetch& robot, const auto& proceed) { return robot.stop(proceed); });
}

void RecordingJobs::remove(const std::string& name) {
  act(Kind::kRemove, name,
      [name](RecordingFetch& robot, const auto& proceed) { return robot.remove(name, proceed); });
}

void RecordingJobs::fetch(const std::string& name, const std::filesystem::path& file, bool replaces) {
  fetches_.add([this, name, file, replaces, generation = generation_.load()] {
    fetchNow(name, file, replaces, generation);
  });
}

void RecordingJobs::fetchNow(const std::string& name, const std::filesystem::path& file, bool replaces,
                             std::uint64_t generation) {
  const auto show = [&](std::optional<Progress> progress) {
    const std::lock_guard lock(mutex_);
    fetching_ = std::move(progress);
  };
  show(Progress{name, 0});
  const auto fetched = RecordingFetch(call_).fetch(name, file, replaces, [&](double share) {
    show(Progress{name, share});
    return !isEnding_ && generation_ == generation;
  });
  show({});
  Outcome outcome{Kind::kFetch, name, file};
  if (fetched)
    outcome.fetched = *fetched;
  else
    outcome.error = fetched.error();
  publish(std::move(outcome));
}

void RecordingJobs::cancel() {
  fetches_.clear();
  ++generation_;
}

std::optional<std::vector<RecordingFetch::Entry>> RecordingJobs::recordings() const {
  const std::lock_guard lock(mutex_);
  return recordings_;
}

std::optional<RecordingJobs::Progress> RecordingJobs::fetching() const {
  const std::lock_guard lock(mutex_);
  return fetching_;
}

std::vector<RecordingJobs::Outcome> RecordingJobs::takeOutcomes() {
  const std::lock_guard lock(mutex_);
  return std::exchange(outcomes_, {});
}

}  // namespace app
