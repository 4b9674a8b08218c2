// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/bars/Tour.h"

#include <qtadvanceddocking/DockWidget.h>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMainWindow>
#include <QMenuBar>
#include <QPainter>
#include <QPushButton>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/robotcontrol/docks/ViewDocks.h"

namespace app {
namespace {

constexpr int kPlacingMs = 200;
constexpr int kPanelMargin = 24;  // pixels from the window's edges
constexpr int kMarkMargin = 3;    // pixels around the part
constexpr int kPanelCharacters = 72;

/// A frame that lets all clicks through.
class Mark final : public QWidget {
 public:
  explicit Mark(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("tourMark"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
  }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 3));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5), 5, 5);
  }
};

}  // namespace

Tour::Tour(QMainWindow& window, ViewDocks& docks) : QFrame(&window), mark_(new Mark(&window)) {
  setObjectName(QStringLiteral("tour"));
  setAccessibleName(tr("Tour"));
  setFrameShape(QFrame::StyledPanel);
  setFrameShadow(QFrame::Raised);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Base);
  hide();
  createSteps(window, docks);
  title_ = new QLabel;
  title_->setObjectName(QStringLiteral("tourTitle"));
  QFont bold = font();
  bold.setBold(true);
  bold.setPointSizeF(bold.pointSizeF() * 1.2);
  title_->setFont(bold);
  text_ = new QLabel;
  text_->setObjectName(QStringLiteral("tourText"));
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::PlainText);
  count_ = new QLabel;
  back_ = new QPushButton(tr("&Back"));
  back_->setObjectName(QStringLiteral("tourBack"));
  next_ = new QPushButton;
  next_->setObjectName(QStringLiteral("tourNext"));
  next_->setDefault(true);
  auto* end = new QPushButton(tr("&End the tour"));
  end->setObjectName(QStringLiteral("tourEnd"));
  end->setToolTip(tr("Help > Tour shows it again (Esc)"));
  connect(back_, &QPushButton::clicked, this, [this] { show(step_ - 1); });
  connect(next_, &QPushButton::clicked, this, [this] { show(step_ + 1); });
  connect(end, &QPushButton::clicked, this, &Tour::stop);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(count_);
  buttons->addStretch();
  for (QPushButton* button : {end, back_, next_}) buttons->addWidget(button);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(title_);
  layout->addWidget(text_);
  layout->addLayout(buttons);
  window.installEventFilter(this);
  placing_.setInterval(kPlacingMs);
  connect(&placing_, &QTimer::timeout, this, &Tour::place);
}

void Tour::createSteps(QMainWindow& window, ViewDocks& docks) {
  const auto view = [&docks](const char* id) {
    return [&docks, id = QString::fromLatin1(id)]() -> QWidget* {
      for (ads::CDockWidget* dock : docks.docks(id)) {
        if (dock->isVisible() && !dock->isInFloatingContainer()) return dock;
      }
      return nullptr;
    };
  };
  const auto child = [&window](const char* name) {
    return [&window, name = QString::fromLatin1(name)] { return window.findChild<QWidget*>(name); };
  };
  steps_ = {
      {tr("A robot and its program"),
       tr("This is the field of a simulated robot. Its whole program runs here, too, and you can look into "
          "it: "
          "what it sees, what it believes, what it decides. Drag to look around, turn the wheel to zoom. "
          "Real "
          "robots and log files are shown in the same views."),
       view("scene")},
      {tr("Play, pause, step"),
       tr("F5 starts, F6 pauses, F10 takes one step of "
          "8 ms, Ctrl+R resets. Shift+Esc is STOP: it "
          "halts the robot, whatever its program does."),
       child("simulationToolBar")},
      {tr("Debug keys"),
       tr("Type \"ball\", choose a key and press Enter: the program then publishes this drawing, plot or "
          "package, and views show it. In Solutions, next to it, a click switches a task to another "
          "solution."),
       view("debug-keys")},
      {tr("Time"),
       tr("Ctrl+Space freezes all views, while the robot continues. In the timeline you then go back "
          "and "
          "forth, for live robots as for logs; \"live\" returns to now."),
       [&window]() -> QWidget* { return window.statusBar(); }},
      {tr("Views and perspectives"),
       tr("The menu View lists all views; drag their tabs to arrange them, even out of the window. Window > "
          "Perspective has arrangements for one job: colors, motions, logs, and your own."),
       [&window]() -> QWidget* { return window.menuBar(); }},
      {tr("Logs and other robots"),
       tr("Drop a log file on the window to open it. Robot > Connect… finds robots in your network; "
          "Ctrl+Shift+R records what the robot sends, and the log runs through the program again."),
       {}},
      {tr("Find everything by name"),
       tr("Ctrl+P finds every command and menu entry. "
          "F1 opens the manual at the page of the "
          "focused view. Help > Tour shows this again."),
       {}}};
}

void Tour::start() {
  QFrame::show();
  placing_.start();
  show(0);
  next_->setFocus();
}

void Tour::stop() {
  placing_.stop();
  mark_->hide();
  hide();
}

void Tour::show(int step) {
  if (step >= stepCount()) return stop();
  step_ = std::max(step, 0);
  const Step& shown = steps_[static_cast<std::size_t>(step_)];
  title_->setText(shown.title);
  text_->setText(shown.text);
  count_->setText(tr("%1 of %2").arg(step_ + 1).arg(stepCount()));
  back_->setEnabled(step_ > 0);
  next_->setText(step_ + 1 < stepCount() ? tr("&Next") : tr("&Done"));
  place();
}

void Tour::place() {
  const QWidget& window = *parentWidget();
  const int width =
      std::min(fontMetrics().averageCharWidth() * kPanelCharacters, window.width() - 2 * kPanelMargin);
  const int height = layout()->hasHeightForWidth() ? layout()->heightForWidth(width) : sizeHint().height();
  const int right = window.width() - width - kPanelMargin;
  setGeometry(right, window.height() - height - 2 * kPanelMargin, width, height);
  const auto& target = steps_[static_cast<std::size_t>(step_)].target;
  const QWidget* part = target ? target() : nullptr;
  mark_->setVisible(part != nullptr && part->isVisible());
  if (part != nullptr) {
    const QRect place(part->mapTo(&window, QPoint(0, 0)), part->size());
    mark_->setGeometry(place.adjusted(-kMarkMargin, -kMarkMargin, kMarkMargin, kMarkMargin) & window.rect());
  }
  mark_->raise();
  raise();
}

void Tour::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && event->modifiers() == Qt::NoModifier) return stop();
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    if (auto* button = qobject_cast<QPushButton*>(focusWidget())) return button->click();
  }
  QFrame::keyPressEvent(event);
}

bool Tour::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && isVisible()) place();
  return QFrame::eventFilter(watched, event);
}

}  // namespace app
