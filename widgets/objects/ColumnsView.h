// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robotlink/process/Link.h"
#include "widgets/View.h"
#include "widgets/objects/ColumnsCanvas.h"
#include "widgets/ports/PortSubscription.h"

class QAction;
class QComboBox;
class QLabel;

namespace robotcontrol {
class WorldPort;
}

namespace widgets {

class EmptyHint;

/// The values of a list as columns: those of a sensor of the scene, by the path of its port, or a list in the
/// messages of any stream: "red1/range/laser: ranges". Follows the session's timeline.
///
/// Registered as "columns". GUI thread.
class ColumnsView final : public View {
  Q_OBJECT
 public:
  /// The maximum number of values of a list; further ones are left out.
  static constexpr int kMaxValues = 2000;

  explicit ColumnsView(ViewContext& context, QWidget* parent = nullptr);
  ~ColumnsView() override;

  void tick() override;
  /// Shows a list from now on, also one that is not there yet. Fails if the text
  /// is empty, or a sensor that the scene does not have.
  robotlink::Result<void> showSource(const std::string& source);
  /// A line for each value: its index, a tab, the value.
  std::optional<QString> numbers() override;
  /// The same as .csv; else as other views.
  robotlink::Result<void> saveTo(const QString& file) override;
  QImage shownPicture() override;

 private:
  void createViews();
  /// Lists the sensors of the scene that have values.
  void listPorts();
  /// The sensor with this path; null: there is none.
  const robotcontrol::WorldPort* port(const std::string& path) const;
  /// Whether it names a sensor that the scene does not have.
  bool isMissing(const std::string& source) const;
  /// The values of the source at the shown instant; unset: not known.
  std::optional<ColumnGraph> graph();
  std::optional<ColumnGraph> graphOfPort(const robotcontrol::WorldPort& port) const;
  std::optional<ColumnGraph> graphOfStream(const std::string& source) const;
  void showPointed(int column);
  QString table(QChar separator) const;

  QComboBox* source_ = nullptr;
  QAction* freeze_ = nullptr;
  QLabel* value_ = nullptr;
  ColumnsCanvas* canvas_ = nullptr;
  EmptyHint* hint_ = nullptr;
  PortSubscription subscription_;
  robotlink::PackagePtr objects_;
  /// The axis, and the source to which it belongs.
  SteadyLimits limits_;
  QString limited_;
  int pointed_ = -1;
};

}  // namespace widgets
