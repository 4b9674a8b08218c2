// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

#include "robotlink/config/FieldDescription.h"
#include "tests/widgets/FieldBench.h"
#include "widgets/scene/SceneCanvas.h"
#include "widgets/scene/SceneView.h"

namespace widgets::test {

/// Where placeThings() puts the ball's center.
inline const robotlink::Vector3 kBall(0.5, -0.4, 0.042);

/// A shown scene view with all of the field in sight.
struct ShownScene {
  FieldBench world;
  SceneView view{world.context};
  SceneCanvas* canvas = &child<SceneCanvas>(view, "sceneCanvas");

  ShownScene() {
    view.resize(480, 400);
    view.show();
    if (!QTest::qWaitForWindowExposed(&view)) qFatal("the view is not shown");
    QTest::keyClick(canvas, Qt::Key_R);  // all of the field, so that it is known where things are
  }
  /// What the camera needs to come to rest.
  void settle() {
    for (int i = 0; i < 120; ++i) view.tick();
  }
  /// Waits, at a true thread boundary, for the picture that shows what is there now.
  bool step() {
    world.advance();
    view.tick();
    return QTest::qWaitFor([this] { return canvas->upToDate(); }, 10000);
  }
  bool placeThings() {
    world.pushScene();
    world.pushPoses({-1, 0.5, 0.3}, {kBall.x(), kBall.y()});
    return step();
  }
  QPoint at(const robotlink::Vector3& place) const {
    return canvas->camera().project(canvas->size(), place)->toPoint();
  }
  QImage picture() const { return canvas->rendered(); }
  QColor colorAt(const robotlink::Vector3& place) const { return picture().pixelColor(at(place)); }
  QColor named(const char* name) const {
    const auto* color = world.context.field->color(name);
    return {color->r, color->g, color->b};
  }
  void click(const char* button) { test::click(view, button); }
};

/// How much two pictures differ: the share of pixels that are not near.
inline double pictureDifference(const QImage& a, const QImage& b) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) count += isNear(a.pixelColor(x, y), b.pixelColor(x, y), 8) ? 0 : 1;
  }
  return double(count) / (a.width() * a.height());
}

/// For initTestCase(): says what draws; false where nothing can.
inline bool sceneCanBeDrawn() {
  const auto renderer = SceneRenderer::create();
  if (!renderer) {
    qInfo("%s", renderer.error().text.c_str());
    return false;
  }
  qInfo("drawn by %s", renderer->device().c_str());
  return true;
}

}  // namespace widgets::test
