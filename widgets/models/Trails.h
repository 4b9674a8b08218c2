// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <map>
#include <string>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"

namespace robotlink {
class StreamStore;
}

namespace widgets {

/// Where models were in the last ten seconds, a place each tenth of a second, from the history of the
/// transforms. Going on in time adds places; a jump of the instant that is shown looks them up anew. Field's
/// frame, metres. GUI thread.
class Trails {
 public:
  /// Names of models by the names of their frames, which are children of the field.
  using Frames = std::map<std::string, std::string>;
  using Places = std::map<std::string, std::deque<robotlink::Vector2>>;
  void update(const robotlink::StreamStore& store, const Frames& models, robotlink::Instant shown);
  void clear() { places_.clear(); }
  const Places& places() const { return places_; }

 private:
  void add(const robotlink::StreamStore& store, const Frames& models, robotlink::Instant at);

  Places places_;
  robotlink::Instant last_;
};

}  // namespace widgets
