// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/export/TextLine.h"

#include <array>
#include <cstdio>

#include "foxglove/Robot.pb.h"
#include "logplayer/base/LogDates.h"
#include "robotlink/base/Printable.h"

namespace logplayer {
namespace {

const char* levelText(foxglove::Log::Level level) {
  switch (level) {
    case foxglove::Log::DEBUG:
      return "debug";
    case foxglove::Log::INFO:
      return "info";
    case foxglove::Log::WARNING:
      return "warning";
    case foxglove::Log::ERROR:
      return "error";
    case foxglove::Log::FATAL:
      return "fatal";
    default:
      return "-";
  }
}

}  // namespace

std::string textLine(const robotlink::StreamMessage& message, const foxglove::Log& text) {
  std::array<char, 64> head{};
  std::snprintf(head.data(), head.size(), "%12.6f", robotlink::seconds(message.time));
  const std::string time = isDate(message.time) ? dateText(message.time) : head.data();
  std::snprintf(head.data(), head.size(), "  %-7s  ", levelText(text.level()));
  const std::string source =
      text.name().empty() ? message.path : message.path.substr(0, message.path.find('/')) + "/" + text.name();
  return time + head.data() + robotlink::printableLines(source + ": " + text.message(), "    ") + "\n";
}

}  // namespace logplayer
