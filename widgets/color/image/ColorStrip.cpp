// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/image/ColorStrip.h"

#include <QKeyEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <algorithm>

#include "robotlink/session/Session.h"
#include "widgets/Controls.h"
#include "widgets/color/ColorBench.h"

namespace widgets {
namespace {

constexpr int kHeight = 96;
constexpr QSize kIcon(96, 64), kLowIcon(48, 28);
constexpr int kLowHeight = 44;

/// Draws a frame around the current image, which can be seen where there is no name to highlight.
class FramedDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QStyledItemDelegate::paint(painter, option, index);
    if (!(option.state & QStyle::State_Selected)) return;
    painter->save();
    painter->setPen(QPen(option.palette.color(QPalette::Highlight), 2));
    painter->drawRect(option.rect.adjusted(1, 1, -1, -1));
    painter->restore();
  }
};

}  // namespace

ColorStrip::ColorStrip(ColorBench& bench, QWidget* parent) : QListWidget(parent), bench_(bench) {
  describe(*this, {"colorStrip", tr("Collected images"),
                   tr("Collected images; a click shows one, Delete removes it")});
  setViewMode(QListView::IconMode);
  setFlow(QListView::LeftToRight);
  setWrapping(false);
  setMovement(QListView::Static);
  setIconSize(kIcon);
  setSpacing(3);
  setFixedHeight(kHeight + fontMetrics().height());
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(&bench_, &ColorBench::collectedChanged, this, &ColorStrip::refresh);
  connect(this, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) {
    const auto index = static_cast<std::size_t>(row(item));
    if (index < bench_.collected().size()) Q_EMIT chosen(bench_.collected()[index].frame);
  });
  connect(this, &QListWidget::itemActivated, this, &QListWidget::itemClicked);
  connect(&bench_, &ColorBench::frameChanged, this, [this] { markShown(); });
  setItemDelegate(new FramedDelegate(this));
  refresh();
}

void ColorStrip::refresh() {
  const int current = currentRow();
  {
    const QSignalBlocker quiet(this);
    clear();
    for (const CollectedFrame& collected : bench_.collected()) {
      auto* item = new QListWidgetItem(QPixmap::fromImage(collected.thumbnail),
                                       low_ ? QString() : labelOf(*collected.frame), this);
      item->setToolTip(QString::fromStdString(collected.frame->place().name));
    }
  }
  setCurrentRow(std::min(current, count() - 1));
  markShown();
  setVisible(wanted_ && count() > 0);
}

QString ColorStrip::labelOf(const ColorFrame& frame) const {
  if (!frame.file().empty()) return frame.label();
  return tr("%1 s").arg(robotlink::seconds(bench_.session().timeline().sinceOrigin(frame.time())), 0, 'f', 2);
}

void ColorStrip::setWanted(bool wanted) {
  wanted_ = wanted;
  setVisible(wanted_ && count() > 0);
}

void ColorStrip::setLow(bool low) {
  if (low == low_) return;
  low_ = low;
  setIconSize(low ? kLowIcon : kIcon);
  setFixedHeight(low ? kLowHeight : kHeight + fontMetrics().height());
  refresh();
}

void ColorStrip::markShown() {
  const auto shows = [this](const CollectedFrame& each) { return each.frame == bench_.frame(); };
  // Keys in the strip go from image to image, also to those that are not shown.
  if (!hasFocus() || std::ranges::any_of(bench_.collected(), shows)) showCurrent(bench_.frame());
}

void ColorStrip::showCurrent(const ColorFramePtr& frame) {
  for (std::size_t i = 0; i < bench_.collected().size(); ++i) {
    if (bench_.collected()[i].frame == frame) return setCurrentRow(static_cast<int>(i));
  }
  setCurrentRow(-1);
}

void ColorStrip::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Delete || currentRow() < 0) return QListWidget::keyPressEvent(event);
  bench_.removeCollected(static_cast<std::size_t>(currentRow()));
}

}  // namespace widgets
