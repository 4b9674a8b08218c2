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
/// replaces one that has not begun. At most 30 pictures a second, and so many fewer that drawing takes no
/// more than 40 % of one core (90 % while somebody moves something); nothing at all while nothing is
/// requested.
///
/// The public functions may be called from the thread that made it. Its end waits for the picture that is
/// being drawn.
class RenderThread {
 public:
  using MakeRenderer = std::function<robotlink::Result<SceneRenderer>()>;
  struct Picture {
    QImage image;
    std::shared_ptr<const SceneFrame> frame;
  };

  /// `finished` is called from the thread when there is a picture to be taken or an error to be told; it must
  /// not wait.
  RenderThread(MakeRenderer makeRenderer, std::function<void()> finished);
  ~RenderThread();
  RenderThread(const RenderThread&) = delete;
  RenderThread& operator=(const RenderThread&) = delete;

  void request(std::shared_ptr<const SceneFrame> frame);
  /// The newest picture that was not taken yet.
  std::optional<Picture> take();
  /// Why there will never be a picture; empty if there will.
  std::string error() const;
  /// What draws; empty until the first picture.
  std::string device() const;

 private:
  using Clock = std::chrono::steady_clock;

  void run();
  /// Null when the thread shall end. Waits for a request, and until the last picture, begun at `start`, has
  /// been paid for.
  std::shared_ptr<const SceneFrame> next(Clock::time_point start, std::chrono::duration<double> cost);

  MakeRenderer makeRenderer_;
  std::function<void()> finished_;
  mutable std::mutex mutex_;  // protects all that follows but the thread
  std::condition_variable changed_;
  bool ending_ = false;
  std::shared_ptr<const SceneFrame> wanted_;
  std::optional<Picture> picture_;
  std::string error_, device_;
  std::thread thread_;
};

}  // namespace widgets
