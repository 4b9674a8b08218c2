// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "foxglove/Image.pb.h"
#include "robotlink/base/Error.h"
#include "robotlink/base/Worker.h"
#include "robotlink/calibration/CameraCalibration.h"
#include "widgets/PackageSubscription.h"
#include "widgets/camera/BoardViews.h"
#include "widgets/camera/MarkModel.h"
#include "widgets/picture/PictureView.h"

class QLabel;
class QTabWidget;

namespace widgets {

class ImageCanvas;
class LensPanel;
class ParameterEdits;
class PlacePanel;
class SettingsPanel;
class StreamSelector;

/// Calibrates the camera of a stream of images: its lens by several views of a chessboard, its place by a
/// board on the ground or by marks of the field that are clicked. The results become parameters of the
/// robot's solution of camera-pose. Boards are looked for, and cameras computed, in threads of the view. It
/// also changes the settings of the camera, such as its exposure, while it takes images.
///
/// Registered as "camera". GUI thread.
class CalibrationView final : public PictureView {
  Q_OBJECT
 public:
  explicit CalibrationView(ViewContext& context, QWidget* parent = nullptr);
  ~CalibrationView() override;

  void tick() override;

 protected:
  /// Clicks in the picture pick marks.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  using Corners = BoardViews::Corners;
  /// A board to be looked for.
  struct Search {
    std::shared_ptr<const foxglove::RawImage> image;
    robotlink::Chessboard board;
  };
  struct Found {
    Search search;
    robotlink::Result<std::optional<Corners>> corners;
  };
  /// The computation that is requested: a lens, or a place from a board or from points.
  struct Question {
    std::optional<BoardViews> lens = {};
    robotlink::LensModel knownLens = {};
    robotlink::Chessboard board = {};
    Corners corners = {};
    std::vector<robotlink::Vector3> points = {};
    std::vector<robotlink::Vector2> pixels = {};
  };
  struct Answer {
    std::optional<robotlink::Result<robotlink::LensFit>> lens = {};
    std::optional<robotlink::Result<robotlink::PlaceFit>> place = {};
  };

  QTabWidget* createTabs();
  void connectSignals();
  void keepChoices();
  void followField();
  bool shows(const QWidget* panel) const;
  /// Whether marks are clicked, and whether boards are looked for.
  bool picksMarks() const;
  bool looksForBoard() const;
  /// Follows the robot, and asks for what is shown.
  void subscribe();
  void setCamera(const QString& setting, double value);
  /// Shows the newest image with what was found and picked in it.
  void showImage();
  /// In the threads of the view.
  void search(Search wanted);
  void compute(const Question& asked);
  void takeFound();
  void takeAnswer();
  /// Adds what is seen now to the views.
  void takeView();
  void fitLens();
  void placeByBoard();
  void placeByMarks();
  /// The lens that was computed, or one with the field of view that the robot states; nothing: neither.
  std::optional<robotlink::LensModel> lens() const;
  void pickAt(const QPointF& canvas);
  /// Sets those of the parameters that the robot's solution of camera-pose has.
  void useAsParameters(const std::map<std::string, double>& values, QLabel& outcome);
  /// The robot of the chosen stream.
  std::string robot() const;
  QString hint() const;

  ImageCanvas* canvas_ = nullptr;
  StreamSelector* streams_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  LensPanel* lensPanel_ = nullptr;
  PlacePanel* placePanel_ = nullptr;
  SettingsPanel* settingsPanel_ = nullptr;
  QLabel *time_ = nullptr, *state_ = nullptr;
  MarkModel* marks_ = nullptr;
  /// The field whose marks are listed.
  std::shared_ptr<const robotlink::FieldDescription> field_;
  ParameterEdits* parameters_ = nullptr;
  PackageSubscription subscription_, settingsSubscription_;

  std::shared_ptr<const foxglove::RawImage> image_;
  /// The image that was last searched; the corners are empty if there was no board.
  std::shared_ptr<const foxglove::RawImage> searched_;
  robotlink::Chessboard searchedBoard_;
  Corners corners_;
  QString problem_;
  /// Whether the view shows the present state.
  bool isShown_ = false;
  /// Marks were clicked, but no lens was known.
  bool waitsForLens_ = false;
  BoardViews views_;
  std::optional<robotlink::LensFit> lensFit_;
  std::optional<QPointF> pressed_;
  robotlink::Worker<Search, Found> finder_;
  robotlink::Worker<Question, Answer> fitter_;
};

}  // namespace widgets
