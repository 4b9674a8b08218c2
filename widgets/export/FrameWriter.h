// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "robotlink/base/Error.h"
#include "robotlink/base/Worker.h"
#include "widgets/export/ExportPlan.h"

namespace widgets {

/// Writes the pictures of an export in a thread of its own, one while the next one is painted. Called by one
/// thread, that of the GUI. The destructor waits for the picture that is being written; without tryFinish()
/// nothing is left of a video, and the images that are complete stay.
class FrameWriter {
 public:
  using FreeSpace = std::function<std::uintmax_t(const std::filesystem::path& folder)>;
  /// `freeSpace`: see logplayer::VideoOutput; tests replace it.
  explicit FrameWriter(const ExportPlan& plan, FreeSpace freeSpace = {});
  ~FrameWriter();

  /// Takes the next picture, of any size; false, without taking it, while the one before is being written.
  bool tryWrite(const QImage& picture);
  /// Ends the file or series; false, without doing so, while a picture is being written.
  bool tryFinish();
  /// Whether all is complete.
  bool isFinished();
  /// The reason why it cannot be continued; unset: nothing is wrong.
  const std::optional<robotlink::Error>& problem();

 private:
  class Sink;
  class VideoSink;
  class ImageSink;
  struct Job {
    QImage picture;
    bool isEnd = false;
  };
  struct Written {
    std::optional<robotlink::Error> problem;
    bool isEnd = false;
  };
  /// Called in the thread.
  robotlink::Result<void> run(const Job& job);
  void take();

  const ExportPlan plan_;
  const FreeSpace freeSpace_;
  /// Used by the thread only: where pictures go, and the first failure, after which nothing is written.
  std::unique_ptr<Sink> sink_;
  std::optional<robotlink::Error> failed_;
  bool isFinished_ = false;
  std::optional<robotlink::Error> problem_;
  robotlink::Worker<Job, Written> worker_;
};

}  // namespace widgets
