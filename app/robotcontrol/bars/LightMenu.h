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

/// The menu of a simulation's light: brightness and warmth, each with a slider and a field for the number,
/// and some named lights. A change is visible at once in the Scene view and in the next image of each camera.
/// While the menu is open it shows what the simulation reports. GUI thread; the workbench must outlive it.
class LightMenu final : public QMenu {
  Q_OBJECT
 public:
  LightMenu(Workbench& workbench, CommandActions& actions, QWidget* parent);

 private:
  /// The widgets of one property. The slider covers the useful range, the field all that is possible.
  struct Control {
    QSlider* slider = nullptr;
    QDoubleSpinBox* box = nullptr;
    /// The number in the field.
    double value() const;
    /// Shows a reported value, except in the widget that the user is changing.
    void show(double value) const;
  };
  /// The range of a property, and how it is labeled.
  struct Range {
    /// The name of the field; that of the slider follows from it.
    const char* name;
    QString label, toolTip;
    /// Minimum and maximum of the field; the slider's maximum is `slidesTo`.
    double least, greatest, slidesTo;
    /// Labels below the slider, evenly spaced.
    QStringList marks;
  };
  /// Brightness (times that of the scene) and warmth (-1 to 1).
  using Light = std::pair<double, double>;

  /// Creates the panel of the two properties.
  void createPanel();
  /// Creates a row of the panel.
  Control createControl(QGridLayout& grid, const Range& range);
  /// Creates the actions for the named lights.
  void createNamedLights();
  /// Requests the light in the fields.
  void choose();
  /// Shows the light that the simulation reports; only while the menu is open.
  void refresh();

  Workbench& workbench_;
  CommandActions& actions_;
  Control brightness_, warmth_;
  /// The requested light, until the simulation reports it.
  std::optional<Light> asked_;
  /// The number of further calls of refresh() that wait for that report.
  int patience_ = 0;
  /// Calls refresh().
  QTimer refreshing_;
};

}  // namespace app
