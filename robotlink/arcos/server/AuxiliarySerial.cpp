// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/server/AuxiliarySerial.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace robotlink::arcos {
namespace {

constexpr long long kSecondsOfDay = 86400;

/// Degrees and minutes with four decimals: "5305.3200" for two digits of degrees.
std::string degreesAndMinutes(double degrees, int digits) {
  // In units of the last decimal, so that minutes are never rounded to 60.
  const auto units = std::llround(std::abs(degrees) * 60 * 1e4);
  const long long whole = units / 600000, rest = units % 600000;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%0*lld%02lld.%04lld", digits, whole, rest / 10000, rest % 10000);
  return text.data();
}

}  // namespace

void AuxiliarySerial::ask(int bytes) {
  asked_ = bytes >= 1 && bytes <= kMaxAsked ? static_cast<std::size_t>(bytes) : 0;
  if (asked_ == 0) waiting_.clear();
}

void AuxiliarySerial::receive(const std::string& bytes) {
  waiting_ += bytes;
  if (waiting_.size() > kMaxWaiting) waiting_.erase(0, waiting_.size() - kMaxWaiting);
}

std::optional<AuxSerialPacket> AuxiliarySerial::take() {
  if (asked_ == 0 || waiting_.size() < asked_) return std::nullopt;
  AuxSerialPacket packet;
  packet.bytes.assign(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(asked_));
  waiting_.erase(0, asked_);
  asked_ = 0;
  return packet;
}

std::string ggaSentence(const GlobalPosition& position, Duration time) {
  const auto hundredths = std::chrono::duration_cast<std::chrono::milliseconds>(time).count() / 10;
  const long long day = (hundredths / 100) % kSecondsOfDay;
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(),
                "GPGGA,%02lld%02lld%02lld.%02lld,%s,%c,%s,%c,1,08,1.0,%.1f,M,0.0,M,,", day / 3600,
                day / 60 % 60, day % 60, static_cast<long long>(hundredths % 100),
                degreesAndMinutes(position.latitude, 2).c_str(), position.latitude < 0 ? 'S' : 'N',
                degreesAndMinutes(position.longitude, 3).c_str(), position.longitude < 0 ? 'W' : 'E',
                position.altitude);
  unsigned sum = 0;
  for (const char* at = text.data(); *at != '\0'; ++at) sum ^= static_cast<unsigned char>(*at);
  std::array<char, 8> end{};
  std::snprintf(end.data(), end.size(), "*%02X\r\n", sum);
  return "$" + std::string(text.data()) + end.data();
}

}  // namespace robotlink::arcos
