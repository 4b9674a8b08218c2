// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <string>

#include "robotlink/foxglove/client/ConnectionState.h"

namespace app {

/// Asks whether a remote robot is the intended one, by the fingerprint of its certificate. A new
/// robot is trusted by a click; one that shows another certificate than before only after a tick that says
/// what the user knows. Accepted: it is trusted. GUI thread.
class TrustDialog final : public QDialog {
  Q_OBJECT
 public:
  TrustDialog(const std::string& url, const robotlink::websocket::ServerObjection& objection,
              QWidget* parent = nullptr);

 private:
  void addText(const char* name, const QString& text);
  void addFingerprints(const robotlink::websocket::ServerObjection& objection);
  void addButtons(bool isNew);
};

}  // namespace app
