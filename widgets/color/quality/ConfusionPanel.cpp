// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/quality/ConfusionPanel.h"

#include <QBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QScrollArea>
#include <QStyledItemDelegate>
#include <QTableView>
#include <cmath>

#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/Theme.h"

namespace widgets {
namespace {

constexpr int kNoteLines = 4;

/// Shades a cell by its share in the color for right or wrong, steeply for small shares, since a few percent
/// matter. The text keeps the palette's color.
class HeatDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const double share = index.data(ConfusionModel::kShareRole).toDouble();
    if (share > 0) {
      const bool right = index.data(ConfusionModel::kRightRole).toBool();
      QColor color = colorOf(right ? Meaning::kGood : Meaning::kBad, option.palette);
      color.setAlphaF(right ? 0.5 * share : 0.12 + 0.48 * std::sqrt(share));
      painter->fillRect(option.rect, color);
    }
    QStyledItemDelegate::paint(painter, option, index);
  }
};

}  // namespace

ConfusionPanel::ConfusionPanel(const char* name, const QString& title, QWidget* parent) : QWidget(parent) {
  const QByteArray prefix(name);
  auto* heading = new QLabel(QStringLiteral("<b>%1</b>").arg(title.toHtmlEscaped()), this);
  // The text wraps, so that it does not determine the dock's width.
  summary_ = makeNote(this, (prefix + "Summary").constData(), title);
  summary_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  noteArea_ = new QScrollArea(this);
  note_ = makeNote(noteArea_, (prefix + "Note").constData(), tr("Notes on these figures"));
  note_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  // A long note must not take the room of other views.
  noteArea_->setWidget(note_);
  noteArea_->setWidgetResizable(true);
  noteArea_->setFrameShape(QFrame::NoFrame);
  noteArea_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  noteArea_->setMinimumHeight(fontMetrics().height() + 2);
  noteArea_->setMaximumHeight(kNoteLines * fontMetrics().lineSpacing() + 2);
  table_ = new QTableView(this);
  describe(*table_, {(prefix + "Matrix").constData(),
                     tr("%1: true classes in rows, found ones in columns, in percent").arg(title),
                     {}});
  table_->setModel(&model_);
  table_->setItemDelegate(new HeatDelegate(table_));
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setFocusPolicy(Qt::NoFocus);
  table_->setShowGrid(true);
  table_->setCornerButtonEnabled(false);
  table_->setIconSize({14, 14});
  new ColumnFit(*table_, ColumnKind::kNumber);
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().height() + 6);
  table_->verticalHeader()->setHighlightSections(false);
  hint_ = new EmptyHint(table_);
  auto* top = new QHBoxLayout;
  top->addWidget(heading);
  top->addWidget(summary_, 1);
  auto* layout = makeColumn(this, {}, 3);
  layout->addLayout(top);
  layout->addWidget(table_, 1);
  layout->addWidget(noteArea_);
  setNote({});
}

void ConfusionPanel::setNote(const QString& note) {
  note_->setText(note);
  noteArea_->setVisible(!note.isEmpty());
}

void ConfusionPanel::show(const colortool::ColorClasses& classes, const colortool::Evaluation& evaluation,
                          const std::vector<std::uint8_t>& alone, const QString& note) {
  model_.setEvaluation(classes, evaluation, alone);
  const auto figure = [](std::optional<double> share) {
    return share ? QStringLiteral("%1 %").arg(100 * *share, 0, 'f', 2) : QStringLiteral("–");
  };
  summary_->setText(
      tr("Mean recall %1    False colors %2").arg(figure(model_.meanRecall()), figure(model_.falseColors())));
  summary_->setToolTip(
      tr("Mean recall: the share of a class's pixels that is found, averaged over the classes. False colors: "
         "the share of the background that is classified as a color of objects, such as orange or blue."));
  setNote(note);
  hint_->setHint({});
}

void ConfusionPanel::showNothing(const QString& why) {
  model_.setEvaluation({}, std::nullopt);
  summary_->clear();
  setNote({});
  hint_->setHint(why);
}

}  // namespace widgets
