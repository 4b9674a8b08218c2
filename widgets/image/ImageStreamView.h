// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/process/Link.h"
#include "widgets/drawings/CurrentDrawings.h"
#include "widgets/picture/PictureView.h"

class QAction;
class QLabel;
class QSplitter;
class QToolBar;
namespace foxglove {
class RawImage;
}

namespace widgets {

class ImageCanvas;
class StreamSelector;

/// Shows any stream of images with the drawings that belong to it, chosen by name. Zoom, pan, color of the
/// pixel under the cursor; the picture can be frozen, copied and saved. Follows the session's timeline.
///
/// The stream is chosen by its path; "*/camera/image" stands for that of the session's selected robot.
/// Registered as "image". GUI thread.
class ImageStreamView final : public PictureView {
  Q_OBJECT
 public:
  explicit ImageStreamView(ViewContext& context, QWidget* parent = nullptr);
  ~ImageStreamView() override;

  /// Shows the newest image not later than the shown instant, and its drawings.
  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 private:
  /// Fit, freeze, and copying and saving without drawings.
  void createActions();
  void createViews();
  /// Time, pixel, state and zoom.
  QWidget* createFooter();
  void connectSignals();

  /// The robot of the chosen stream.
  std::string robot() const;
  /// The instant that is shown: the timeline's, or that of freezing.
  robotlink::Instant instant() const;
  /// Converts the image and passes it to the canvas.
  void showMessage();
  /// Updates time, state and zoom in the footer.
  void updateStatus();
  /// Updates the value of the pixel under the cursor.
  void updatePixel();
  /// Says how old the image is if nothing newer arrives; empty if it is current.
  QString staleText() const;
  /// Names of the classes that the image consists of; empty: it consists of colors.
  std::vector<std::string> classes() const;

  ImageCanvas* canvas_ = nullptr;
  StreamSelector* streams_ = nullptr;
  QLabel *time_ = nullptr, *pixel_ = nullptr, *state_ = nullptr, *zoom_ = nullptr;
  QAction *fit_ = nullptr, *oneToOne_ = nullptr, *freeze_ = nullptr;
  QAction *copyImage_ = nullptr, *saveImage_ = nullptr;

  /// The message that is shown, and the same as an image.
  robotlink::PackagePtr message_;
  std::shared_ptr<const foxglove::RawImage> image_;
  robotlink::Instant imageTime_;
  /// Unset: not frozen.
  std::optional<robotlink::Instant> frozenAt_;
  /// The drawings in the picture, to detect changes.
  std::vector<CurrentDrawing> shownDrawings_;
};

}  // namespace widgets
