// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>
#include <memory>
#include <utility>
#include <vector>

#include "robotlink/series/Spectrum.h"
#include "widgets/plots/CurveModel.h"

class QAction;
class QComboBox;
class QCustomPlot;
class QHBoxLayout;
class QLabel;

namespace widgets {

class SeriesGraph;

/// Draws the amplitudes of the oscillations in some curves over their frequencies, with what they are
/// multiplied by before (the window) to be chosen above. The wheel zooms the frequencies, dragging pans, a
/// double click fits. GUI thread.
class SpectrumCanvas final : public QWidget {
  Q_OBJECT
 public:
  explicit SpectrumCanvas(QWidget* parent = nullptr);
  /// Computes the spectra of the points between two times, in s, if they are others than before.
  void showSpectra(std::vector<std::shared_ptr<CurveModel::Curve>> curves, double from, double to);
  /// Two columns for each curve: "frequency_hz", and the amplitudes.
  QString csv() const;
  /// The name of the window: "hann".
  QString window() const;
  void setWindow(const QString& name);
  bool isLogarithmic() const;
  void setLogarithmic(bool on);
  /// Adds a button for an action next to the controls.
  void addTool(QAction& action);
  /// The spectra that were last shown.
  const std::vector<robotlink::Spectrum>& spectra() const { return spectra_; }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  /// The points that a spectrum is computed from.
  struct Seen {
    std::shared_ptr<CurveModel::Curve> curve;
    std::size_t begin = 0, end = 0;
    bool operator==(const Seen&) const = default;
  };
  void createControls();
  void applyTheme();
  void compute();
  void addSpectrum(const Seen& seen, QStringList& notes);
  void fit();
  robotlink::SpectrumWindow chosenWindow() const;

  QCustomPlot* plot_;
  QComboBox* window_ = nullptr;
  QAction* logarithmic_ = nullptr;
  QLabel* note_ = nullptr;
  QHBoxLayout* tools_ = nullptr;
  std::vector<Seen> seen_;
  std::pair<double, double> times_;
  std::vector<robotlink::Spectrum> spectra_;
  std::vector<SeriesGraph*> graphs_;
  bool isFitted_ = true;
};

}  // namespace widgets
