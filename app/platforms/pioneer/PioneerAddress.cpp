// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/pioneer/PioneerAddress.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace app {
namespace {

namespace arcos = robotlink::arcos;
using robotlink::Result;
using Unit = arcos::SickSession::Unit;

constexpr std::string_view kLaser = "laser=";
constexpr std::array kLaserBauds{9600, 19200, 38400};

tl::unexpected<robotlink::Error> badOption(const std::string& address, const std::string& problem) {
  return robotlink::failure("url.bad", "'" + address + "' is not the address of a robot: " + problem, {},
                            {address});
}

/// The address before the options, and what the options are; "laser" ends them.
struct Parts {
  std::string line, options;
  std::optional<std::string> laser;
};

Parts split(const std::string& text) {
  Parts parts;
  const auto question = text.find('?');
  parts.line = text.substr(0, question);
  if (question == std::string::npos) return parts;
  parts.options = text.substr(question + 1);
  for (std::size_t at = 0; at != std::string::npos;) {
    if (parts.options.compare(at, kLaser.size(), kLaser) == 0) {
      parts.laser = parts.options.substr(at + kLaser.size());
      parts.options.resize(at > 0 ? at - 1 : 0);
      break;
    }
    const auto next = parts.options.find('&', at);
    at = next == std::string::npos ? next : next + 1;
  }
  return parts;
}

bool isKind(std::string_view name) {
  return !name.empty() && name.size() <= 40 && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  });
}

/// Applies an option; returns what is wrong with it, or an empty text.
std::string applyOption(PioneerAddress& address, std::string_view option) {
  const auto equals = option.find('=');
  const std::string_view name = option.substr(0, equals);
  const std::string_view value = equals == std::string_view::npos ? "" : option.substr(equals + 1);
  if (name == "robot") {
    address.kind = value;
    return isKind(value) ? "" : "robot= is followed by a kind of robot, such as p3dx";
  }
  if (name == "laser-step") {
    address.scans.halfDegrees = value == "0.5";
    return value == "0.5" || value == "1" ? "" : "laser-step is 1 or 0.5, in degrees";
  }
  if (name == "laser-unit") {
    address.scans.unit = value == "mm" ? Unit::kMillimeters : Unit::kCentimeters;
    return value == "cm" || value == "mm" ? "" : "laser-unit is cm or mm";
  }
  return "its options are baud, robot, laser-step, laser-unit, and laser as the last one; '" +
         std::string(name) + "' is not one of them";
}

/// The laser's line; a serial one without a speed has that of scans.
Result<arcos::StreamUrl> laserLine(const std::string& text, const std::string& all) {
  auto line = arcos::parseUrl(text);
  if (!line) return line;
  auto* serial = std::get_if<arcos::SerialAddress>(&*line);
  if (serial == nullptr) return line;
  if (text.find('?') == std::string::npos) serial->baud = kLaserBauds.back();
  if (std::ranges::find(kLaserBauds, serial->baud) == kLaserBauds.end())
    return badOption(all, "its laser's speed must be one of 9600, 19200, 38400 baud");
  return line;
}

}  // namespace

Result<PioneerAddress> PioneerAddress::parse(const std::string& text) {
  const Parts parts = split(text);
  PioneerAddress address;
  std::string line = parts.line;
  std::string_view rest = parts.options;
  while (!rest.empty()) {
    const auto end = rest.find('&');
    const std::string_view option = rest.substr(0, end);
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    // The only option of the line itself.
    if (option.starts_with("baud=")) {
      line += '?' + std::string(option);
    } else if (const std::string problem = applyOption(address, option); !problem.empty()) {
      return badOption(text, problem);
    }
  }
  auto parsed = arcos::parseUrl(line);
  if (!parsed) return tl::unexpected(parsed.error());
  address.line = *std::move(parsed);
  if (!parts.laser) return address;
  auto laser = laserLine(*parts.laser, text);
  if (!laser) return tl::unexpected(laser.error());
  if (*laser == address.line) return badOption(text, "the laser is at a line of its own, not at the robot's");
  if (const auto* serial = std::get_if<arcos::SerialAddress>(&*laser)) {
    address.scans.baud = serial->baud;
  } else {
    address.scans.fixedSpeed = true;
  }
  address.laser = *std::move(laser);
  return address;
}

std::string PioneerAddress::text() const {
  std::string options;
  if (kind != PioneerAddress().kind) options += "&robot=" + kind;
  if (laser && scans.halfDegrees) options += "&laser-step=0.5";
  if (laser && scans.unit == Unit::kMillimeters) options += "&laser-unit=mm";
  if (laser) options += '&' + std::string(kLaser) + toString(*laser);
  std::string result = toString(line);
  if (!options.empty() && result.find('?') == std::string::npos) options.front() = '?';
  return result + options;
}

}  // namespace app
