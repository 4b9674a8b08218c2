// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>

#include "robotlink/base/Error.h"
#include "widgets/View.h"
#include "widgets/export/ExportPlan.h"
#include "widgets/export/FrameWriter.h"

namespace widgets {

class ExportClock;

/// Writes a view from one instant to another as a video or as a series of images. It moves what all views
/// show, and paints a copy of the view that is as large as the pictures and never on the screen, so that the
/// view itself may be resized, covered or closed meanwhile. Pictures are encoded in another thread.
///
/// tick() is called after the session's tick, the more often, the faster it goes. GUI thread; the context
/// must outlive it.
class ViewExport final : public QObject {
  Q_OBJECT
 public:
  /// The outcome of an export.
  struct Outcome {
    /// Whether all pictures were written.
    bool isDone = false;
    bool isCanceled = false;
    /// The text about what was written, or why not; for the user.
    QString text;
    /// The file or folder, where something of it is left; empty: nothing is.
    QString target;
  };

  explicit ViewExport(ViewContext& context, QObject* parent = nullptr);
  ~ViewExport() override;

  /// Begins to export a view of a kind that looks like `view`. Fails if something is wrong with the plan, or
  /// if another export is under way.
  robotlink::Result<void> start(const QString& kind, const View& view, const ExportPlan& plan);
  /// Paints and writes as many pictures as take no longer than a tick.
  void tick();
  /// Ends it; a video is removed, images that were written stay.
  void cancel();
  bool isBusy() const { return run_ != nullptr; }
  /// "Writing ball.mp4: 12 of 250 pictures".
  QString title() const;
  /// 0 to 1.
  double share() const;
  /// The outcome of the last export, once.
  std::optional<Outcome> takeOutcome();
  /// Whether a script has to wait; fails, once, with why the export has failed.
  robotlink::Result<bool> working();

  /// Replaces the look at the disk's free space, in tests.
  void setFreeSpace(FrameWriter::FreeSpace freeSpace) { freeSpace_ = std::move(freeSpace); }

 private:
  /// The data of one export.
  struct Run;
  enum class Step : std::uint8_t { kTime, kPicture, kWrite, kEnd };
  /// Does the next part of the work; false: it has to wait for another thread.
  bool advance();
  bool write();
  /// Ends the export.
  void end(Outcome outcome);
  void fail(const robotlink::Error& error);
  QString writtenText() const;

  ViewContext& context_;
  FrameWriter::FreeSpace freeSpace_;
  /// Null: nothing is exported.
  std::unique_ptr<Run> run_;
  std::optional<Outcome> outcome_;
  /// The failure that working() has not returned yet.
  std::optional<robotlink::Error> failure_;
};

}  // namespace widgets
