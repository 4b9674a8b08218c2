// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/Bench.h"

#include <QAbstractButton>
#include <QDir>
#include <QHelpEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>
#include <cstdio>
#include <cstdlib>

#include "robotlink/config/FieldDescription.h"
#include "robotlink/packages/Checksum.h"
#include "widgets/controls/ToolRow.h"

namespace widgets::test {
namespace {

QtMessageHandler previousHandler = nullptr;

void failOnWarning(QtMsgType type, const QMessageLogContext& where, const QString& text) {
  if (text.startsWith(QLatin1String("This plugin does not support"))) return;
  if (type == QtWarningMsg || type == QtCriticalMsg) {
    std::fprintf(stderr, "Qt warns: %s\n", qPrintable(text));
    std::abort();
  }
  if (previousHandler != nullptr) previousHandler(type, where, text);
}

std::shared_ptr<const robotlink::FieldDescription> field2002() {
  auto field = robotlink::FieldDescription::load(ROBOTCONTROL_SOURCE_DIR "/resources/fields/2002.yaml");
  if (!field) qFatal("%s", robotlink::describe(field.error()).c_str());
  return std::make_shared<const robotlink::FieldDescription>(std::move(*field));
}

}  // namespace

Bench::Bench(const Options& options) {
  if (options.field) context.field = field2002();
  session.setRobots(options.robots);
  session.setRequestSink([this, answers = options.answers](const robotcontrol::Request& request) {
    requests.push_back(request);
    if (answers) answer(request, refusal.empty(), refusal);
  });
}

void Bench::advance(int milliseconds) {
  now_ += std::chrono::milliseconds(milliseconds);
  session.tick();
}

void Bench::answer(const robotcontrol::Request& request, bool accepted, const std::string& reason) {
  robotcontrol::RequestResult result;
  result.set_id(request.id());
  result.set_accepted(accepted);
  result.set_reason(reason);
  if (request.has_set_color_table())
    result.set_checksum(robotlink::checksum(request.set_color_table().table()) + wrongChecksum);
  session.pushResult(result);
}

BenchHome::BenchHome() {
  const QByteArray home = folder_.path().c_str();
  std::filesystem::permissions(folder_.path(), std::filesystem::perms::owner_all);
  qputenv("XDG_CONFIG_HOME", home);
  qputenv("XDG_RUNTIME_DIR", home);
  qputenv("ROBOTCONTROL_RESOURCES", ROBOTCONTROL_SOURCE_DIR "/resources");
  previousHandler = qInstallMessageHandler(failOnWarning);
}

std::filesystem::path BenchHome::path() {
  return qgetenv("XDG_CONFIG_HOME").toStdString();
}

void moveMouse(QWidget& widget, const QPoint& to, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers) {
  QApplication::processEvents();
  QMouseEvent event(QEvent::MouseMove, to, widget.mapToGlobal(to), Qt::NoButton, buttons, modifiers);
  QApplication::sendEvent(&widget, &event);
}

void drag(QWidget& widget, Qt::MouseButton button, const QPoint& from, const QPoint& to,
          const std::function<void()>& moved, Qt::KeyboardModifiers modifiers) {
  moveMouse(widget, from, Qt::NoButton, modifiers);
  QTest::mousePress(&widget, button, modifiers, from);
  for (const QPoint& at : {(from + to) / 2, to}) {
    moveMouse(widget, at, button, modifiers);
    if (moved) moved();
  }
  QTest::mouseRelease(&widget, button, modifiers, to);
}

void turnWheel(QWidget& widget, const QPoint& at, int notches) {
  QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(&widget, &event);
}

void click(QWidget& widget) {
  QApplication::processEvents();  // rows of tools may have another layout now
  auto* button = qobject_cast<RowButton*>(&widget);
  if (button == nullptr || !button->isLeftOut()) return QTest::mouseClick(&widget, Qt::LeftButton);
  QMenu* menu = button->parentWidget()->findChild<QToolButton*>(QStringLiteral("moreTools"))->menu();
  Q_EMIT menu->aboutToShow();
  QVERIFY(menu->actions().contains(button->defaultAction()));
  button->defaultAction()->trigger();
}

void click(const QWidget& parent, const char* button) {
  click(child<QAbstractButton>(parent, button));
}

QString shownTip(QWidget& widget, const QPoint& at) {
  QHelpEvent help(QEvent::ToolTip, at, widget.mapToGlobal(at));
  QApplication::sendEvent(&widget, &help);
  const QString text = QToolTip::text();
  QToolTip::hideText();
  return text;
}

QModelIndex find(const QTreeView& tree, const QString& text, int column) {
  const auto hits = tree.model()->match(tree.model()->index(0, 0), Qt::DisplayRole, text, 1,
                                        Qt::MatchExactly | Qt::MatchRecursive);
  return hits.isEmpty() ? QModelIndex() : hits.first().siblingAtColumn(column);
}

void clickCell(QTreeView& tree, const QModelIndex& index) {
  tree.scrollTo(index);
  QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, tree.visualRect(index).center());
}

bool isNear(const QColor& a, const QColor& b, int tolerance) {
  const auto close = [tolerance](int x, int y) { return std::abs(x - y) <= tolerance; };
  return close(a.red(), b.red()) && close(a.green(), b.green()) && close(a.blue(), b.blue());
}

int countNear(const QImage& picture, const QColor& color, int tolerance) {
  int count = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x)
      count += isNear(picture.pixelColor(x, y), color, tolerance) ? 1 : 0;
  }
  return count;
}

void keepPicture(const QImage& picture, const char* name) {
  const QString folder = qEnvironmentVariable("ROBOTCONTROL_TEST_PICTURES");
  if (folder.isEmpty()) return;
  QDir().mkpath(folder);
  if (!picture.save(folder + QLatin1Char('/') + QLatin1String(name) + QStringLiteral(".png")))
    qFatal("a picture cannot be saved in %s", qPrintable(folder));
}

void keepPicture(QWidget& widget, const char* name) {
  if (qEnvironmentVariableIsEmpty("ROBOTCONTROL_TEST_PICTURES")) return;
  QApplication::processEvents();
  keepPicture(widget.grab().toImage(), name);
  const QPalette light = QApplication::palette();
  QApplication::setPalette(QPalette(QColor(53, 58, 64), QColor(40, 44, 50)));
  QTest::qWait(400);  // pictures that are drawn elsewhere follow
  keepPicture(widget.grab().toImage(), (std::string(name) + "-dark").c_str());
  QApplication::setPalette(light);
}

}  // namespace widgets::test
