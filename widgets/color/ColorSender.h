// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <cstdint>
#include <memory>
#include <string>

#include "colortool/ColorTable.h"
#include "colortool/Samples.h"

namespace robotcontrol {
class ColorTable;
class RequestResult;
}  // namespace robotcontrol
namespace robotlink {
class Session;
}

namespace widgets {

class ColorBench;

/// Hands the learned table to the selected robot's program, whatever runs it, and makes sure that it arrived:
/// the robot tells the checksum of what it took over. GUI thread; the bench must outlive it.
class ColorSender final : public QObject {
  Q_OBJECT
 public:
  enum class State : std::uint8_t { kIdle, kSending, kConfirmed, kFailed };

  explicit ColorSender(ColorBench& bench);

  /// What was learned until now. While an answer is awaited nothing is sent; what came then follows.
  void send();
  /// Sends each new table by itself, as soon as the last one was confirmed.
  void setAutoSend(bool on);
  bool autoSend() const { return autoSend_; }

  State state() const { return state_; }
  /// Looks, as often as views tick, whether what was said of a failure is still true: another robot is
  /// selected, or the table is another one.
  void tick();
  /// For people: "red1 uses it (3f2a91bc)", or why not.
  const QString& text() const { return text_; }

 Q_SIGNALS:
  void changed();

 private:
  void sendNew();
  void describeSource(robotcontrol::ColorTable& table) const;
  void take(const robotcontrol::RequestResult& result);
  void tell(State state, const QString& text);

  ColorBench& bench_;
  bool autoSend_ = false;
  bool again_ = false;  // something newer waits
  State state_ = State::kIdle;
  QString text_;
  std::string robot_;           // that was sent to last
  std::uint64_t expected_ = 0;  // its checksum
  std::uint64_t asked_ = 0;     // counts what was sent
  std::shared_ptr<const colortool::ColorTable> sent_;
  QTimer patience_;
};

}  // namespace widgets
