// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/codec/Command.h"

#include <algorithm>
#include <cstdlib>

#include "robotlink/arcos/codec/ArcosCommandCatalog.h"

namespace robotlink::arcos {
namespace {

/// The types of arguments; an integer's magnitude follows.
constexpr std::uint8_t kPositive = 0x3B;
constexpr std::uint8_t kNegative = 0x1B;
constexpr std::uint8_t kString = 0x2B;
/// The longest string that fits into a frame with its type and length.
constexpr std::size_t kMaxString = kMaxData - 2;

void writeInteger(int value, Bytes& data) {
  value = std::clamp(value, -kMaxArgument, kMaxArgument);
  const auto magnitude = static_cast<unsigned>(std::abs(value));
  data = {value < 0 ? kNegative : kPositive, static_cast<std::uint8_t>(magnitude & 0xFFU),
          static_cast<std::uint8_t>(magnitude >> 8U)};
}

/// Writes the length, the bytes, and a NUL that is not included in the length.
void writeString(const std::string& text, std::size_t extra, Bytes& data) {
  const std::size_t length = std::min(text.size(), kMaxString);
  data = {kString, static_cast<std::uint8_t>(length)};
  data.insert(data.end(), text.begin(), text.begin() + static_cast<std::ptrdiff_t>(length));
  if (data.size() + extra < kMaxData) data.push_back(0);
}

void readInteger(std::span<const std::uint8_t> data, Command& command) {
  const int low = data.size() > 1 ? data[1] : 0;
  const int high = data.size() > 2 ? data[2] : 0;
  const int magnitude = low | (high << 8);
  command.argument = data[0] == kNegative ? -magnitude : magnitude;
  if (data.size() > 3) command.extra.assign(data.begin() + 3, data.end());
}

Result<void> readString(std::span<const std::uint8_t> data, Command& command) {
  std::span<const std::uint8_t> text = data.subspan(1);
  std::span<const std::uint8_t> extra;
  if (!text.empty() && text[0] < text.size()) {
    const std::size_t length = text[0];
    extra = text.subspan(1 + length);
    text = text.subspan(1, length);
    if (!extra.empty() && extra[0] == 0) extra = extra.subspan(1);
  } else {
    // Some clients send no length, only a final NUL.
    if (!text.empty() && text.back() == 0) text = text.first(text.size() - 1);
    if (text.size() > kMaxString) {
      return failure("arcos.long-string",
                     nameOf(command.id) + " has a string of " + std::to_string(text.size()) +
                         " bytes without its length; at most " + std::to_string(kMaxString) + " can be");
    }
  }
  command.argument = std::string(text.begin(), text.end());
  command.extra.assign(extra.begin(), extra.end());
  return {};
}

}  // namespace

int integerArgument(const Command& command, int without) {
  const int* value = std::get_if<int>(&command.argument);
  return value ? *value : without;
}

std::string stringArgument(const Command& command) {
  const auto* text = std::get_if<std::string>(&command.argument);
  return text ? *text : std::string();
}

int joined(BytePair pair) {
  const auto bits = static_cast<std::uint16_t>((static_cast<std::uint8_t>(pair.high) << 8U) |
                                               static_cast<std::uint8_t>(pair.low));
  return static_cast<std::int16_t>(bits);
}

BytePair split(int argument) {
  const auto bits = static_cast<unsigned>(argument);
  return {static_cast<std::int8_t>((bits >> 8U) & 0xFFU), static_cast<std::int8_t>(bits & 0xFFU)};
}

Result<void> check(const Command& command) {
  const std::string name = nameOf(command.id);
  if (const int* value = std::get_if<int>(&command.argument)) {
    if (*value < -kMaxArgument || *value > kMaxArgument) {
      return failure("arcos.bad-argument", "the argument of " + name + " is " + std::to_string(*value) +
                                               "; it must be between -65535 and 65535");
    }
  }
  const auto* text = std::get_if<std::string>(&command.argument);
  if (text && text->size() > kMaxString) {
    return failure("arcos.long-string", name + " has a string of " + std::to_string(text->size()) +
                                            " bytes; send at most " + std::to_string(kMaxSentString) +
                                            " at once");
  }
  const Packet packet = toPacket(command);
  if (packet.count() > kMaxSentCount || command.extra.size() > kMaxSentData) {
    return failure("arcos.long-command", name + " is longer than the " + std::to_string(kMaxSentCount) +
                                             " bytes that robots take; send less at once");
  }
  return {};
}

Packet toPacket(const Command& command) {
  Packet packet{command.id, {}};
  const std::size_t extra = std::min(command.extra.size(), kMaxData);
  if (const int* value = std::get_if<int>(&command.argument)) writeInteger(*value, packet.data);
  if (const auto* text = std::get_if<std::string>(&command.argument)) writeString(*text, extra, packet.data);
  const std::size_t fitting = std::min(extra, kMaxData - packet.data.size());
  packet.data.insert(packet.data.end(), command.extra.begin(),
                     command.extra.begin() + static_cast<std::ptrdiff_t>(fitting));
  return packet;
}

Result<Command> toCommand(const Packet& packet) {
  Command command{packet.id, {}};
  const std::uint8_t type = packet.data.empty() ? std::uint8_t{0} : packet.data[0];
  if (type == kPositive || type == kNegative) {
    readInteger(packet.data, command);
  } else if (type == kString) {
    if (auto read = readString(packet.data, command); !read) return tl::unexpected(read.error());
  } else {
    command.extra = packet.data;
  }
  return command;
}

}  // namespace robotlink::arcos
