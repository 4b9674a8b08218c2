// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/file/LogFormat.h"

#include <string>
#include <string_view>

#include "robotlink/base/Registrations.h"

namespace logplayer {
namespace {

robotlink::Registry<LogFormat>& formats() {
  static robotlink::Registry<LogFormat> registered(
      +[](const LogFormat& a, const LogFormat& b) { return std::string_view(a.name) < b.name; });
  return registered;
}

}  // namespace

const std::vector<LogFormat>& registeredLogFormats() {
  return formats().all();
}

LogFormatRegistration::LogFormatRegistration(const LogFormat& format) {
  const std::string name = format.name == nullptr ? "" : format.name;
  const bool isWhole =
      !name.empty() && format.robot != nullptr && format.recognizes != nullptr && format.import != nullptr;
  formats().add(format, "log format \"" + name + "\"",
                isWhole ? "" : "it needs a name, a robot, and the functions 'recognizes' and 'import'");
}

}  // namespace logplayer
