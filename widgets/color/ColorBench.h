// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QObject>
#include <QUndoStack>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "colortool/samples/SampleDocument.h"
#include "colortool/table/CellSet.h"
#include "widgets/View.h"
#include "widgets/color/ColorLearner.h"

namespace widgets {

/// An image that the user put aside in the strip.
struct CollectedFrame {
  /// Never null.
  ColorFramePtr frame;
  /// 72 pixels high.
  QImage thumbnail;
};

/// A color table with which the trained one is compared: yesterday's, or another team's.
struct ReferenceTable {
  /// Null: there is none.
  std::shared_ptr<const colortool::ColorTable> table;
  /// The classes by which the table is numbered.
  colortool::ColorClasses classes;
  /// The name in views, such as the name of its file.
  QString name;
};

/// The state of the color tool, shared by all color views of a window: the samples with their undo stack (the
/// document), the image being worked on, the table trained from the samples and its segmentation of the
/// image, and the selection. Training and scoring happen in a ColorLearner's threads; their results arrive as
/// signals. GUI thread.
///
/// Files are handled by ColorFiles, sending the table to a robot by ColorSender; both are created where they
/// are needed first.
class ColorBench final : public QObject {
  Q_OBJECT
 public:
  /// Starts with the classes that fit the context's field, and without strokes. The context's session must
  /// outlive the bench.
  explicit ColorBench(const ViewContext& context, QObject* parent = nullptr);
  /// Waits for the learner's threads.
  ~ColorBench() override;

  /// Sets the field, whose colors decide which preset of classes a new document has; null: none. A document
  /// that has not been changed yet gets these classes at once.
  void setField(const robotlink::FieldDescription* field);

  /// The document: the current samples and their history.
  const colortool::Samples& samples() const { return document_.samples(); }
  const colortool::SampleDocument& document() const { return document_; }
  /// Mirrors the document's history, so that views can use Qt's undo actions.
  QUndoStack& undoStack() { return undo_; }
  /// Makes a step of the document's history, see SampleDocument::change(); every change goes through here.
  /// Steps of the same `gesture` are merged into one. Does nothing if `next` equals the samples.
  void change(const QString& text, colortool::Samples next, const std::string& gesture = {});
  /// Replaces the document; its history starts over. `changed`: it has unsaved changes.
  void setDocument(colortool::Samples samples, bool changed = false);
  /// The samples were saved as they are.
  void setSaved();
  /// The whole path of the samples' file; empty if there is none.
  const std::string& file() const { return file_; }
  void setFile(std::string file) { file_ = std::move(file); }

  /// Meaning of the next stroke: its class, an index into samples().classes; 0: background.
  int currentClass() const { return currentClass_; }
  /// Whether the next stroke says that its pixels are not of the class.
  bool mustNotBe() const { return mustNotBe_; }
  /// The next stroke's weight.
  double weight() const { return weight_; }
  /// Ignored if there is no such class.
  void setCurrentClass(int colorClass);
  void setMustNotBe(bool mustNotBe);
  /// Clamped to the limits of colortool::Stroke.
  void setWeight(double weight);
  /// Adds a stroke to the image. Calls with the same non-empty `gesture` continue one stroke: `area` is then
  /// that of the whole stroke so far. Ignored without an image.
  void addStroke(const colortool::PixelArea& area, const std::string& tool, const std::string& gesture = {});
  /// Removes the area from all strokes in the image; `gesture` as in addStroke().
  void erase(const colortool::PixelArea& area, const std::string& gesture = {});

  /// The image being worked on; null: none.
  const ColorFramePtr& frame() const { return frame_; }
  void setFrame(ColorFramePtr frame);
  /// The images that were put aside, in the order of the strip.
  const std::vector<CollectedFrame>& collected() const { return collected_; }
  /// Puts the current image aside unless it is there already; emits failed() if there is no room.
  void collect();
  /// Puts these images aside as long as there is room; those that are there already are skipped. Returns how
  /// many were added.
  std::size_t collect(const std::vector<ColorFramePtr>& frames);
  /// The maximum size of all images that are put aside, bytes of pixels.
  static constexpr std::size_t kMaxCollectedBytes = std::size_t{128} << 20U;
  void removeCollected(std::size_t index);

  /// The last result of training; its table, frame and classes belong together. Null before the first one.
  const LearnedColors* colors() const { return colors_ ? &*colors_ : nullptr; }
  /// The last score of a table; null before the first one. It arrives later than the table.
  const ColorQuality* quality() const { return quality_ ? &*quality_ : nullptr; }
  /// Whether colors() belongs to the newest samples and image.
  bool upToDate() const { return colors_ && colors_->task == asked_; }
  /// Colors in which the classes are shown, by class number; 0 is the background.
  std::vector<robotlink::Rgb> classColors() const;
  /// Sets the table to compare with, numbered by the classes of the samples; null: none.
  void setReference(std::shared_ptr<const colortool::ColorTable> table, const QString& name);
  /// Sets a table of any classes to compare with; classes are matched by their names.
  void setReference(ReferenceTable reference);
  /// The reference table renumbered to the samples' classes, also after these change; its other classes count
  /// as none. Null: there is no reference.
  const std::shared_ptr<const colortool::ColorTable>& reference() const { return reference_; }
  /// The reference table as it was set.
  const ReferenceTable& givenReference() const { return givenReference_; }
  const QString& referenceName() const { return givenReference_.name; }
  /// Images whose true classes are known; tables are scored with them.
  const std::vector<LabeledFrame>& labeled() const { return *labeled_; }
  void setLabeled(std::vector<LabeledFrame> labeled);

  /// Images spread over a log, on which tables are tried instead of on those that were seen; none: there is
  /// no log.
  void setLogImages(std::vector<ColorFramePtr> images);

  /// The selection: cells of the table. Image views highlight pixels of these colors, the color space view
  /// the cells.
  const colortool::CellSet& selection() const { return selection_; }
  /// False after clearSelection(); an empty selection is one, too.
  bool hasSelection() const { return selected_; }
  void select(const colortool::CellSet& cells);
  void clearSelection();
  /// The (corrected) color under the cursor in an image, so that other views mark it; unset: none.
  const std::optional<robotlink::YCbCr>& pointed() const { return pointed_; }
  void setPointed(const std::optional<robotlink::YCbCr>& color);

  robotlink::Session& session() const { return session_; }

 Q_SIGNALS:
  /// Classes, settings or strokes changed, also by undo and redo.
  void samplesChanged();
  /// Class, "must not be" or weight of the next stroke changed.
  void meaningChanged();
  /// frame() is another image.
  void frameChanged();
  /// A view asks to work on this image; null: on that of the timeline again. The view that chooses the images
  /// follows it.
  void frameWanted(const widgets::ColorFramePtr& frame);
  /// collected() changed.
  void collectedChanged();
  /// Table, segmented image or margins are new.
  void colorsChanged();
  /// quality() is new.
  void qualityChanged();
  /// reference() changed.
  void referenceChanged();
  /// Emitted when the user jumps to an image by time: frozen views have to follow the timeline again.
  void followWanted();
  /// The user wants to see the difference to the reference in the image.
  void differenceWanted();
  void selectionChanged();
  void pointedChanged();
  /// Something could not be done: what, and why.
  void failed(const QString& reason);
  /// Emitted when the last failed action has succeeded or was given up.
  void settled();

 private:
  /// Emitted after each change of the document.
  void changed();
  /// Renumbers the reference to the classes of the samples.
  void numberReference();
  /// Adds the current image to others_ if it is at least a second from those there.
  void rememberFrame();
  /// Gives the learner a new task.
  void ask();
  /// Takes the learner's results; called in the GUI thread.
  void takeNews();

  robotlink::Session& session_;
  colortool::SampleDocument document_;
  /// The classes of a new document.
  colortool::ColorClasses usual_;
  /// The file of the samples.
  std::string file_;
  QUndoStack undo_;
  int currentClass_ = 1;
  bool mustNotBe_ = false;
  double weight_ = 1;
  ColorFramePtr frame_;
  std::vector<CollectedFrame> collected_;
  /// Images that were seen, at least a second apart, at most twelve; the table is tried on them.
  std::vector<ColorFramePtr> others_;
  /// See setLogImages().
  std::vector<ColorFramePtr> logImages_;
  ReferenceTable givenReference_;
  std::shared_ptr<const colortool::ColorTable> reference_;
  /// The classes by which reference_ is numbered.
  colortool::ColorClasses referenceClasses_;
  std::shared_ptr<const std::vector<LabeledFrame>> labeled_;
  std::optional<LearnedColors> colors_;
  std::optional<ColorQuality> quality_;
  /// Number of the newest task.
  std::uint64_t asked_ = 0;
  colortool::CellSet selection_;
  bool selected_ = false;
  std::optional<robotlink::YCbCr> pointed_;
  /// Destroyed first, since its threads use the other members.
  std::unique_ptr<ColorLearner> learner_;
};

/// The bench of a window, created on the first call.
ColorBench& colorBench(ViewContext& context);

}  // namespace widgets
