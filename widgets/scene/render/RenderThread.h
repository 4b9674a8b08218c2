// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "robotlink/base/Worker.h"
#include "widgets/scene/render/SceneFrame.h"
#include "widgets/scene/render/SceneRenderer.h"

namespace widgets {

/// Draws scenes in a thread of its own, so that the GUI never waits for a picture. Latest wins: a request
/// replaces one that has not begun. At most 30 pictures per second, and fewer if drawing would take more than
/// 40 % of one core (90 % while the user moves something). The thread sleeps while nothing is requested.
///
/// All functions are called by the thread that made it. The destructor waits for the picture that is being
/// drawn.
class RenderThread {
 public:
  /// Creates the renderer; called once, in the drawing thread.
  using MakeRenderer = std::function<robotlink::Result<SceneRenderer>()>;
  /// A picture and the request that it shows.
  struct Picture {
    QImage image;
    std::shared_ptr<const SceneFrame> frame;
  };

  /// `finished` is called in the drawing thread when there is a picture to take, or an error; it must not
  /// block.
  RenderThread(MakeRenderer makeRenderer, std::function<void()> finished);

  /// Replaces a request that has not begun.
  void request(std::shared_ptr<const SceneFrame> frame) { worker_.post(std::move(frame)); }
  /// The newest picture that was not taken yet.
  std::optional<Picture> take() { return worker_.take(); }
  /// Says why there will never be a picture, since the renderer could not be created; empty: it could, or has
  /// not been tried.
  std::string error() const;
  /// The name of the renderer; empty until it was created.
  std::string device() const;

 private:
  using Request = std::shared_ptr<const SceneFrame>;
  using Drawing = robotlink::Worker<Request, Picture>;

  void create(const MakeRenderer& makeRenderer);
  void draw(Request frame);
  /// The time from which on the last picture no longer exceeds its share of the core.
  Drawing::Clock::time_point due(const Request& frame) const;

  /// These are used by the drawing thread only: unset without a renderer; when the last picture was begun,
  /// and its processor time.
  std::optional<SceneRenderer> renderer_;
  Drawing::Clock::time_point start_;
  std::chrono::duration<double> cost_{};
  const std::function<void()> finished_;
  /// Protects error_ and device_.
  mutable std::mutex mutex_;
  std::string error_, device_;
  Drawing worker_;
};

}  // namespace widgets
