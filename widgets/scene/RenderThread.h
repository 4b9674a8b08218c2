// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "widgets/scene/SceneFrame.h"
#include "widgets/scene/SceneRenderer.h"

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
  ~RenderThread();
  RenderThread(const RenderThread&) = delete;
  RenderThread& operator=(const RenderThread&) = delete;

  /// Replaces a request that has not begun.
  void request(std::shared_ptr<const SceneFrame> frame);
  /// The newest picture that was not taken yet.
  std::optional<Picture> take();
  /// Why there will never be a picture, because the renderer could not be created; empty: it could, or has
  /// not been tried.
  std::string error() const;
  /// The name of the renderer; empty until it was created.
  std::string device() const;

 private:
  using Clock = std::chrono::steady_clock;

  void run();
  /// Waits for a request and until the last picture, begun at `start`, no longer exceeds its share of the
  /// core. `cost`: its processor time. Null when the thread shall end.
  std::shared_ptr<const SceneFrame> next(Clock::time_point start, std::chrono::duration<double> cost);

  /// This and finished_ are used by the thread only.
  MakeRenderer makeRenderer_;
  std::function<void()> finished_;
  /// Protects all following members but the thread.
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool ending_ = false;
  std::shared_ptr<const SceneFrame> wanted_;
  std::optional<Picture> picture_;
  std::string error_, device_;
  std::thread thread_;
};

}  // namespace widgets
