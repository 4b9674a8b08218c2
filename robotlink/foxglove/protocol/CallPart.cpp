// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/protocol/CallPart.h"

#include "robotlink/base/ParsedNumber.h"

namespace robotlink::websocket {
namespace {

constexpr std::string_view kPartPrefix = "part;";

/// Cuts off what is before the next semicolon.
std::optional<std::size_t> takeNumber(std::string_view& text) {
  const std::size_t end = text.find(';');
  if (end == std::string_view::npos) return std::nullopt;
  const auto number = parsedNumber<std::size_t>(text.substr(0, end));
  text.remove_prefix(end + 1);
  return number;
}

}  // namespace

std::string toEncoding(const CallPart& part) {
  return std::string(kPartPrefix) + std::to_string(part.offset) + ";" + std::to_string(part.total) + ";" +
         part.encoding;
}

std::optional<CallPart> callPartOf(std::string_view encoding) {
  if (!encoding.starts_with(kPartPrefix)) return std::nullopt;
  encoding.remove_prefix(kPartPrefix.size());
  const auto offset = takeNumber(encoding);
  const auto total = offset ? takeNumber(encoding) : std::nullopt;
  if (!total || *offset >= *total) return std::nullopt;
  return CallPart{*offset, *total, std::string(encoding)};
}

}  // namespace robotlink::websocket
