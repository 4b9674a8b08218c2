// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "robotlink/foxglove/session/remote/SessionClient.h"

namespace app {

/// The streams of a server with their rates since the update before the last one, as text and as JSON.
class StreamList {
 public:
  using Stream = robotlink::websocket::SessionClient::Stream;

  /// `seconds` is the time of this update.
  void update(std::vector<Stream> streams, double seconds);
  bool has(const std::string& path) const;
  /// The path that may have been meant; empty: none is near.
  std::string near(const std::string& path) const;

  std::string text() const;
  std::string json(const std::string& url, const std::vector<std::string>& robots,
                   const std::string& state) const;

 private:
  struct Count {
    double seconds = 0;
    std::uint64_t messages = 0, bytes = 0;
  };
  struct Row {
    Stream stream;
    Count before;
    double rate = 0, bytesPerSecond = 0;
  };

  std::vector<Row> rows_;
  /// The counts of the topics at the last update.
  std::map<std::string, Count> counts_;
};

}  // namespace app
