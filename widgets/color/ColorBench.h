// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QObject>
#include <QUndoStack>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "colortool/CellSet.h"
#include "colortool/SampleDocument.h"
#include "widgets/View.h"
#include "widgets/color/ColorLearner.h"

namespace widgets {

class ColorSender;

/// An image that the user put aside, to come back to it.
struct CollectedFrame {
  ColorFramePtr frame;
  QImage thumbnail;
};

/// A table that others are compared with: yesterday's, or another team's.
struct ReferenceTable {
  std::shared_ptr<const colortool::ColorTable> table;  ///< null: there is none
  colortool::ColorClasses classes;                     ///< what its numbers mean
  QString name;
};

/// The colour table that is being made, as all colour views of a window share it: the samples with their
/// undo stack, the image that is worked on, the table and what it makes of the image, what is selected. All
/// work is done by a ColorLearner; its results arrive as signals. GUI thread.
///
/// Files are ColorFiles' part, sending to a robot ColorSender's.
class ColorBench final : public QObject {
  Q_OBJECT
 public:
  explicit ColorBench(const ViewContext& context, QObject* parent = nullptr);
  ~ColorBench() override;

  // The document.
  const colortool::Samples& samples() const { return document_.samples(); }
  const colortool::SampleDocument& document() const { return document_; }
  QUndoStack& undoStack() { return undo_; }
  /// A step of the document's history, see SampleDocument::change(). Every change goes through here.
  void change(const QString& text, colortool::Samples next, const std::string& gesture = {});
  /// Another document; the history begins anew. `changed`: it is not saved yet.
  void setDocument(colortool::Samples samples, bool changed = false);
  void setSaved();

  // What strokes say.
  int currentClass() const { return currentClass_; }  ///< of samples().classes; 0: background
  bool mustNotBe() const { return mustNotBe_; }
  double weight() const { return weight_; }
  void setCurrentClass(int colorClass);
  void setMustNotBe(bool mustNotBe);
  void setWeight(double weight);
  /// In the image. What has a `gesture` continues the stroke before with the same one: the area is then that
  /// of the whole stroke.
  void addStroke(const colortool::PixelArea& area, const std::string& tool, const std::string& gesture = {});
  void erase(const colortool::PixelArea& area, const std::string& gesture = {});

  // The image that is worked on.
  const ColorFramePtr& frame() const { return frame_; }
  void setFrame(ColorFramePtr frame);
  const std::vector<CollectedFrame>& collected() const { return collected_; }
  /// Puts the image aside; nothing happens if it is there already.
  void collect();
  /// Puts these aside, as many as there is room for; those that are there already once. How many were put
  /// aside.
  std::size_t collect(const std::vector<ColorFramePtr>& frames);
  /// What all images that are put aside may take, bytes of pixels.
  static constexpr std::size_t kMaxCollectedBytes = std::size_t{128} << 20U;
  void removeCollected(std::size_t index);

  // What was learned.
  /// The last result; its table, frame and classes belong together. Null before the first.
  const LearnedColors* colors() const { return colors_ ? &*colors_ : nullptr; }
  const ColorQuality* quality() const { return quality_ ? &*quality_ : nullptr; }
  /// Whether what is shown is of the newest samples and image.
  bool upToDate() const { return colors_ && colors_->task == asked_; }
  /// In what classes are shown, by their numbers; 0 is background.
  std::vector<robotlink::Rgb> classColors() const;
  /// A table to compare with, of the classes of the samples; null: none.
  void setReference(std::shared_ptr<const colortool::ColorTable> table, const QString& name);
  /// The same of any classes; they are matched by their names.
  void setReference(ReferenceTable reference);
  /// In numbers of the samples' classes, also when these change; what they do not have is none. Null: there
  /// is none.
  const std::shared_ptr<const colortool::ColorTable>& reference() const { return reference_; }
  const ReferenceTable& givenReference() const { return givenReference_; }
  const QString& referenceName() const { return givenReference_.name; }
  /// Images whose classes are known; tables are scored with them.
  const std::vector<LabelledFrame>& labelled() const { return *labelled_; }
  void setLabelled(std::vector<LabelledFrame> labelled);

  // What is selected: cells of the table. Image views show pixels of these colours, the colour space the
  // cells.
  const colortool::CellSet& selection() const { return selection_; }
  bool hasSelection() const { return selected_; }
  void select(const colortool::CellSet& cells);
  void clearSelection();
  /// The colour that the cursor points to in an image, corrected, so that others show where it is; nothing:
  /// to none.
  const std::optional<robotlink::YCbCr>& pointed() const { return pointed_; }
  void setPointed(const std::optional<robotlink::YCbCr>& color);

  robotlink::Session& session() const { return session_; }
  ColorSender& sender() { return *sender_; }

 Q_SIGNALS:
  /// Classes, settings or strokes are others; also by undo and redo.
  void samplesChanged();
  void meaningChanged();  ///< class, "must not be" or weight of the next stroke
  void frameChanged();
  /// A view wants this image to be worked on: the one that chooses images holds it; null: that of the time
  /// line again.
  void frameWanted(const widgets::ColorFramePtr& frame);
  void collectedChanged();
  void colorsChanged();  ///< table, segmented image or margins
  void qualityChanged();
  void referenceChanged();
  void followWanted();      ///< somebody looks for images: views that are frozen go with the time line again
  void differenceWanted();  ///< somebody wants to see in the image what the reference has other
  void selectionChanged();
  void pointedChanged();
  /// Something could not be done: what, and why.
  void failed(const QString& reason);

 private:
  void changed();
  void numberReference();
  void rememberFrame();
  void ask();
  void takeNews();

  robotlink::Session& session_;
  colortool::SampleDocument document_;
  QUndoStack undo_;
  int currentClass_ = 1;
  bool mustNotBe_ = false;
  double weight_ = 1;
  ColorFramePtr frame_;
  std::vector<CollectedFrame> collected_;
  std::vector<ColorFramePtr> others_;  ///< that were seen, some time apart, to try the table on
  ReferenceTable givenReference_;
  std::shared_ptr<const colortool::ColorTable> reference_;
  colortool::ColorClasses referenceClasses_;  ///< that reference_ is numbered by
  std::shared_ptr<const std::vector<LabelledFrame>> labelled_;
  std::optional<LearnedColors> colors_;
  std::optional<ColorQuality> quality_;
  std::uint64_t asked_ = 0;
  colortool::CellSet selection_;
  bool selected_ = false;
  std::optional<robotlink::YCbCr> pointed_;
  ColorSender* sender_ = nullptr;          // a child
  std::unique_ptr<ColorLearner> learner_;  // last: it uses the others
};

/// That of a window; made when it is first asked for.
ColorBench& colorBench(ViewContext& context);

}  // namespace widgets
