// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "robotlink/base/Error.h"
#include "robotlink/foxglove/session/remote/SessionClientOptions.h"
#include "robotlink/session/Settings.h"

namespace robotlink::websocket {
class SessionClient;
}

namespace app {

/// The limits of a connection to remote robots. A plain value; the default is without limits.
struct LinkLimits {
  using Images = robotlink::websocket::RemoteImages;
  /// The rate at which the robot may send; 0: as much as the line takes.
  double bytesPerSecond = 0;
  Images images = Images::kAutomatic;
  /// The number of images of each stream that it may send per second; 0: all.
  double imagesPerSecond = 0;
  bool operator==(const LinkLimits&) const = default;
};

/// Returns the name of the coding of images in commands and options: "auto", "raw", "jpeg", "png".
const char* nameOf(LinkLimits::Images images);
std::optional<LinkLimits::Images> imagesNamed(const std::string& name);

/// For users: ", at most 2.0 MB/s, images as JPEG, 5 a second"; empty without limits.
std::string inWords(const LinkLimits& limits);

/// Limits a connection, also when it is reconnected.
void apply(const LinkLimits& limits, robotlink::websocket::SessionClient& client);

/// The limits that the user chose, by URL, kept in a file from one run of the workbench to the next. Any
/// thread.
class LinkLimitsMemory {
 public:
  explicit LinkLimitsMemory(std::filesystem::path file);

  /// The default if none were chosen for this URL.
  LinkLimits limits(const std::string& url) const;
  void choose(const std::string& url, const LinkLimits& limits);
  /// Increases with each change.
  std::uint64_t version() const;
  /// Writes the file if something was chosen since the last time. Fails once for each change.
  robotlink::Result<void> save();

 private:
  /// Protects the other members.
  mutable std::mutex mutex_;
  robotlink::Settings settings_;
  std::uint64_t version_ = 0, saved_ = 0;
};

}  // namespace app
