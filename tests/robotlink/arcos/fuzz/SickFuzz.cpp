// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes from the line of a laser, into the parser and a session.

#include "robotlink/arcos/sick/SickSession.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/robotlink/arcos/sick/SimulatedSick.h"

namespace sick_fuzz {

using namespace robotlink::arcos;

namespace {

void checkTelegrams(const std::uint8_t* data, std::size_t size) {
  SickParser parser;
  std::size_t used = 0;
  for (std::size_t at = 0; at < size;) {
    const std::size_t count = std::min<std::size_t>(1 + data[at] % 61, size - at);
    parser.push({data + at, count});
    at += count;
    while (const auto found = parser.next()) {
      const auto* telegram = std::get_if<SickTelegram>(&*found);
      used += telegram == nullptr ? 1 : telegram->data.size() + 8;
      if (telegram == nullptr) continue;
      require(telegram->data.size() + 2 <= kMaxSickLength, "telegrams are bounded");
      for (int bits = 12; bits <= 16; ++bits) {
        const auto readings = sickReadings(*telegram, bits);
        if (!readings) continue;
        for (const double range : readings->ranges) require(range >= 0 && range <= 3300, "ranges are meters");
      }
      SickParser again;
      again.push(sickReply(*telegram));
      const auto back = again.next();
      require(back && std::get<SickTelegram>(*back) == *telegram, "what is written is read as the same");
    }
  }
  require(used + parser.counters().skippedBytes <= size, "no byte counts twice");
}

/// A laser that says what the input says, and a while passes after each piece.
void checkSession(const std::uint8_t* data, std::size_t size) {
  SickSession session({});
  robotlink::Instant now;
  std::optional<SickSession::Line> open;
  for (std::size_t at = 0; at < size;) {
    const auto wanted = session.wantedLine();
    if (wanted != open && wanted) session.lineOpened(now);
    open = wanted;
    const std::size_t count = std::min<std::size_t>(1 + data[at] % 200, size - at);
    if (data[at] % 64 == 63) session.lineLost({"stream.lost", "gone", {}, {}}, now);
    session.take({data + at, count}, now);
    now += std::chrono::milliseconds(10 * (data[at] % 90));
    session.tick(now);
    require(session.takeOutgoing().size() < 4096, "it says little");
    if (const auto scan = session.takeScan())
      require(scan->readings.ranges.size() <= 1023, "scans are bounded");
    require(!session.describe().empty(), "it says what it does");
    at += count;
  }
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  checkTelegrams(data, size);
  checkSession(data, size);
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  std::vector<std::string> seeds;
  const auto add = [&](const std::vector<std::uint8_t>& bytes) {
    seeds.emplace_back(bytes.begin(), bytes.end());
  };
  std::vector<std::uint8_t> all;
  for (const int code : {0xA0, 0xBB, 0xF4, 0xA0, 0xF7, 0xA0, 0xA0}) {
    const auto command = static_cast<std::uint8_t>(code);
    SickTelegram answer{.command = command, .data = {0}, .status = 0x10};
    if (command == 0xF4) answer.data.assign(34, 0);
    if (command == 0xBB || command == 0xF7) answer.data = {1};
    const auto bytes = sickReply(answer);
    add(bytes);
    all.push_back(0x06);
    all.insert(all.end(), bytes.begin(), bytes.end());
  }
  SimulatedSick laser;
  laser.take(sickRequest({.command = 0x20, .data = {0x24}}), 9600);
  const auto scan = laser.scan(9600);
  add(scan);
  for (int i = 0; i < 3; ++i) all.insert(all.end(), scan.begin(), scan.end());
  add(all);
  return seeds;
}

const FuzzRegistration kTarget({"sick", &fuzzSeeds, &runInput});

}  // namespace sick_fuzz
