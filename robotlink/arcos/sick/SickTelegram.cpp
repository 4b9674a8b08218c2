// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/sick/SickTelegram.h"

#include <algorithm>
#include <array>

#include "robotlink/base/Geometry.h"

namespace robotlink::arcos {
namespace {

constexpr std::uint8_t kStx = 0x02, kAck = 0x06, kNak = 0x15;
constexpr std::uint8_t kOfLaser = 0x80;
/// STX, address, length; and the checksum.
constexpr std::size_t kHeadSize = 4, kCheckSize = 2;
constexpr std::size_t kMaxUnread = 64U << 10U;
constexpr std::uint8_t kMeasuredValues = 0xB0;

std::vector<std::uint8_t> bytesOf(std::uint8_t address, std::span<const std::uint8_t> contents) {
  std::vector<std::uint8_t> bytes{kStx, address, static_cast<std::uint8_t>(contents.size() & 0xFFU),
                                  static_cast<std::uint8_t>(contents.size() >> 8U)};
  bytes.insert(bytes.end(), contents.begin(), contents.end());
  const std::uint16_t check = sickChecksum(bytes);
  bytes.push_back(static_cast<std::uint8_t>(check & 0xFFU));
  bytes.push_back(static_cast<std::uint8_t>(check >> 8U));
  return bytes;
}

unsigned wordAt(std::span<const std::uint8_t> bytes, std::size_t at) {
  return bytes[at] | static_cast<unsigned>(bytes[at + 1]) << 8U;
}

}  // namespace

std::uint16_t sickChecksum(std::span<const std::uint8_t> bytes) {
  constexpr unsigned kPolynomial = 0x8005;
  unsigned sum = 0;
  std::uint8_t before = 0;
  for (const std::uint8_t byte : bytes) {
    const bool carry = (sum & 0x8000U) != 0;
    sum = (sum << 1U) & 0xFFFFU;
    if (carry) sum ^= kPolynomial;
    sum ^= byte | static_cast<unsigned>(before) << 8U;
    before = byte;
  }
  return static_cast<std::uint16_t>(sum);
}

std::vector<std::uint8_t> sickRequest(const SickTelegram& telegram) {
  std::vector<std::uint8_t> contents{telegram.command};
  contents.insert(contents.end(), telegram.data.begin(), telegram.data.end());
  return bytesOf(0, contents);
}

std::vector<std::uint8_t> sickReply(const SickTelegram& telegram) {
  std::vector<std::uint8_t> contents{telegram.command};
  contents.insert(contents.end(), telegram.data.begin(), telegram.data.end());
  contents.push_back(telegram.status);
  return bytesOf(kOfLaser, contents);
}

void SickParser::push(std::span<const std::uint8_t> bytes) {
  if (begin_ > 0) {
    buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(begin_));
    begin_ = 0;
  }
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
  if (buffer_.size() <= kMaxUnread) return;
  begin_ = buffer_.size() - kMaxUnread;
  counters_.skippedBytes += begin_;
}

void SickParser::clear() {
  buffer_.clear();
  begin_ = 0;
}

std::optional<SickParser::Found> SickParser::next() {
  const std::uint8_t address = from_ == From::kLaser ? kOfLaser : 0;
  // A telegram of the laser has a command and a status.
  const std::size_t least = from_ == From::kLaser ? 2 : 1;
  for (; begin_ < buffer_.size(); ++begin_, ++counters_.skippedBytes) {
    const std::span<const std::uint8_t> rest = std::span(buffer_).subspan(begin_);
    if (rest[0] == kAck || rest[0] == kNak) {
      ++begin_;
      return rest[0] == kAck ? Receipt::kTaken : Receipt::kRefused;
    }
    if (rest[0] != kStx || (rest.size() > 1 && rest[1] != address)) continue;
    if (rest.size() < kHeadSize) return std::nullopt;
    const std::size_t length = wordAt(rest, 2);
    if (length < least || length > kMaxSickLength) continue;
    const std::size_t size = kHeadSize + length + kCheckSize;
    if (rest.size() < size) return std::nullopt;
    if (sickChecksum(rest.first(kHeadSize + length)) != wordAt(rest, kHeadSize + length)) {
      ++counters_.checksumErrors;
      continue;
    }
    const auto contents = rest.subspan(kHeadSize, length);
    SickTelegram telegram;
    telegram.command = contents[0];
    const std::size_t end = from_ == From::kLaser ? length - 1 : length;
    telegram.data.assign(contents.begin() + 1, contents.begin() + static_cast<std::ptrdiff_t>(end));
    if (from_ == From::kLaser) telegram.status = contents.back();
    begin_ += size;
    ++counters_.telegrams;
    return telegram;
  }
  return std::nullopt;
}

std::optional<SickReadings> sickReadings(const SickTelegram& telegram, int bits) {
  if (telegram.command != kMeasuredValues || telegram.data.size() < 2 || bits < 13 || bits > 15)
    return std::nullopt;
  const unsigned head = wordAt(telegram.data, 0);
  const std::size_t count = head & 0x3FFU;
  const bool isPart = (head & 0x2000U) != 0;
  // cm, mm, dm.
  constexpr std::array kUnits{0.01, 0.001, 0.1};
  const unsigned unit = head >> 14U;
  if (isPart || count < 2 || unit >= kUnits.size() || telegram.data.size() < 2 + 2 * count)
    return std::nullopt;
  // The largest values mean that there is no distance: too far, dazzled, too weak.
  const unsigned mask = (1U << static_cast<unsigned>(bits)) - 1, firstInvalid = mask - 8;
  SickReadings readings{-0.5 * kPi, kPi / static_cast<double>(count - 1), std::vector<double>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    const unsigned value = wordAt(telegram.data, 2 + 2 * i) & mask;
    readings.ranges[i] = value < firstInvalid ? kUnits[unit] * value : 0;
  }
  return readings;
}

}  // namespace robotlink::arcos
