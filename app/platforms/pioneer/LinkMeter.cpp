// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/pioneer/LinkMeter.h"

#include <algorithm>

#include "robotlink/packages/Conversions.h"

namespace app {
namespace {

/// The largest number of packets between two calls of takePackets().
constexpr int kMaxKept = 2000;
/// Limits the memory if packets arrive faster than any line carries them.
constexpr std::size_t kMaxSamples = 20000;

}  // namespace

void LinkMeter::setKeeping(bool keeping) {
  keeping_ = keeping;
  if (!keeping) kept_.clear_packets();
}

void LinkMeter::packet(bool fromRobot, const robotlink::arcos::Packet& packet,
                       std::span<const std::uint8_t> frame, robotlink::Instant now) {
  if (fromRobot) ++packets_;
  if (samples_.size() >= kMaxSamples) samples_.pop_front();
  samples_.push_back({now, packet.frameSize(), fromRobot});
  if (!keeping_) return;
  if (frame.empty()) {
    keep(fromRobot, false, robotlink::arcos::encode(packet), now);
  } else {
    keep(fromRobot, false, frame, now);
  }
}

void LinkMeter::damage(std::span<const std::uint8_t> bytes, robotlink::Instant now) {
  keep(true, true, bytes, now);
}

void LinkMeter::keep(bool fromRobot, bool damaged, std::span<const std::uint8_t> bytes,
                     robotlink::Instant now) {
  if (!keeping_) return;
  if (kept_.packets_size() >= kMaxKept) {
    ++dropped_;
    return;
  }
  auto& packet = *kept_.add_packets();
  robotlink::assign(*packet.mutable_timestamp(), now);
  packet.set_from_robot(fromRobot);
  packet.set_damaged(damaged);
  packet.set_bytes(bytes.data(), bytes.size());
}

void LinkMeter::cycle(robotlink::Instant now) {
  if (gaps_.size() >= kMaxSamples) gaps_.pop_front();
  if (lastCycle_) gaps_.push_back({now, now - *lastCycle_});
  lastCycle_ = now;
  forgetOld(now);
}

void LinkMeter::forgetOld(robotlink::Instant now) {
  while (!samples_.empty() && samples_.front().time + kWindow < now) samples_.pop_front();
  while (!gaps_.empty() && gaps_.front().time + kWindow < now) gaps_.pop_front();
}

void LinkMeter::fill(robotcontrol::LinkStatus& status, robotlink::Instant now) {
  forgetOld(now);
  // Shortly after the first packet the window is not full yet.
  const double span = samples_.empty() ? 1
                                       : std::clamp(robotlink::seconds(now - samples_.front().time), 0.5,
                                                    robotlink::seconds(kWindow));
  double packets = 0, bytes = 0, commands = 0;
  for (const Sample& sample : samples_) {
    if (sample.fromRobot) {
      ++packets;
      bytes += static_cast<double>(sample.bytes);
    } else {
      ++commands;
    }
  }
  status.set_packets(packets_);
  status.set_packets_per_second(packets / span);
  status.set_bytes_per_second(bytes / span);
  status.set_commands_per_second(commands / span);
  robotlink::Duration longest = lastCycle_ ? now - *lastCycle_ : robotlink::Duration{};
  for (const Gap& gap : gaps_) longest = std::max(longest, gap.length);
  status.set_longest_gap(robotlink::seconds(longest));
}

std::shared_ptr<robotcontrol::LinkPackets> LinkMeter::takePackets(robotlink::Instant now) {
  if (kept_.packets_size() == 0) return nullptr;
  auto packets = std::make_shared<robotcontrol::LinkPackets>();
  packets->Swap(&kept_);
  packets->set_dropped(dropped_);
  robotlink::assign(*packets->mutable_timestamp(), now);
  return packets;
}

}  // namespace app
