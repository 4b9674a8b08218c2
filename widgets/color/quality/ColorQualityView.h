// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "colortool/scoring/Evaluation.h"

#include "widgets/View.h"
#include "widgets/color/ColorActions.h"
#include "widgets/color/LogImages.h"
#include "widgets/color/TrueClassFrames.h"

class QAction;
class QLabel;
class QSplitter;

namespace widgets {

class ColorBench;
class ConfusionPanel;
class LabeledFolder;

/// The quality of the table, always current: on the left by cross-validation over the user's strokes, on the
/// right over images whose classes are known, from a folder or from the simulator.
///
/// Registered as "color-quality". GUI thread.
class ColorQualityView final : public View {
  Q_OBJECT
 public:
  explicit ColorQualityView(ViewContext& context, QWidget* parent = nullptr);
  /// Waits for the image that is being read.
  ~ColorQualityView() override;
  /// Takes over images that were read, and asks the simulator for more.
  void tick() override;

 private:
  void createActions();
  void createViews();
  void connectSignals();
  /// Asks for a folder of labeled images and begins to read it.
  void openFolder();
  /// Takes over the images when they are read.
  void takeRead();
  /// Removes all labeled images.
  void closeImages();
  /// Updates both matrices.
  void showQuality();
  /// The matrix of the strokes.
  void showStrokes();
  /// The matrix of the labeled images.
  void showLabeled();
  /// The basis of the figures of the strokes, and what is missing.
  QString strokesNote() const;
  /// Number of labeled images and where they are from.
  QString countNote() const;
  /// Suspicious pixels in other images, and what is taken there of the background.
  QString othersNote() const;
  /// "83 % green, 2 % white": the classes with at least this share of all pixels, but for those left out.
  QString sharesOf(std::span<const std::uint64_t> pixels, std::uint64_t all, double min,
                   std::vector<bool> leftOut = {}) const;
  /// Notes which part of the pixels in other images a class covers, if that is most of them, and what classes
  /// take of the background's colors there; empty if there is nothing to report.
  QString othersBackgroundNote() const;
  /// Tries the table on images spread over the log from which the current image is.
  void followLog();
  /// Notes which part of the background is taken for a class that is no color of things, such as a wall for
  /// green; empty if that is next to nothing.
  QString backgroundNote(const colortool::Evaluation& evaluation) const;
  /// The figures of the reference table, and which of both is better; empty without a reference.
  QString referenceNote(const colortool::Evaluation& own,
                        const std::optional<colortool::Evaluation>& reference,
                        const std::vector<std::uint8_t>& alone) const;
  void say(const QString& text, bool bad = false);

  ColorBench& bench_;
  ColorActions history_;
  TrueClassFrames trueClasses_;
  /// The log whose images the table is tried on; unset: none.
  std::optional<LoggedImages> log_;
  /// Null: no images of a log are being read.
  std::unique_ptr<LogImages> logImages_;
  /// Null: no folder is being read.
  std::unique_ptr<LabeledFolder> reading_;
  /// The folder from which labeled images were last opened.
  QString folder_;
  QAction* open_ = nullptr;
  /// Whether labeled images are requested from the simulator.
  QAction* simulated_ = nullptr;
  QAction* close_ = nullptr;
  QSplitter* splitter_ = nullptr;
  ConfusionPanel* strokes_ = nullptr;
  ConfusionPanel* labeled_ = nullptr;
  QLabel* state_ = nullptr;
  /// The reason why there are no labeled images.
  QString problem_;
};

}  // namespace widgets
