// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/process/Link.h"
#include "widgets/View.h"
#include "widgets/models/CurrentDrawings.h"

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
class StreamChoice;

/// Shows any stream of images with the drawings that belong to it, chosen by name. Zoom, pan, colour of the
/// pixel under the cursor; the picture can be frozen, copied and saved. Follows the session's time line.
///
/// The stream is chosen by path; "*/camera/image" means that of the session's selected robot.
class ImageView final : public View {
  Q_OBJECT
 public:
  explicit ImageView(ViewContext& context, QWidget* parent = nullptr);
  ~ImageView() override;

  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

  /// Writes what is seen (or only the pixels of the image, in their own size) as PNG. False, with a message
  /// shown, if that fails.
  bool savePicture(const QString& file, bool withDrawings);

 private:
  void createActions();
  void createViews();
  QWidget* createToolRow();
  QWidget* createFooter();
  void connectSignals();

  std::string robot() const;
  robotlink::Instant instant() const;
  void showMessage();
  void updateStatus();
  void updatePixel();
  QString staleText() const;
  /// The names of the classes that the image consists of, if it does.
  std::vector<std::string> classes() const;

  DrawingsModel* drawings_ = nullptr;
  ImageCanvas* canvas_ = nullptr;
  StreamChoice* streams_ = nullptr;
  QSplitter* splitter_ = nullptr;
  QLabel *time_ = nullptr, *pixel_ = nullptr, *state_ = nullptr, *zoom_ = nullptr;
  QAction *fit_ = nullptr, *oneToOne_ = nullptr, *zoomIn_ = nullptr, *zoomOut_ = nullptr;
  QAction *freeze_ = nullptr, *showDrawings_ = nullptr;
  QAction *copy_ = nullptr, *copyImage_ = nullptr, *save_ = nullptr, *saveImage_ = nullptr;

  robotlink::PackagePtr message_;  ///< the image that is shown
  std::shared_ptr<const foxglove::RawImage> image_;
  robotlink::Instant imageTime_;
  std::optional<robotlink::Instant> frozenAt_;
  std::vector<CurrentDrawing> shownDrawings_;
};

}  // namespace widgets
