// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/space/ColorSpacePanel.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/Controls.h"

namespace widgets {
namespace {

constexpr int kSteps = 200;  // steps of the sliders

QIcon colorSwatch(robotlink::Rgb color) {
  QPixmap pixmap(14, 14);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QColor(128, 128, 128));
  painter.setBrush(QColor(color.r, color.g, color.b));
  painter.drawRoundedRect(QRectF(0.5, 0.5, 13, 13), 3, 3);
  return pixmap;
}

}  // namespace

ColorSpacePanel::ColorSpacePanel(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("colorSpacePanel"));
  createViews();
  connectSignals();
  listClasses();
}

void ColorSpacePanel::createViews() {
  auto* layout = makeColumn(this, {4, 2, 4, 4}, 3);
  layout->addWidget(createButtons());
  list_ = new QListWidget(this);
  describe(*list_,
           {"colorSpaceClasses", tr("Classes"),
            tr("Which classes are shown: their surfaces, their samples, and the pixels that the table "
               "puts into them")});
  list_->setSelectionMode(QAbstractItemView::NoSelection);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setMinimumHeight(5 * fontMetrics().height());
  layout->addWidget(list_, 1);

  layout->addWidget(createSurfaces());
  layout->addWidget(createCut());
  setLook(ColorSpaceLook{});
}

QWidget* ColorSpacePanel::createButtons() {
  QHBoxLayout* row = makeToolRow(this);
  row->addWidget(new QLabel(tr("Classes"), row->parentWidget()), 1);
  QAction* all =
      makeAction(this, "check-all", {"colorSpaceAllClasses", tr("All classes"), tr("Shows all classes")});
  QAction* none = makeAction(
      this, "check-none", {"colorSpaceNoClasses", tr("No classes"), tr("Hides all classes, to show a few")});
  addButtons(row, {all, none});
  connect(all, &QAction::triggered, this, [this] { checkAll(true); });
  connect(none, &QAction::triggered, this, [this] { checkAll(false); });
  return row->parentWidget();
}

QWidget* ColorSpacePanel::createSurfaces() {
  auto* box = new QWidget(this);
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(3);
  surfaces_ = new QComboBox(box);
  describe(*surfaces_, {"colorSpaceSurfaces", tr("Surfaces"), tr("Whose surfaces are shown")});
  surfaces_->addItems({tr("table's surfaces"), tr("reference's surfaces"), tr("what differs")});
  opacity_ = new QSlider(Qt::Horizontal, box);
  describe(*opacity_, {"colorSpaceOpacity", tr("Opacity of surfaces"),
                       tr("How much the surfaces hide what is behind them")});
  opacity_->setRange(0, kSteps);

  layout->addWidget(surfaces_);
  layout->addWidget(opacity_);
  return box;
}

QWidget* ColorSpacePanel::createCut() {
  auto* box = new QWidget(this);
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(3);
  cut_ = new QComboBox(box);
  describe(*cut_, {"colorSpaceCut", tr("Cut"), tr("Cuts a part off, to look inside")});
  cutAt_ = new QSlider(Qt::Horizontal, box);
  describe(*cutAt_, {"colorSpaceCutAt", tr("Place of the cut"), tr("Where it is cut")});
  cutAt_->setRange(0, kSteps);
  cutOther_ = new QCheckBox(tr("Other part"), box);
  describe(*cutOther_, {"colorSpaceCutOther", tr("Other part"), tr("Shows the other side of the cut")});

  layout->addWidget(cut_);
  layout->addWidget(cutAt_);
  layout->addWidget(cutOther_);
  // Long texts must not take the room of the picture.
  for (QComboBox* choice : {surfaces_, cut_}) {
    choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    choice->setMinimumContentsLength(8);
  }
  nameCuts(colortool::ColorSpace::kYCbCr);
  return box;
}

void ColorSpacePanel::connectSignals() {
  connect(surfaces_, qOverload<int>(&QComboBox::currentIndexChanged), this, &ColorSpacePanel::lookChanged);
  connect(opacity_, &QSlider::valueChanged, this, &ColorSpacePanel::lookChanged);
  connect(cutAt_, &QSlider::valueChanged, this, &ColorSpacePanel::lookChanged);
  connect(cutOther_, &QCheckBox::toggled, this, &ColorSpacePanel::lookChanged);
  connect(cut_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
    enableCut();
    Q_EMIT lookChanged();
  });
  connect(list_, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
    const std::string name = classes_.name(list_->row(item));
    std::erase(hidden_, name);
    if (item->checkState() == Qt::Unchecked) hidden_.push_back(name);
    Q_EMIT lookChanged();
  });
}

void ColorSpacePanel::setClasses(const colortool::ColorClasses& classes) {
  if (classes == classes_) return;
  classes_ = classes;
  listClasses();
}

void ColorSpacePanel::setHasReference(bool has) {
  surfaces_->setEnabled(has);
  surfaces_->setToolTip(has ? tr("Whose surfaces are shown")
                            : tr("There is no table to compare with: choose a reference first"));
}

void ColorSpacePanel::listClasses() {
  const QSignalBlocker blocker(list_);
  list_->clear();
  for (int i = 0; i < classes_.size(); ++i) {
    const bool none = i == colortool::ColorClasses::kNone;
    auto* item =
        new QListWidgetItem(colorSwatch(none ? robotlink::Rgb{128, 128, 128} : classes_.shownColor(i)),
                            none ? tr("background") : QString::fromStdString(classes_.name(i)), list_);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
    const bool hidden = std::ranges::find(hidden_, classes_.name(i)) != hidden_.end();
    item->setCheckState(hidden ? Qt::Unchecked : Qt::Checked);
  }
}

void ColorSpacePanel::checkAll(bool checked) {
  hidden_.clear();
  for (int i = 0; i < classes_.size() && !checked; ++i) hidden_.push_back(classes_.name(i));
  listClasses();
  Q_EMIT lookChanged();
}

void ColorSpacePanel::nameCuts(colortool::ColorSpace space) {
  const QSignalBlocker blocker(cut_);
  const int chosen = std::max(0, cut_->currentIndex());
  cut_->clear();
  cut_->addItems({tr("no cut"), tr("cut the view")});
  for (const char* channel : colortool::channelNames(space))
    cut_->addItem(tr("cut at %1").arg(QLatin1String(channel)));
  cut_->setCurrentIndex(chosen);
}

void ColorSpacePanel::enableCut() {
  cutAt_->setEnabled(cut_->currentIndex() > 0);
  cutOther_->setEnabled(cut_->currentIndex() > 0);
}

void ColorSpacePanel::addTo(ColorSpaceLook& look) const {
  look.hidden = hidden_;
  look.surfaces = static_cast<SurfacesOf>(surfaces_->currentIndex());
  look.opacity = double(opacity_->value()) / kSteps;
  look.cut.along = static_cast<ColorSpaceCut::Along>(cut_->currentIndex());
  look.cut.at = double(cutAt_->value()) / kSteps;
  look.cut.other = cutOther_->isChecked();
}

void ColorSpacePanel::setLook(const ColorSpaceLook& look) {
  const QSignalBlocker blocker(this);
  nameCuts(look.space);
  hidden_ = look.hidden;
  listClasses();
  surfaces_->setCurrentIndex(static_cast<int>(look.surfaces));
  opacity_->setValue(qRound(look.opacity * kSteps));
  cut_->setCurrentIndex(static_cast<int>(look.cut.along));
  cutAt_->setValue(qRound(look.cut.at * kSteps));
  cutOther_->setChecked(look.cut.other);
  enableCut();
}

}  // namespace widgets
