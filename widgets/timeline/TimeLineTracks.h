// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <memory>
#include <vector>

#include "robotlink/base/Error.h"
#include "widgets/timeline/TimeLineLayout.h"

namespace robotlink {
class Session;
}

namespace widgets {

class OpenLogs;

/// The values that a timeline shows as curves below its streams: of whole logs, which are read in the
/// background, or of live robots, including the part of their history that is read from disk. GUI thread;
/// session and logs must outlive it.
class TimeLineTracks {
 public:
  static constexpr int kMax = 12;
  /// Bound of the memory for the points of a live track.
  static constexpr std::size_t kMaxBytes = 16U << 20U;

  TimeLineTracks(robotlink::Session& session, OpenLogs& logs);
  ~TimeLineTracks();

  /// Adds a track of what PlotSource::fromText() reads; nothing happens if it is there. Fails if the text is
  /// wrong, if something is to be computed of the value, which plots do, or if there are kMax.
  robotlink::Result<void> add(const QString& source);
  void remove(const QString& source);
  /// The texts of all, in the order in which they were added.
  QStringList sources() const;
  /// Replaces all; texts that are wrong are left out.
  void setSources(const QStringList& sources);

  /// Takes what was read, or has arrived. `afresh`: where the history dropped some of it since the last call,
  /// the values are read again.
  void tick(bool afresh = false);
  std::vector<TimeLineTrack> shown() const;

 private:
  struct Track;
  /// Reads what of a track is on disk, and puts it before what has arrived.
  void readHistory(Track& track);
  /// Switches on the debug keys of streams that are not published, each once.
  void requestMissing(Track& track);

  robotlink::Session& session_;
  OpenLogs& logs_;
  std::vector<std::unique_ptr<Track>> tracks_;
};

}  // namespace widgets
