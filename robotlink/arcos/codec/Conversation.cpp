// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/codec/Conversation.h"

#include <cmath>
#include <cstdio>
#include <optional>

#include "robotlink/arcos/codec/PacketParser.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/ParsedNumber.h"
#include "robotlink/base/TextParts.h"

namespace robotlink::arcos {
namespace {

using Event = Conversation::Event;
using EventKind = Conversation::Kind;

constexpr std::string_view kNewConnection = "=== new connection";
constexpr std::string_view kClosed = "client closed";
constexpr std::string_view kFromClient = "C>S";
constexpr std::string_view kFromRobot = "S>C";
/// Larger times are errors; smaller ones are exact in ns.
constexpr double kMaxMs = 1e12;
/// Smaller times are written as 0.
constexpr double kMinMs = 0.05;

std::string_view takeWord(std::string_view& text) {
  const std::size_t end = std::min(text.find(' '), text.size());
  const std::string_view word = text.substr(0, end);
  text = trimmed(text.substr(end));
  return word;
}

int digitOf(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::optional<Bytes> bytesOf(std::string_view hex) {
  if (hex.empty() || hex.size() % 2 != 0) return std::nullopt;
  Bytes bytes;
  bytes.reserve(hex.size() / 2);
  for (std::size_t i = 0; i < hex.size(); i += 2) {
    const int high = digitOf(hex[i]);
    const int low = digitOf(hex[i + 1]);
    if (high < 0 || low < 0) return std::nullopt;
    bytes.push_back(static_cast<std::uint8_t>(high * 16 + low));
  }
  return bytes;
}

/// Whether the bytes are one packet: header, count and, if `checked`, checksum.
bool isFrame(const Bytes& bytes) {
  return bytes.size() >= 6 && bytes[0] == kHeader1 && bytes[1] == kHeader2 && bytes[2] + 3U == bytes.size();
}

/// The part of a line between direction and bytes: "id=0(0x00) len=3 ck=ok", or "damage=5".
std::string wordsOf(const Bytes& bytes) {
  char text[64];
  if (!isFrame(bytes)) {
    std::snprintf(text, sizeof text, "damage=%zu", bytes.size());
    return text;
  }
  const std::uint16_t sum = checksum(std::span(bytes).subspan(3, bytes.size() - 5));
  const bool good = sum == ((bytes[bytes.size() - 2] << 8U) | bytes[bytes.size() - 1]);
  std::snprintf(text, sizeof text, "id=%d(0x%02x) len=%d ck=%s", bytes[3], static_cast<unsigned>(bytes[3]),
                bytes[2], good ? "ok" : "bad");
  return text;
}

/// In ms, as far as it is written: what is rounded to zero is no "-0.0", which would be read as 0.
double writtenMs(robotlink::Duration at) {
  const double ms = std::chrono::duration<double, std::milli>(at).count();
  return std::abs(ms) < kMinMs ? 0 : ms;
}

/// The event of a line, or a sentence about the error.
tl::expected<Event, std::string> readEvent(std::string_view line) {
  if (line == kNewConnection) return Event{EventKind::kNewConnection, {}, {}, {}};
  const std::string_view time = takeWord(line);
  const auto ms = parsedNumber<double>(time);
  if (!ms || !(std::abs(*ms) <= kMaxMs)) {
    return tl::unexpected("expected '" + std::string(kNewConnection) + "' or a time in ms, not '" +
                          std::string(time.substr(0, 40)) + "'");
  }
  Event event{EventKind::kClosed, std::chrono::microseconds(std::llround(*ms * 1000)), {}, {}};
  if (line == kClosed) return event;

  event.kind = EventKind::kPacket;
  const std::string_view direction = takeWord(line);
  if (direction != kFromClient && direction != kFromRobot) {
    return tl::unexpected(std::string("expected 'C>S', 'S>C' or 'client closed' after the time"));
  }
  event.direction = direction == kFromClient ? Direction::kFromClient : Direction::kFromRobot;
  const std::size_t last = line.rfind(' ');
  auto bytes = bytesOf(last == std::string_view::npos ? line : line.substr(last + 1));
  if (!bytes)
    return tl::unexpected(
        std::string("expected the packet's bytes, two hexadecimal digits each, at the end"));
  event.bytes = std::move(*bytes);
  const std::string_view said = last == std::string_view::npos ? "" : trimmed(line.substr(0, last));
  if (const std::string words = wordsOf(event.bytes); said != words) {
    return tl::unexpected("the line says '" + std::string(said.substr(0, 60)) + "', but its bytes are '" +
                          words + "'");
  }
  return event;
}

}  // namespace

Result<Conversation> readConversation(std::string_view text, const std::string& path) {
  Conversation conversation;
  for (int number = 1; !text.empty(); ++number) {
    const std::string_view line = trimmed(takeLine(text));
    if (line.empty() || line.front() == '#') continue;
    auto event = readEvent(line);
    if (!event) return failure("arcos.bad-conversation", std::move(event.error()), {path, number, 0});
    conversation.events.push_back(std::move(*event));
  }
  return conversation;
}

Result<Conversation> readConversationFile(const std::filesystem::path& file) {
  const auto text = readFile(file, kMaxConversationBytes);
  if (!text) return tl::unexpected(text.error());
  return readConversation(*text, file.string());
}

std::string writeEvent(const Event& event) {
  if (event.kind == EventKind::kNewConnection) return std::string(kNewConnection) + '\n';
  char time[40];
  std::snprintf(time, sizeof time, "%9.1f ", writtenMs(event.at));
  std::string line = time;
  if (event.kind == EventKind::kClosed) return line.append(kClosed) + '\n';
  line += event.direction == Direction::kFromClient ? kFromClient : kFromRobot;
  return line + ' ' + wordsOf(event.bytes) + ' ' + toHex(event.bytes) + '\n';
}

std::string writeConversation(const Conversation& conversation) {
  std::string text;
  for (const Event& event : conversation.events) text += writeEvent(event);
  return text;
}

}  // namespace robotlink::arcos
