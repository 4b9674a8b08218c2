// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/streams/StreamPicker.h"

namespace app {

/// Selects the streams that are recorded. GUI thread.
class StreamChooser final : public widgets::StreamPicker {
  Q_OBJECT
 public:
  /// `streams`: the paths that exist now.
  StreamChooser(const robotcontrol::StreamSelection& selection, std::vector<std::string> streams,
                QWidget* parent);

 private:
  static Texts texts();
};

}  // namespace app
