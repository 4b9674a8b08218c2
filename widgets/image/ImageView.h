// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/process/Link.h"
#include "widgets/View.h"
#include "widgets/drawings/CurrentDrawings.h"

class QAction;
class QLabel;
class QSplitter;
class QToolBar;
namespace foxglove {
class RawImage;
}

namespace widgets {

class DrawingsModel;
class ImageCanvas;
class StreamSelector;

/// Shows any stream of images with the drawings that belong to it, chosen by name. Zoom, pan, color of the
/// pixel under the cursor; the picture can be frozen, copied and saved. Follows the session's timeline.
///
/// The stream is chosen by its path; "*/camera/image" stands for that of the session's selected robot.
/// Registered as "image". GUI thread.
class ImageView final : public View {
  Q_OBJECT
 public:
  explicit ImageView(ViewContext& context, QWidget* parent = nullptr);
  ~ImageView() override;

  /// Shows the newest image not later than the shown instant, and its drawings.
  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

  /// Writes what is shown, or without drawings the pixels of the image in their own size, as PNG. False, with
  /// a message box, if that fails.
  bool savePicture(const QString& file, bool withDrawings);

 private:
  /// Zoom, freeze, drawings, copy and save.
  void createActions();
  void createViews();
  /// Choice of the stream, and buttons.
  QWidget* createToolRow();
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

  DrawingsModel* drawings_ = nullptr;
  ImageCanvas* canvas_ = nullptr;
  StreamSelector* streams_ = nullptr;
  QSplitter* splitter_ = nullptr;
  QLabel *time_ = nullptr, *pixel_ = nullptr, *state_ = nullptr, *zoom_ = nullptr;
  QAction *fit_ = nullptr, *oneToOne_ = nullptr, *zoomIn_ = nullptr, *zoomOut_ = nullptr;
  QAction *freeze_ = nullptr, *showDrawings_ = nullptr;
  QAction *copy_ = nullptr, *copyImage_ = nullptr, *save_ = nullptr, *saveImage_ = nullptr;

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
