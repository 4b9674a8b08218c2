// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/dds/FollowedClock.h"

#include <algorithm>

#include "robotlink/base/threads/PacedThread.h"
#include "robotlink/dds/Wire.h"

namespace robotlink::dds {
namespace {

constexpr std::chrono::milliseconds kAnnounceEvery{100};

std::string clockTopic(const std::string& robot) {
  return "robotcontrol/" + robot + "/clock";
}

std::string lifeTopic(const std::string& robot) {
  return "robotcontrol/" + robot + "/alive";
}

/// Writes the time of a clock repeatedly.
class Announcer {
 public:
  /// Without a clock the time is 0.
  Announcer(std::shared_ptr<Node> node, Entity writer, const Clock* clock)
      : node_(std::move(node)),
        writer_(std::move(writer)),
        clock_(clock),
        thread_({.due = [this] { return nextAt_; }, .step = [this] { step(); }}) {}

 private:
  void step() {
    const std::string none;
    const auto time = clock_ != nullptr ? clock_->now().time_since_epoch().count() : 0;
    write(writer_.get(), {.name = none, .type = none, .sender = none, .time = time});
    nextAt_ = PacedThread::Clock::now() + kAnnounceEvery;
  }

  const std::shared_ptr<Node> node_;
  const Entity writer_;
  const Clock* const clock_;
  /// Only the thread's.
  PacedThread::Clock::time_point nextAt_;
  PacedThread thread_;
};

}  // namespace

struct FollowedClock::Reader {
  explicit Reader(FollowedClock& clock) : owner(clock) {}
  void take();

  FollowedClock& owner;
  std::shared_ptr<Node> node;
  std::mutex mutex;  // protects sample
  Sample sample;
  Entity entity;  // last, so that it is deleted first, which waits for its listener
};

FollowedClock::FollowedClock() = default;
FollowedClock::~FollowedClock() = default;

Result<void> FollowedClock::follow(const std::shared_ptr<Node>& node, const std::string& robot) {
  auto reader = std::make_unique<Reader>(*this);
  auto entity = openReader(node->participant(), clockTopic(robot), History::kNewest);
  if (!entity) return tl::unexpected(entity.error());
  reader->node = node;
  reader->entity = std::move(*entity);
  const std::unique_ptr<dds_listener_t, void (*)(dds_listener_t*)> listener(dds_create_listener(reader.get()),
                                                                            &dds_delete_listener);
  dds_lset_data_available(listener.get(),
                          [](dds_entity_t, void* self) { static_cast<Reader*>(self)->take(); });
  dds_set_listener(reader->entity.get(), listener.get());
  reader_ = std::move(reader);
  return {};
}

void FollowedClock::Reader::take() {
  const std::lock_guard lock(mutex);
  while (const auto from = dds::take(entity.get(), sample)) {
    const auto local = std::chrono::steady_clock::now() - owner.start_;
    owner.note(*from, Instant(Duration(sample.package.time)), std::chrono::duration_cast<Duration>(local));
  }
}

void FollowedClock::note(std::uint64_t source, Instant announced, Duration local) {
  const std::lock_guard lock(mutex_);
  const bool isNew = source != source_ || !isSet();
  if (isNew) count_ = 0;
  source_ = source;
  ahead_[count_++ % ahead_.size()] = announced.time_since_epoch() - local;
  // Announcements that were under way for long seem to be less ahead.
  const auto known = static_cast<std::ptrdiff_t>(std::min(count_, ahead_.size()));
  offset_.store(std::max_element(ahead_.begin(), ahead_.begin() + known)->count());
  if (isNew) shown_.store(announced.time_since_epoch().count());
  isSet_.store(true);
}

Instant FollowedClock::at(Duration local) const {
  const Duration::rep time = local.count() + offset_.load();
  Duration::rep before = shown_.load();
  while (time > before && !shown_.compare_exchange_weak(before, time)) {
  }
  return Instant(Duration(std::max(time, before)));
}

Instant FollowedClock::now() const {
  return at(std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now() - start_));
}

struct ClockSource::Implementation {
  Entity lifeSigns;
  std::unique_ptr<Announcer> announcer;
};

ClockSource::ClockSource(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
ClockSource::~ClockSource() = default;

Result<std::unique_ptr<ClockSource>> ClockSource::open(const std::shared_ptr<Node>& node,
                                                       const std::string& robot, const Clock& clock) {
  auto writer = openWriter(node->participant(), clockTopic(robot), History::kNewest);
  if (!writer) return tl::unexpected(writer.error());
  auto lifeSigns = openReader(node->participant(), lifeTopic(robot), History::kNewest);
  if (!lifeSigns) return tl::unexpected(lifeSigns.error());
  auto announcer = std::make_unique<Announcer>(node, std::move(*writer), &clock);
  return std::unique_ptr<ClockSource>(new ClockSource(
      std::make_unique<Implementation>(Implementation{std::move(*lifeSigns), std::move(announcer)})));
}

struct LifeSign::Implementation {
  std::unique_ptr<Announcer> announcer;
};

LifeSign::LifeSign(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
LifeSign::~LifeSign() = default;

Result<std::unique_ptr<LifeSign>> LifeSign::open(const std::shared_ptr<Node>& node,
                                                 const std::string& robot) {
  auto writer = openWriter(node->participant(), lifeTopic(robot), History::kNewest);
  if (!writer) return tl::unexpected(writer.error());
  return std::unique_ptr<LifeSign>(new LifeSign(std::make_unique<Implementation>(
      Implementation{std::make_unique<Announcer>(node, std::move(*writer), nullptr)})));
}

}  // namespace robotlink::dds
