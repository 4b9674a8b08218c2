// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/session/StreamStore.h"

namespace widgets::test {

inline robotlink::Instant atSeconds(double seconds) {
  return robotlink::Instant(robotlink::fromSeconds(seconds));
}

/// A history that the test fills, for what reads a StreamStore without a session.
struct StoredMessages {
  template <typename T>
  void add(const std::string& path, double seconds, const T& message) {
    store.add({path, atSeconds(seconds), std::make_shared<const T>(message)});
  }
  /// A value of a stream of plot values, in m.
  void addPlot(const std::string& path, double seconds, double value) {
    robotcontrol::PlotValue plot;
    plot.set_value(value);
    plot.set_unit("m");
    add(path, seconds, plot);
  }

  robotlink::StreamStore store{{}};
};

}  // namespace widgets::test
