// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace logplayer {

/// The other name of a robot: `from` and `to` are two names of each, in the same order. A robot that is not
/// among them keeps its name.
inline std::string renamedRobot(const std::string& robot, const std::vector<std::string>& from,
                                const std::vector<std::string>& to) {
  const auto found = std::find(from.begin(), from.end(), robot);
  const auto index = static_cast<std::size_t>(found - from.begin());
  return index < std::min(from.size(), to.size()) ? to[index] : robot;
}

/// A stream whose robot has another name, as in a session in which several logs have robots of one name:
/// "nao/camera/image" becomes "nao-2/camera/image".
inline std::string renamedStream(const std::string& stream, const std::vector<std::string>& from,
                                 const std::vector<std::string>& to) {
  const std::size_t slash = stream.find('/');
  if (slash == std::string::npos) return stream;
  return renamedRobot(stream.substr(0, slash), from, to) + stream.substr(slash);
}

}  // namespace logplayer
