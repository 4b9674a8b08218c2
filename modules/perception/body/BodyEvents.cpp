// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/perception/body/BodyEvents.h"

#include <algorithm>
#include <cmath>

namespace modules {

const BodyEvents& ContactEvents::update(const BodyFrame& frame) {
  const double seconds = robotlink::seconds(frame.time);
  falls_.update(frame.acceleration, frame.time);
  events_.fallen = falls_.fallen();
  events_.side = falls_.side();
  const bool touches = std::ranges::any_of(frame.contacts, [](bool contact) { return contact; });
  lifted_ = touches || frame.shaken ? 0 : lifted_ + seconds;
  standing_ = touches ? standing_ + seconds : 0;
  if (lifted_ >= options_.pickedUpAfter) events_.pickedUp = true;
  if (standing_ >= options_.putDownAfter || events_.fallen) events_.pickedUp = false;
  const bool steps = frame.walking && !frame.shaken && !events_.fallen && !events_.pickedUp;
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    kept_[i] = steps && frame.contacts[i] == contacts_[i] ? kept_[i] + seconds : 0;
    events_.collided[i] = kept_[i] >= options_.stuckAfter;
  }
  contacts_ = frame.contacts;
  return events_;
}

void JointErrorEvents::updateLoad(const BodyFrame& frame, double seconds) {
  double torque = 0;
  for (const double knee : frame.kneeTorques) torque += 0.25 * std::abs(knee);
  if (!std::isfinite(torque) || torque == 0) return;
  const double share = seconds / (options_.loadTime + seconds);
  load_ += share * (torque - load_);
  loadKnown_ = frame.shaken ? 0 : loadKnown_ + seconds;
}

void JointErrorEvents::updateErrors(const BodyFrame& frame, double seconds) {
  const bool steps = frame.walking && !frame.shaken && !events_.fallen && !events_.pickedUp;
  walked_ = steps ? walked_ + seconds : 0;
  const double fast = seconds / (options_.errorTime + seconds);
  // Over the time that is known at first, so that the average is right from the beginning.
  const double slow = seconds / (std::min(options_.usualTime, walked_) + seconds);
  for (const Leg leg : kLegs) {
    LegError& error = legs_[index(leg)];
    const LegAngles &m = frame.measured[index(leg)], &r = frame.requested[index(leg)];
    const double off =
        (std::abs(m.swing - r.swing) + std::abs(m.spread - r.spread) + std::abs(m.knee - r.knee)) / 3;
    events_.collided[index(leg)] = false;
    error.excess = 0;
    if (!steps || !std::isfinite(off)) continue;
    error.now = walked_ <= seconds ? off : error.now + fast * (off - error.now);
    if (walked_ <= seconds) error.mean = error.variance = 0;
    const double deviation = std::sqrt(std::max(1e-6, error.variance));
    error.excess = (error.now - error.mean) / deviation;
    const bool known = walked_ >= options_.learningTime;
    events_.collided[index(leg)] = known && error.excess >= options_.deviations;
    // A collision must not become usual.
    if (known && error.excess >= 0.7 * options_.deviations) continue;
    const double difference = error.now - error.mean;
    error.mean += slow * difference;
    error.variance += slow * (difference * difference - error.variance);
  }
}

const BodyEvents& JointErrorEvents::update(const BodyFrame& frame) {
  const double seconds = robotlink::seconds(frame.time);
  falls_.update(frame.acceleration, frame.time);
  events_.fallen = falls_.fallen();
  events_.side = falls_.side();
  updateLoad(frame, seconds);
  // A robot that is picked up is not loaded; the threshold is lower than the one for putting it down.
  if (loadKnown_ >= 2 * options_.loadTime)
    events_.pickedUp = !events_.fallen && load_ < (events_.pickedUp ? 1.2 : 1.0) * options_.load;
  updateErrors(frame, seconds);
  return events_;
}

}  // namespace modules
