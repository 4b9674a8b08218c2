// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "widgets/View.h"
#include "widgets/color/ColorCanvas.h"
#include "widgets/color/ColorFrame.h"

class QAction;
class QComboBox;
class QLabel;
class QMenu;
class QSplitter;

namespace widgets {

class ColorBench;
class ColorEffectRow;
class ColorStrip;
class ColorToolRow;
class StreamChoice;

/// Where colour tables are made: left an image of any stream (live, paused, or from the time line) or one
/// that was put aside, right what the table makes of it. Strokes are drawn in either of them; both show the
/// same part. Follows the session's time line; while a stroke is being drawn the image stays.
class ColorImageView final : public View {
  Q_OBJECT
 public:
  explicit ColorImageView(ViewContext& context, QWidget* parent = nullptr);
  ~ColorImageView() override;

  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// What the right picture shows.
  enum class RightLayer : std::uint8_t { kClasses, kReference, kDifference, kMargins };

  void createActions();
  void createPictureActions();
  void createViews();
  void openPictures(bool folder);
  QWidget* createStreamRow();
  QWidget* createFooter();
  void connectSignals();
  void connectCanvas(ColorCanvas* canvas, ColorCanvas* other);

  ColorFramePtr shownFrame();
  void showFrame();
  void showColors();
  void showMarks();
  void showSelection();
  void applyLayers();
  QImage rightImage() const;
  QString rightCaption() const;
  void showSending();
  void updateStatus();
  void updatePixel();
  QString marginText(std::size_t cell) const;

  void applyTool();
  void beginGesture(const QPointF& at);
  void moveGesture(const QPointF& at);
  void endGesture();
  void cancelGesture();
  void commitGesture();
  void showPreview();
  void openMenu(bool segmented, const QPoint& pixel, const QPoint& global);
  void addClassChoices(QMenu& menu, const colortool::PixelArea& area, const char* tool, bool mustNotBe);

  ColorBench& bench_;
  ColorCanvas *left_ = nullptr, *right_ = nullptr;
  ColorStrip* strip_ = nullptr;
  ColorToolRow* toolRow_ = nullptr;
  ColorEffectRow* effect_ = nullptr;
  StreamChoice* streams_ = nullptr;
  QSplitter* splitter_ = nullptr;
  QComboBox* rightLayer_ = nullptr;
  QLabel *time_ = nullptr, *state_ = nullptr, *pixel_ = nullptr, *zoom_ = nullptr;
  QAction *fit_ = nullptr, *oneToOne_ = nullptr, *zoomIn_ = nullptr, *zoomOut_ = nullptr;
  QAction *freeze_ = nullptr, *collect_ = nullptr, *twoPictures_ = nullptr, *showStrokes_ = nullptr;
  QAction *showStrip_ = nullptr, *openPictures_ = nullptr, *openFolder_ = nullptr;
  QAction *cancel_ = nullptr, *send_ = nullptr, *autoSend_ = nullptr;

  ColorFramePtr pinned_;  ///< one of the strip, instead of the stream's
  ColorLayers leftLayers_, rightLayers_;
  std::optional<ColorGesture> gesture_;
  std::uint64_t gestures_ = 0;  ///< so that each has a name of its own in the history
  std::optional<QPointF> cursor_;
};

}  // namespace widgets
