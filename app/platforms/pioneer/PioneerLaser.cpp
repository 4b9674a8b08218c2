// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/pioneer/PioneerLaser.h"

#include <utility>

namespace app {

namespace arcos = robotlink::arcos;

PioneerLaser::PioneerLaser(arcos::StreamUrl line, arcos::SickSession::Options options,
                           const robotlink::Clock& clock)
    : address_(std::move(line)), clock_(clock), session_(options), line_(toString(address_), clock) {}

PioneerLaser::~PioneerLaser() {
  session_.end();
  if (auto bytes = session_.takeOutgoing(); !bytes.empty()) line_.send(std::move(bytes));
}

void PioneerLaser::step() {
  for (const PioneerLine::Event& event : line_.take()) {
    // Events of a line that is to be opened again are out of date.
    if (session_.wantedLine() != wanted_) break;
    if (const auto* bytes = std::get_if<PioneerLine::Bytes>(&event.what)) {
      session_.take(*bytes, event.time);
    } else if (const auto* lost = std::get_if<PioneerLine::Lost>(&event.what)) {
      session_.lineLost(lost->why, event.time);
    } else {
      session_.lineOpened(event.time);
    }
  }
  session_.tick(clock_.now());
  if (auto bytes = session_.takeOutgoing(); !bytes.empty()) line_.send(std::move(bytes));
  const auto wanted = session_.wantedLine();
  if (wanted == wanted_) return;
  // A closed line reports nothing more; only then can it be opened at another speed.
  line_.close();
  if (!line_.isIdle()) return;
  line_.take();
  wanted_ = wanted;
  if (!wanted) return;
  arcos::StreamUrl url = address_;
  if (auto* serial = std::get_if<arcos::SerialAddress>(&url)) serial->baud = wanted->baud;
  line_.open(toString(url));
}

std::optional<arcos::RangeScan> PioneerLaser::takeScan() {
  auto scan = session_.takeScan();
  if (!scan) return std::nullopt;
  arcos::RangeScan result;
  result.time = scan->time;
  result.startAngle = scan->readings.startAngle;
  result.angleStep = scan->readings.angleStep;
  result.ranges = std::move(scan->readings.ranges);
  return result;
}

}  // namespace app
