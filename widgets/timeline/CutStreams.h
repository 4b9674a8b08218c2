// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/base/StreamFilter.h"
#include "widgets/streams/StreamPicker.h"

namespace widgets {

/// Selects the streams of a new log. At first all are selected. GUI thread.
class CutStreams final : public StreamPicker {
  Q_OBJECT
 public:
  /// `paths`: the streams of the open logs.
  CutStreams(std::vector<std::string> paths, QWidget* parent);

  /// The selection; valid if the dialog was accepted.
  logplayer::StreamFilter filter() const;

 private:
  static Texts texts();
};

}  // namespace widgets
