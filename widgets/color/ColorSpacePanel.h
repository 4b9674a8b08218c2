// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "colortool/ColorClasses.h"
#include "widgets/color/ColorSpaceScene.h"

class QCheckBox;
class QComboBox;
class QListWidget;
class QSlider;

namespace widgets {

/// Beside a colour space: which classes are shown, how opaque surfaces are, and where it is cut. Object
/// names: colorSpaceClasses, colorSpaceAllClasses, colorSpaceNoClasses, colorSpaceSurfaces,
/// colorSpaceOpacity, colorSpaceCut, colorSpaceCutAt, colorSpaceCutOther.
class ColorSpacePanel final : public QWidget {
  Q_OBJECT
 public:
  explicit ColorSpacePanel(QWidget* parent = nullptr);

  void setClasses(const colortool::ColorClasses& classes);
  /// Whether there is a table to compare with.
  void setHasReference(bool has);
  /// Its part of a look, from it and to it; neither tells lookChanged().
  void addTo(ColorSpaceLook& look) const;
  void setLook(const ColorSpaceLook& look);

 Q_SIGNALS:
  void lookChanged();

 private:
  void createViews();
  QWidget* createButtons();
  QWidget* createSurfaces();
  QWidget* createCut();
  void connectSignals();
  void listClasses();
  void checkAll(bool checked);
  void nameCuts(colortool::ColorSpace space);
  void enableCut();

  colortool::ColorClasses classes_;
  std::vector<std::string> hidden_;  ///< also those that are no classes at present
  QListWidget* list_ = nullptr;
  QSlider *opacity_ = nullptr, *cutAt_ = nullptr;
  QComboBox *surfaces_ = nullptr, *cut_ = nullptr;
  QCheckBox* cutOther_ = nullptr;
};

}  // namespace widgets
