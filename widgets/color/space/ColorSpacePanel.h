// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "colortool/image/ColorClasses.h"
#include "widgets/color/space/ColorSpaceScene.h"

class QCheckBox;
class QComboBox;
class QListWidget;
class QSlider;

namespace widgets {

/// The options next to a color space: which classes are shown, whose surfaces, how opaque they are, and where
/// the space is cut. Object names: colorSpaceClasses, colorSpaceAllClasses, colorSpaceNoClasses,
/// colorSpaceSurfaces, colorSpaceOpacity, colorSpaceCut, colorSpaceCutAt, colorSpaceCutOther. GUI thread.
class ColorSpacePanel final : public QWidget {
  Q_OBJECT
 public:
  explicit ColorSpacePanel(QWidget* parent = nullptr);

  /// Lists the classes; those hidden by name stay hidden.
  void setClasses(const colortool::ColorClasses& classes);
  /// Whether there is a reference table, whose surfaces can be shown.
  void setHasReference(bool has);
  /// Writes the panel's options into a look, or sets them from it. Neither emits lookChanged().
  void addTo(ColorSpaceLook& look) const;
  void setLook(const ColorSpaceLook& look);

 Q_SIGNALS:
  /// The user changed an option.
  void lookChanged();

 private:
  void createViews();
  /// Buttons that show all or no classes.
  QWidget* createButtons();
  /// Choice of the surfaces and their opacity.
  QWidget* createSurfaces();
  /// Direction, position and side of the cut.
  QWidget* createCut();
  void connectSignals();
  /// Fills the list of classes.
  void listClasses();
  void checkAll(bool checked);
  /// Names the cuts after the channels of the space.
  void nameCuts(colortool::ColorSpace space);
  /// Enables the slider if there is a cut.
  void enableCut();

  colortool::ColorClasses classes_;
  /// Names of hidden classes, including those that do not exist at present.
  std::vector<std::string> hidden_;
  QListWidget* list_ = nullptr;
  QSlider *opacity_ = nullptr, *cutAt_ = nullptr;
  QComboBox *surfaces_ = nullptr, *cut_ = nullptr;
  QCheckBox* cutOther_ = nullptr;
};

}  // namespace widgets
