// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>
#include <QToolButton>
#include <vector>

#include "tests/widgets/CameraBench.h"
#include "widgets/color/image/ColorCanvas.h"
#include "widgets/color/image/ColorImageView.h"

namespace widgets::test {

/// The view on a robot whose camera shows four quarters.
struct ShownColorImage {
  CameraBench world;
  ColorBench& bench{colorBench(world.context)};
  ColorImageView view{world.context};
  ColorCanvas* left = &child<ColorCanvas>(view, "colorLeft");
  ColorCanvas* right = &child<ColorCanvas>(view, "colorRight");

  ShownColorImage() {
    world.show();
    view.resize(900, 560);
    view.show();
    if (!QTest::qWaitForWindowExposed(&view)) qFatal("the view is not shown");
    view.tick();
    settle();
  }
  void settle() { QTRY_VERIFY(bench.upToDate()); }
  QPoint at(double x, double y, ColorCanvas* canvas = nullptr) {
    return (canvas == nullptr ? left : canvas)->toWidget({x + 0.5, y + 0.5}).toPoint();
  }
  void choose(const char* name) { bench.setCurrentClass(bench.samples().classes.index(name)); }
  void tool(const char* name) { test::click(child<QToolButton>(view, name)); }
  void drag(const std::vector<QPointF>& way, ColorCanvas* on = nullptr) {
    ColorCanvas* canvas = on == nullptr ? left : on;
    QTest::mousePress(canvas, Qt::LeftButton, {}, at(way.front().x(), way.front().y(), canvas));
    for (const QPointF& point : way) moveMouse(*canvas, at(point.x(), point.y(), canvas), Qt::LeftButton);
    QTest::mouseRelease(canvas, Qt::LeftButton, {}, at(way.back().x(), way.back().y(), canvas));
    settle();
  }
  void click(double x, double y, ColorCanvas* on = nullptr) { drag({{x, y}}, on); }
  QColor pixel(const ColorCanvas& canvas, double x, double y) {
    return canvas.rendered().pixelColor(canvas.toWidget({x + 0.5, y + 0.5}).toPoint());
  }
  QColor shownColor(const char* name) {
    const auto rgb = bench.samples().classes.shownColor(bench.samples().classes.index(name));
    return {rgb.r, rgb.g, rgb.b};
  }
  const colortool::Stroke& lastStroke() const { return *bench.samples().strokes.back(); }
};

}  // namespace widgets::test
