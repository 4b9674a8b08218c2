// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QStringList>
#include <functional>
#include <initializer_list>
#include <string>

#include "robotlink/base/Clock.h"
#include "widgets/View.h"

class QAction;
class QHBoxLayout;
class QLabel;
class QSplitter;

namespace widgets {

class DrawingsModel;
class PoseMenu;

/// The shell of all views that show a picture: copying and saving it, zooming, the list of drawings or
/// another panel next to it, the splitter between both, and the part of the saved state that these need. A
/// derived view adds what it shows: its canvas, its own actions, tool rows and footer, and the state of
/// these.
///
/// Object names begin with the view's name: "field" gives fieldView, fieldSplitter, and the actions
/// fieldCopy, fieldCopyNumbers, fieldSave, fieldExport, fieldZoomIn, fieldZoomOut, fieldDrawings, fieldPose
/// (its menu is fieldPoseMenu), fieldFit, fieldFreeze. GUI thread.
class PictureView : public View {
  Q_OBJECT
 public:
  /// Writes the picture as PNG. False, with a message box that names the file, if that fails.
  bool savePicture(const QString& file);
  /// Writes the picture as PNG or SVG, or the view's numbers() as .csv or .txt, without a message box.
  robotlink::Result<void> saveTo(const QString& file) override;
  /// The canvas, without the panels next to it.
  QImage shownPicture() override { return rendered_(); }
  QSize shownPictureSize() const override;
  /// Checks or unchecks a drawing in the list, by its name with or without its kind, as a click does. Fails
  /// if the view has no such list, or no such drawing is in it.
  robotlink::Result<void> showDrawing(const std::string& name, bool shown);
  /// The names of the drawings in the list, without their kinds; empty without a list.
  QStringList drawingNames() const;
  /// Chooses at which pose the drawings relative to robots are placed: "default", or one of poseNames().
  /// Fails if the view has no such choice, or if no robot publishes such a pose estimate.
  robotlink::Result<void> choosePose(const std::string& pose);
  /// The true pose and the pose estimates that can be chosen; empty if the view has no such choice.
  QStringList poseNames() const;

 protected:
  /// The panel next to the picture.
  struct Side {
    QWidget* widget = nullptr;
    /// Shows and hides the widget, which begins as the action is checked; null: the derived view does that.
    QAction* toggle = nullptr;
    /// Initial width of the widget in pixels; 0: half of the view.
    int width = 0;
  };

  /// `name`: see above. `file`: name that is proposed for a saved picture.
  PictureView(ViewContext& context, const char* name, const char* file, QWidget* parent);

  /// Creates an action that shows the whole picture (F), and one that freezes it (H, checkable).
  QAction* makeFit(const QString& toolTip);
  QAction* makeFreeze();
  /// Creates the list of drawings of these kinds (see DrawingsModel) with the action that shows it (D).
  /// Call this at most once.
  Side makeDrawings(const QStringList& kinds);
  /// The model of that list; null without one.
  DrawingsModel* drawings() const { return drawings_; }
  /// Adds a button to a row that opens the menu of poses at which the drawings relative to robots are placed;
  /// the state keeps "pose". Call this at most once.
  void addPoses(QHBoxLayout* row);
  /// The pose menu; null if the view has none.
  PoseMenu* poses() const { return poses_; }

  /// Puts the rows, the canvas with the panel next to it, and the rows below together. Call this once. The
  /// state keeps "splitter" and, if there is a panel that can be hidden, "panel" and "drawings". The canvas
  /// is what is saved, copied and zoomed: it has rendered() and zoomBy().
  template <typename Canvas>
  void assemble(std::initializer_list<QWidget*> above, Canvas* canvas, const Side& side,
                std::initializer_list<QWidget*> below) {
    rendered_ = [canvas] { return canvas->rendered(); };
    zoomBy_ = [canvas](double factor) { canvas->zoomBy(factor); };
    canvas_ = canvas;
    place(above, canvas, side, below);
  }
  /// Offers copying, saving and exporting in the context menu of the canvas.
  void addToContextMenu(QWidget* canvas, std::initializer_list<QAction*> others = {});
  /// "12.345 s" since the origin of the session's timeline.
  QString timeText(robotlink::Instant time) const;
  /// Appends a label that takes the room that is left in a row, aligned to the right, and is cut there.
  static QLabel* addWideLabel(QHBoxLayout* row, const char* name, const QString& text);
  /// Appends such a label in a font in which all digits are equally wide.
  static QLabel* addFiguresLabel(QHBoxLayout* row, const char* name, const QString& text);

  QAction* copyAction() const { return copy_; }
  QAction* copyNumbersAction() const { return copyNumbers_; }
  QAction* saveAction() const { return save_; }
  QAction* zoomIn() const { return zoomIn_; }
  QAction* zoomOut() const { return zoomOut_; }

 private:
  void place(std::initializer_list<QWidget*> above, QWidget* canvas, const Side& side,
             std::initializer_list<QWidget*> below);
  /// Begins with the view's name.
  QByteArray named(const char* what) const { return name_ + what; }

  QByteArray name_;
  QString file_;
  std::function<QImage()> rendered_;
  std::function<void(double)> zoomBy_;
  QAction *copy_ = nullptr, *copyNumbers_ = nullptr, *save_ = nullptr, *zoomIn_ = nullptr,
          *zoomOut_ = nullptr;
  QAction* export_ = nullptr;
  QWidget* canvas_ = nullptr;
  DrawingsModel* drawings_ = nullptr;
  PoseMenu* poses_ = nullptr;
};

}  // namespace widgets
