// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/export/TextLine.h"

#include <fmt/format.h>

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
  const std::string time = isDate(message.time) ? dateText(message.time)
                                                : fmt::format("{:12.6f}", robotlink::seconds(message.time));
  const std::string source =
      text.name().empty() ? message.path : message.path.substr(0, message.path.find('/')) + "/" + text.name();
  return fmt::format("{}  {:<7}  {}\n", time, levelText(text.level()),
                     robotlink::printableLines(source + ": " + text.message(), "    "));
}

}  // namespace logplayer
