// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>
#include <QTimer>
#include <optional>
#include <utility>

class QDoubleSpinBox;
class QGridLayout;
class QSlider;

namespace app {

class CommandActions;
class Workbench;

/// The light of the simulation: brightness and warmth, each by a slider with marks and by its value, and some
/// lights by name. What is set is seen at once in the Scene view and in the next image of each camera. Shows
/// what the simulation reports. GUI thread.
class LightMenu final : public QMenu {
  Q_OBJECT
 public:
  LightMenu(Workbench& workbench, CommandActions& actions, QWidget* parent);

 private:
  /// One property of the light. The slider has the range that is of use, the box all that is possible.
  struct Control {
    QSlider* slider = nullptr;
    QDoubleSpinBox* box = nullptr;
    double value() const;
    void show(double value) const;
  };
  struct Range {
    const char* name;
    QString label, toolTip;
    double least, greatest, slidesTo;
    QStringList marks;  ///< along the slider, evenly
  };
  using Light = std::pair<double, double>;  // brightness, warmth

  void createPanel();
  Control createControl(QGridLayout& grid, const Range& range);
  void createNamedLights();
  void choose();
  void refresh();

  Workbench& workbench_;
  CommandActions& actions_;
  Control brightness_, warmth_;
  std::optional<Light> asked_;  ///< until the simulation reports it
  int patience_ = 0;            ///< calls of refresh() until it will not any more
  QTimer refreshing_;
};

}  // namespace app
