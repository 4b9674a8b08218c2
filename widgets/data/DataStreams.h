// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "robotlink/session/StreamStore.h"

namespace widgets {

/// A stream that is published, or could be.
struct DataStream {
  std::string path;
  /// The debug key that must be switched on before it is published; empty: it is published.
  std::string key = {};
  bool operator==(const DataStream&) const = default;
};

/// Follows which streams a session has, including those that robots would publish if debug keys were on. GUI
/// thread.
class DataStreams {
 public:
  /// Returns whether something changed. Cheap if nothing did.
  bool update(const robotlink::StreamStore& store);
  /// Keyed by robot, whose name is empty for streams of the whole session; in natural order.
  const std::vector<std::pair<std::string, std::vector<DataStream>>>& robots() const { return robots_; }

 private:
  void list(const robotlink::StreamStore& store);
  /// Adds the streams of keys that are off.
  void addKeys(const robotlink::StreamStore& store, const std::string& robot,
               std::vector<DataStream>& streams) const;

  std::vector<std::pair<std::string, std::vector<DataStream>>> robots_;
  std::uint64_t listVersion_ = 0;
  /// The key tables of the robots that were examined.
  std::map<std::string, robotlink::PackagePtr> tables_;
};

}  // namespace widgets
