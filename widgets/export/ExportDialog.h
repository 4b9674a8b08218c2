// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QJsonObject>
#include <QSize>
#include <QString>
#include <string>
#include <vector>

class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QSpinBox;
namespace robotlink {
class Session;
}

namespace widgets {

class ReplayControl;

/// Asks what is to be exported of which view: video or images, where to, from when to when, how many pictures
/// a second, and how large. What was chosen is kept by choices(). GUI thread; session and control must
/// outlive it.
class ExportDialog final : public QDialog {
  Q_OBJECT
 public:
  /// A view that can be exported.
  struct Offer {
    /// The name in commands: "field#2".
    QString name;
    QString title;
    /// The size of its picture.
    QSize size;
  };
  /// The arguments with which export.video or export.images is to be run.
  struct Answer {
    bool isVideo = true;
    std::string view, target, from, to, size;
    double rate = 25;
  };

  /// `offers` must not be empty; `chosen` is the name of the one to begin with. `choices`: what choices()
  /// returned before.
  ExportDialog(std::vector<Offer> offers, const QString& chosen, robotlink::Session& session,
               const ReplayControl& replay, const QJsonObject& choices, QWidget* parent);

  Answer answer() const;
  /// The remembered choices: kind, rate, size, folder.
  QJsonObject choices() const;
  /// Says what went wrong with the answer; the dialog stays open then.
  void setProblem(const QString& text);

 Q_SIGNALS:
  /// The user pressed Export; the receiver closes the dialog, or says what is wrong.
  void exportWanted();

 private:
  enum class Kind : std::uint8_t { kMp4, kAvi, kImages };
  void createControls();
  void createTimes();
  void createSize();
  void connectSignals();
  void restore(const QJsonObject& choices);
  /// Sets the times to the selected range or, without one, to all of a log, or to the last seconds.
  void proposeTimes();
  /// Sets the size to that of the chosen view.
  void takeViewSize();
  void browse();
  /// The proposed target for view and kind; keeps a name that the user has typed.
  void proposeTarget();
  /// Counts the pictures, and enables the button.
  void updateSummary();
  Kind kind() const;
  bool isImages() const { return kind() == Kind::kImages; }

  const std::vector<Offer> offers_;
  robotlink::Session& session_;
  const ReplayControl& replay_;
  QString folder_;
  /// The last target that was proposed.
  QString proposed_;
  QComboBox *view_ = nullptr, *kind_ = nullptr;
  QLineEdit* target_ = nullptr;
  QDoubleSpinBox *from_ = nullptr, *to_ = nullptr, *rate_ = nullptr;
  QSpinBox *width_ = nullptr, *height_ = nullptr;
  QLabel *summary_ = nullptr, *problem_ = nullptr;
  QDialogButtonBox* buttons_ = nullptr;
};

}  // namespace widgets
