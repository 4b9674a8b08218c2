// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/export/ExportDialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "robotlink/session/Session.h"
#include "widgets/Controls.h"
#include "widgets/Counted.h"
#include "widgets/export/ExportPlan.h"
#include "widgets/log/ReplayControl.h"

namespace widgets {
namespace {

/// The span of live robots that is proposed without a selected range.
constexpr std::chrono::seconds kProposedSpan{10};
constexpr double kMaxExportTime = 1e7;  // s

QDoubleSpinBox* makeNumber(QWidget* parent, const ControlText& text, const QString& suffix) {
  auto* box = new QDoubleSpinBox(parent);
  describe(*box, text);
  box->setSuffix(suffix);
  box->setAccelerated(true);
  return box;
}

QSpinBox* makeSide(QWidget* parent, const ControlText& text) {
  auto* box = new QSpinBox(parent);
  describe(*box, text);
  box->setRange(ExportPlan::kMinSide, ExportPlan::kMaxSide);
  box->setSuffix(QStringLiteral(" px"));
  box->setAccelerated(true);
  return box;
}

QToolButton* makeSmallButton(QWidget* parent, const ControlText& text) {
  auto* button = new QToolButton(parent);
  describe(*button, text);
  button->setText(text.text);
  return button;
}

/// Adds a row of several controls, whose label gives the focus to the first one.
void addRow(QFormLayout& form, const QString& text, QHBoxLayout* controls, QWidget* first) {
  auto* label = new QLabel(text, form.parentWidget());
  label->setBuddy(first);
  label->setMinimumWidth(label->sizeHint().width() + 4);  // with a layout next to it, the form gives it less
  form.addRow(label, controls);
}

/// A name of a view, "field#2", as a part of a file's name.
QString fileNameOf(QString view) {
  return view.replace(QLatin1Char('#'), QLatin1Char('-'));
}

bool isVideo(const QFileInfo& file) {
  const QString suffix = file.suffix().toLower();
  return suffix == QLatin1String("mp4") || suffix == QLatin1String("avi");
}

}  // namespace

ExportDialog::ExportDialog(std::vector<Offer> offers, const QString& chosen, robotlink::Session& session,
                           const ReplayControl& replay, const QJsonObject& choices, QWidget* parent)
    : QDialog(parent), offers_(std::move(offers)), session_(session), replay_(replay) {
  setObjectName(QStringLiteral("exportDialog"));
  setWindowTitle(tr("Export a view"));
  createControls();
  for (const Offer& offer : offers_) view_->addItem(offer.title, offer.name);
  view_->setCurrentIndex(std::max(0, view_->findData(chosen)));
  takeViewSize();
  restore(choices);
  proposeTimes();
  proposeTarget();
  connectSignals();
  updateSummary();
}

void ExportDialog::createControls() {
  auto* form = new QFormLayout(this);
  view_ = new QComboBox(this);
  describe(*view_, {"exportView", tr("View"), tr("The view to export")});
  kind_ = new QComboBox(this);
  describe(*kind_, {"exportKind", tr("As"), tr("What is written")});
  kind_->addItems({tr("Video (.mp4)"), tr("Video (.avi, Motion JPEG)"), tr("Images (.png), numbered")});
  target_ = new QLineEdit(this);
  describe(*target_, {"exportTarget", tr("File or folder"), tr("Where it is written to")});
  auto* browse = makeSmallButton(this, {"exportBrowse", tr("Browse…"), tr("Chooses the file or folder")});
  connect(browse, &QToolButton::clicked, this, &ExportDialog::browse);
  auto* place = new QHBoxLayout;
  place->addWidget(target_, 1);
  place->addWidget(browse);
  form->addRow(tr("&View"), view_);
  form->addRow(tr("&As"), kind_);
  addRow(*form, tr("&To"), place, target_);
  createTimes();
  createSize();
  summary_ = makeNote(this, "exportSummary", tr("What will be written"));
  problem_ = makeNote(this, "exportProblem", tr("What is wrong"));
  setMeaning(*problem_, Meaning::kBad);
  problem_->hide();
  form->addRow(summary_);
  form->addRow(problem_);
  buttons_ = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  buttons_->button(QDialogButtonBox::Ok)->setText(tr("Export"));
  buttons_->button(QDialogButtonBox::Ok)->setObjectName(QStringLiteral("exportOk"));
  form->addRow(buttons_);
  setMinimumWidth(460);
}

void ExportDialog::createTimes() {
  const QString seconds = tr(" s");
  from_ = makeNumber(this, {"exportFrom", tr("From"), tr("The first instant, as the timeline shows it")},
                     seconds);
  to_ = makeNumber(this, {"exportUntil", tr("Until"), tr("The last instant, as the timeline shows it")},
                   seconds);
  for (QDoubleSpinBox* box : {from_, to_}) {
    box->setRange(-kMaxExportTime, kMaxExportTime);
    box->setDecimals(3);
  }
  auto* all = makeSmallButton(
      this, {"exportAll", tr("All"), tr("The whole log, or the whole history of live robots")});
  connect(all, &QToolButton::clicked, this, [this] {
    const auto span = exportable(session_, replay_);
    if (!span) return;
    from_->setValue(robotlink::seconds(session_.timeline().sinceOrigin(span->from)));
    to_->setValue(robotlink::seconds(session_.timeline().sinceOrigin(span->to)));
  });
  auto* range = makeSmallButton(
      this,
      {"exportRange", tr("A–B"), tr("The range that is selected in the timeline (I and O select one)")});
  range->setEnabled(replay_.range().has_value());
  connect(range, &QToolButton::clicked, this, &ExportDialog::proposeTimes);
  auto* times = new QHBoxLayout;
  times->addWidget(from_, 1);
  times->addWidget(new QLabel(tr("until"), this));
  times->addWidget(to_, 1);
  times->addWidget(range);
  times->addWidget(all);
  auto* form = static_cast<QFormLayout*>(layout());
  addRow(*form, tr("&From"), times, from_);
  rate_ = makeNumber(this, {"exportRate", tr("Rate"), tr("Pictures per second; also the video's frame rate")},
                     tr(" pictures/s"));
  rate_->setRange(ExportPlan::kMinRate, ExportPlan::kMaxRate);
  rate_->setDecimals(1);
  rate_->setValue(25);
  form->addRow(tr("&Rate"), rate_);
}

void ExportDialog::createSize() {
  width_ = makeSide(this, {"exportWidth", tr("Width"), tr("Width of the pictures")});
  height_ = makeSide(this, {"exportHeight", tr("Height"), tr("Height of the pictures")});
  auto* shown =
      makeSmallButton(this, {"exportAsShown", tr("As shown"), tr("The size in which the view is shown now")});
  connect(shown, &QToolButton::clicked, this, &ExportDialog::takeViewSize);
  auto* size = new QHBoxLayout;
  size->addWidget(width_, 1);
  size->addWidget(new QLabel(QStringLiteral("×"), this));
  size->addWidget(height_, 1);
  size->addWidget(shown);
  addRow(*static_cast<QFormLayout*>(layout()), tr("&Size"), size, width_);
}

void ExportDialog::connectSignals() {
  connect(view_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &ExportDialog::proposeTarget);
  connect(kind_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &ExportDialog::proposeTarget);
  connect(target_, &QLineEdit::textChanged, this, &ExportDialog::updateSummary);
  for (QDoubleSpinBox* box : {from_, to_, rate_})
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &ExportDialog::updateSummary);
  connect(buttons_, &QDialogButtonBox::accepted, this, &ExportDialog::exportWanted);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void ExportDialog::restore(const QJsonObject& choices) {
  kind_->setCurrentIndex(std::clamp(choices[QStringLiteral("kind")].toInt(), 0, kind_->count() - 1));
  rate_->setValue(choices[QStringLiteral("rate")].toDouble(rate_->value()));
  const QSize size(choices[QStringLiteral("width")].toInt(), choices[QStringLiteral("height")].toInt());
  if (!size.isEmpty()) {
    width_->setValue(size.width());
    height_->setValue(size.height());
  }
  folder_ = choices[QStringLiteral("folder")].toString();
  if (folder_.isEmpty() || !QFileInfo(folder_).isDir()) folder_ = QDir::currentPath();
}

QJsonObject ExportDialog::choices() const {
  const QFileInfo target(target_->text());
  return {{QStringLiteral("kind"), kind_->currentIndex()},
          {QStringLiteral("rate"), rate_->value()},
          {QStringLiteral("width"), width_->value()},
          {QStringLiteral("height"), height_->value()},
          {QStringLiteral("folder"), target.absolutePath()}};
}

void ExportDialog::proposeTimes() {
  auto span = chosenSpan(session_, replay_);
  if (!span) return;
  if (!replay_.open() && !replay_.range()) span->from = std::max(span->from, span->to - kProposedSpan);
  from_->setValue(robotlink::seconds(session_.timeline().sinceOrigin(span->from)));
  to_->setValue(robotlink::seconds(session_.timeline().sinceOrigin(span->to)));
}

void ExportDialog::takeViewSize() {
  const QSize size = offers_[static_cast<std::size_t>(std::max(0, view_->currentIndex()))].size;
  width_->setValue(size.width());
  height_->setValue(size.height());
}

ExportDialog::Kind ExportDialog::kind() const {
  return static_cast<Kind>(std::max(0, kind_->currentIndex()));
}

void ExportDialog::proposeTarget() {
  const QString view = fileNameOf(view_->currentData().toString());
  const QString images = QStringLiteral("-images");
  const QString suffix = isImages()             ? images
                         : kind() == Kind::kMp4 ? QStringLiteral(".mp4")
                                                : QStringLiteral(".avi");
  const QString typed = target_->text();
  if (typed.isEmpty() || typed == proposed_) {
    proposed_ = QDir::toNativeSeparators(QDir(folder_).filePath(view + suffix));
    target_->setText(proposed_);
  } else if (const QFileInfo file(typed); !isImages() || isVideo(file)) {
    QString name = file.completeBaseName();
    if (!isVideo(file) && name.endsWith(images)) name.chop(images.size());
    target_->setText(QDir::toNativeSeparators(file.dir().filePath(name + suffix)));
  }
  updateSummary();
}

void ExportDialog::browse() {
  const QString title = isImages() ? tr("Folder of the images") : tr("Video");
  const QString file =
      isImages() ? QFileDialog::getExistingDirectory(this, title, QFileInfo(target_->text()).absolutePath())
                 : QFileDialog::getSaveFileName(this, title, target_->text(), tr("Videos (*.mp4 *.avi)"));
  if (!file.isEmpty()) target_->setText(QDir::toNativeSeparators(file));
}

void ExportDialog::updateSummary() {
  problem_->hide();
  ExportPlan plan;
  plan.rate = rate_->value();
  plan.to = robotlink::Instant(robotlink::fromSeconds(to_->value()));
  plan.from = robotlink::Instant(robotlink::fromSeconds(from_->value()));
  const bool isSpan = to_->value() >= from_->value(), isTarget = !target_->text().trimmed().isEmpty();
  const QString replaced = !isImages() && QFileInfo::exists(target_->text())
                               ? tr("\nThe file exists, and will be replaced.")
                               : QString();
  summary_->setText(!isSpan ? tr("The end must not be before the beginning.")
                    : !isTarget
                        ? tr("Choose the output file or folder.")
                        : counted(plan.frames(), tr("1 picture"), tr("%1 pictures")) +
                              tr(" of %1 s").arg(to_->value() - from_->value(), 0, 'f', 2) + replaced);
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(isSpan && isTarget);
}

ExportDialog::Answer ExportDialog::answer() const {
  const auto number = [](double value) { return QString::number(value, 'f', 3).toStdString(); };
  return {!isImages(),
          view_->currentData().toString().toStdString(),
          QFileInfo(target_->text().trimmed()).absoluteFilePath().toStdString(),
          number(from_->value()),
          number(to_->value()),
          QStringLiteral("%1x%2").arg(width_->value()).arg(height_->value()).toStdString(),
          rate_->value()};
}

void ExportDialog::setProblem(const QString& text) {
  problem_->setText(text);
  problem_->show();
}

}  // namespace widgets
