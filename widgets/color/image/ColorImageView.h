// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "widgets/color/ColorFrame.h"
#include "widgets/color/image/ColorCanvas.h"
#include "widgets/picture/PictureView.h"

class QAction;
class QComboBox;
class QLabel;
class QMenu;

namespace widgets {

class ColorBench;
class ColorEffectRow;
class ColorStrip;
class ColorToolRow;
class StreamSelector;

/// The view in which color tables are made: on the left an image of any stream (live, paused, or from the
/// timeline) or a collected one, on the right its segmentation by the table, the reference, their difference,
/// or the margins. Strokes can be drawn in both; both show the same part of the image. Follows the session's
/// timeline, but not while a stroke is being drawn.
///
/// Registered as "color-image". GUI thread.
class ColorImageView final : public PictureView {
  Q_OBJECT
 public:
  explicit ColorImageView(ViewContext& context, QWidget* parent = nullptr);
  ~ColorImageView() override;

  /// Gives the bench the image of the timeline, unless a gesture is in progress, and updates the footer.
  void tick() override;
  /// Both pictures: a row for each pixel, with its color as the table sees it, and its class.
  std::optional<QString> numbers() override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// The contents of the right canvas.
  enum class RightLayer : std::uint8_t { kClasses, kReference, kDifference, kMargins };

  void createActions();
  /// Actions that open pictures and folders of pictures.
  void createPictureActions();
  void createViews();
  /// Asks for pictures, or for a folder of them, and reads them.
  void openPictures(bool folder);
  QWidget* createStreamRow();
  QWidget* createFooter();
  /// Adds the user's choices to the saved state.
  void keepChoices();
  void connectSignals();
  /// Connects the signals of one canvas; the other one gets its viewport and cursor.
  void connectCanvas(ColorCanvas* canvas, ColorCanvas* other);

  /// The image that should be shown now; null: none.
  ColorFramePtr shownFrame();
  /// Shows the bench's image.
  void showFrame();
  /// Shows the bench's table and segmentation, unless they belong to another image.
  void showColors();
  /// Updates the outlines of the strokes.
  void showMarks();
  /// Updates the shade that highlights the selection.
  void showSelection();
  /// The image as the table sees it, with its camera's correction; without it as long as that is being made.
  /// There must be an image.
  robotlink::ImageView seen() const;
  /// Passes the layers to both canvases.
  void applyLayers();
  /// The image for the chosen RightLayer.
  QImage rightImage() const;
  QString rightCaption() const;
  /// Shows whether the robot uses the table.
  void showSending();
  /// Updates time and state in the footer.
  void updateStatus();
  /// Updates color, class and margin of the pixel under the cursor.
  void updatePixel();
  /// The certainty of the table in a cell; empty: unknown.
  QString marginText(std::size_t cell) const;

  /// Passes the tool to both canvases.
  void applyTool();
  /// Begins, continues, ends or cancels a gesture; positions in the image.
  void beginGesture(const QPointF& at);
  void moveGesture(const QPointF& at);
  void endGesture();
  void cancelGesture();
  /// Applies the gesture to the bench: strokes, erases or selects.
  void commitGesture();
  /// Shows the gesture's outline.
  void showPreview();
  /// Context menu of a pixel; `segmented`: of the right canvas.
  void openMenu(bool segmented, const QPoint& pixel, const QPoint& global);
  /// Adds an entry per class, which makes a stroke of the area.
  void addClassChoices(QMenu& menu, const colortool::PixelArea& area, const char* tool, bool mustNotBe);

  ColorBench& bench_;
  ColorCanvas *left_ = nullptr, *right_ = nullptr;
  ColorStrip* strip_ = nullptr;
  ColorToolRow* toolRow_ = nullptr;
  ColorEffectRow* effect_ = nullptr;
  StreamSelector* streams_ = nullptr;
  QComboBox* rightLayer_ = nullptr;
  QLabel *time_ = nullptr, *state_ = nullptr, *pixel_ = nullptr, *zoom_ = nullptr;
  QAction *fit_ = nullptr, *oneToOne_ = nullptr, *freeze_ = nullptr, *collect_ = nullptr,
          *twoPictures_ = nullptr, *showStrokes_ = nullptr;
  QAction *showStrip_ = nullptr, *openPictures_ = nullptr, *openFolder_ = nullptr;
  QAction *cancel_ = nullptr, *send_ = nullptr, *autoSend_ = nullptr;

  /// A collected image that is shown instead of the stream's; null: none.
  ColorFramePtr pinned_;
  ColorLayers leftLayers_, rightLayers_;
  /// The gesture in progress.
  std::optional<ColorGesture> gesture_;
  /// Number of gestures, so that each has its own name in the history.
  std::uint64_t gestures_ = 0;
  /// Cursor in the image.
  std::optional<QPointF> cursor_;
};

}  // namespace widgets
