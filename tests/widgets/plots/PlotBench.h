// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QImage>

#include "robotcontrol/Motion.pb.h"
#include "tests/widgets/Bench.h"
#include "widgets/plots/PlotsView.h"

namespace widgets::test {

inline void pushPlot(Bench& bench, double time, double value) {
  robotcontrol::PlotValue plot;
  plot.set_value(value);
  plot.set_unit("m");
  bench.push("red1/plots/ball-model/position/x", plot, time);
}

inline void pushStatus(Bench& bench, double time, double x) {
  robotcontrol::MotionStatus status;
  status.mutable_velocity()->set_x(x);
  bench.push("red1/motion/status", status, time);
}

/// Draws what is pending: queued replots run in the event loop.
template <typename B>
QImage picture(B& bench, widgets::PlotsView& view) {
  for (int i = 0; i < 6; ++i) bench.tick(view);
  QCoreApplication::processEvents();
  return child<QWidget>(view, "plotCanvas").grab().toImage();
}

inline constexpr char kPlot[] = "red1/plots/ball-model/position/x";

}  // namespace widgets::test
