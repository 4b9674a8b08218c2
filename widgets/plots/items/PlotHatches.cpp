// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/items/PlotHatches.h"

#include <qcustomplot.h>

#include <utility>

#include "widgets/Theme.h"

namespace widgets {

QString PlotHatches::textOf(MissingValues::Why why) {
  switch (why) {
    case MissingValues::Why::kUnread:
      return tr("being read from disk");
    case MissingValues::Why::kTooMany:
      return tr("on disk; look there with the timeline");
    case MissingValues::Why::kLost:
      break;
  }
  return tr("lost, since the disk was too slow");
}

PlotHatches::Items PlotHatches::make() {
  const Items items{new QCPItemRect(&plot_), new QCPItemText(&plot_)};
  items.hatch->setLayer(QStringLiteral("background"));
  items.hatch->setPen(Qt::NoPen);
  items.text->setPositionAlignment(Qt::AlignHCenter | Qt::AlignBottom);
  for (QCPItemPosition* corner : {items.hatch->topLeft, items.hatch->bottomRight, items.text->position})
    corner->setTypeY(QCPItemPosition::ptAxisRectRatio);
  return items;
}

void PlotHatches::set(std::vector<MissingValues> missing) {
  missing_ = std::move(missing);
  for (; items_.size() > missing_.size(); items_.pop_back()) {
    plot_.removeItem(items_.back().hatch);
    plot_.removeItem(items_.back().text);
  }
  while (items_.size() < missing_.size()) items_.push_back(make());
  const QPalette colors = plot_.palette();
  const QColor text = colors.color(QPalette::Text);
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const auto& [from, to, why] = missing_[i];
    const auto& [hatch, words] = items_[i];
    hatch->setBrush(QBrush(mixed(colors.color(QPalette::Base), text, 0.25), Qt::BDiagPattern));
    hatch->topLeft->setCoords(from, 0);
    hatch->bottomRight->setCoords(to, 1);
    words->setText(textOf(why));
    words->setColor(text);
    words->setFont(plot_.font());
    words->position->setCoords((from + to) / 2, 1);
  }
}

}  // namespace widgets
