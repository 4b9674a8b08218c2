// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonValue>
#include <QWidget>
#include <memory>
#include <optional>
#include <string>

#include "robotlink/base/Clock.h"
#include "robotlink/process/Link.h"

class QAction;
class QComboBox;
class QDoubleSpinBox;
class QSlider;
namespace foxglove {
class RawImage;
}
namespace robotlink {
class Session;
}

namespace widgets {

class StreamSelector;

/// Chooses a second image to compare with, and how: any stream of images (another camera, another robot, the
/// logged images of a robot whose program runs again), at the same time, at one shifted by some seconds, or
/// held while the first continues. A row of controls; object names begin with "imageCompare". GUI thread.
class CompareRow final : public QWidget {
  Q_OBJECT
 public:
  /// The way in which both images are shown. Part of saved states.
  enum class Mode : std::uint8_t { kSideBySide, kBlend, kDifference };

  explicit CompareRow(QWidget* parent);

  /// Chooses stream and mode, as the user does.
  void choose(const QString& stream, Mode mode);
  /// The stream to begin with, if none was chosen yet.
  void propose(const QString& choice);
  /// Lists the streams, and looks for the second image that belongs to a first one at `time`. True if it is
  /// another one than before.
  bool update(robotlink::Session& session, robotlink::Instant time);

  Mode mode() const;
  /// The share of the second image in a blend, 0 to 1.
  double share() const;
  /// The factor that differences are multiplied by, 1 to 16.
  int gain() const;
  /// Null if there is none at that time.
  const std::shared_ptr<const foxglove::RawImage>& image() const { return image_; }
  robotlink::Instant time() const { return time_; }
  /// Path of the stream; and the name of its robot as drawings know it: "red1", or "red1/logged".
  const std::string& path() const { return path_; }
  std::string robot() const;
  bool isHeld() const;

  /// The choices, as they are kept in the state of a view; restore() ignores what it does not know.
  QJsonValue save() const;
  void restore(const QJsonValue& state);

 Q_SIGNALS:
  /// Emitted when the images to compare, or the way, were chosen.
  void changed();

 private:
  void createControls();
  void connectSignals();
  /// Shows the slider's meaning for the mode.
  void showMode();

  StreamSelector* stream_ = nullptr;
  QComboBox* mode_ = nullptr;
  QSlider *blend_ = nullptr, *gain_ = nullptr;
  QDoubleSpinBox* shift_ = nullptr;
  QAction* hold_ = nullptr;
  bool isChosen_ = false;

  std::string path_;
  std::shared_ptr<const foxglove::RawImage> image_;
  robotlink::Instant time_;
};

/// "red1" for "red1/camera/image", "red1/logged" for "red1/logged/camera/image": what the robot is called
/// whose drawings belong to a stream.
std::string drawingRobot(const std::string& path);

}  // namespace widgets
