// SPDX-License-Identifier: GPL-3.0-or-later
// What all views of the registry have in common: numbers to copy, and menus in which nothing is said twice.
#include <QAbstractScrollArea>
#include <QContextMenuEvent>
#include <QMenu>
#include <QPointer>
#include <QTimer>
#include <memory>
#include <set>
#include <vector>

#include "tests/widgets/CameraBench.h"
#include "tests/widgets/ShownColorImage.h"
#include "widgets/color/space/ColorSpaceView.h"
#include "widgets/field/FieldView.h"

namespace widgets::test {
namespace {

/// A view that is shown, of a robot that sees, on a field.
struct AnyView {
  explicit AnyView(const ViewType& type) {
    world.pushScene();
    world.pushPoses({-1, 0.5, 0.3}, {0.5, -0.4});
    world.show();
    view.reset(type.create(world.context, nullptr));
    view->resize(700, 500);
    view->show();
    if (!QTest::qWaitForWindowExposed(view.get())) qFatal("the view is not shown");
    world.tick(*view);
  }
  CameraBench world;
  std::unique_ptr<View> view;
};

/// The texts that are more than once in a menu, or in one that it opens.
QStringList repeatedIn(const QList<QAction*>& actions) {
  QStringList repeated;
  std::set<QString> seen;
  for (const QAction* action : actions) {
    if (action->isSeparator() || !action->isVisible()) continue;
    const QString text = QString(action->text()).remove(QLatin1Char('&')).section(QLatin1Char('\t'), 0, 0);
    if (!seen.insert(text).second) repeated << text;
    if (action->menu() != nullptr) repeated << repeatedIn(action->menu()->actions());
  }
  return repeated;
}

/// What is repeated in the menu of a part of a view.
QStringList repeatedInMenuOf(QWidget& part) {
  QStringList repeated;
  const auto look = [&] {
    for (int i = 0; i < 10; ++i) {
      auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
      if (menu == nullptr) return;
      repeated << repeatedIn(menu->actions());
      menu->close();
    }
  };
  // Some menus block until they are closed.
  QTimer::singleShot(0, &part, look);
  const QPoint at = part.rect().center();
  QContextMenuEvent event(QContextMenuEvent::Mouse, at, part.mapToGlobal(at));
  QApplication::sendEvent(&part, &event);
  look();
  QCoreApplication::processEvents();
  look();
  return repeated;
}

}  // namespace

class AllViewsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void everyViewGivesItsNumbers() {
    for (const ViewType& type : ViewRegistry::all()) {
      AnyView any(type);
      const auto numbers = any.view->numbers();
      QVERIFY2(numbers.has_value(), type.id);
      QVERIFY2(numbers->isEmpty() || numbers->endsWith(QLatin1Char('\n')), type.id);
    }
  }

  void noMenuOfAViewHasAnEntryTwice() {
    int menus = 0;
    for (const ViewType& type : ViewRegistry::all()) {
      AnyView any(type);
      std::vector<QPointer<QWidget>> parts{any.view.get()};
      for (QWidget* part : any.view->findChildren<QWidget*>()) parts.emplace_back(part);
      for (const auto& part : parts) {
        if (!part || !part->isVisible()) continue;
        if (part->contextMenuPolicy() == Qt::ActionsContextMenu) {
          ++menus;
          const QStringList repeated = repeatedIn(part->actions());
          QVERIFY2(repeated.isEmpty(), qPrintable(QLatin1String(type.id) + repeated.join(QLatin1Char(','))));
        }
        const bool isOwn = part->contextMenuPolicy() == Qt::CustomContextMenu || part == any.view.get();
        if (!isOwn) continue;
        ++menus;
        auto* area = qobject_cast<QAbstractScrollArea*>(part.data());
        const QStringList repeated = repeatedInMenuOf(area == nullptr ? *part : *area->viewport());
        QVERIFY2(repeated.isEmpty(), qPrintable(QLatin1String(type.id) + repeated.join(QLatin1Char(','))));
      }
    }
    QVERIFY(menus > 40);
  }

  void theFieldSaysWhereEverythingIs() {
    CameraBench world;
    world.pushScene();
    world.pushPoses({-1, 0.5, 0.3}, {0.5, -0.4});
    world.pushEstimates({-0.9, 0.4, 0.2}, {1, 0});
    auto view = world.open<FieldView>();
    world.advance();
    world.tick(*view);
    const QString table = *view->numbers();
    QVERIFY(table.startsWith(QStringLiteral("figure\tof\tx m\ty m\theading deg")));
    QVERIFY2(table.contains(QStringLiteral("\nball\tball\t0.5000\t-0.4000\n")), qPrintable(table));
    QVERIFY2(table.contains(QStringLiteral("\nrobot\tred1\t-1.0000\t0.5000\t17.1887\n")), qPrintable(table));
    QVERIFY2(table.contains(QStringLiteral("\nestimate\tred1\t-0.9000\t0.4000\t11.4592\t")),
             qPrintable(table));
    QVERIFY2(table.contains(QStringLiteral("\nestimated ball\tred1\t")), qPrintable(table));
  }

  void aColorImageGivesColorAndClassOfEachPixel() {
    ShownColorImage s;
    s.choose("orange");
    s.click(5, 5);
    const QStringList rows = s.view.numbers()->split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    QCOMPARE(rows.size(), 1 + 40 * 30);
    QCOMPARE(rows.front(), QStringLiteral("x\ty\tY\tCb\tCr\tclass"));
    const QStringList pixel = rows.at(1 + 5 * 40 + 5).split(QLatin1Char('\t'));
    QCOMPARE(pixel.at(0) + pixel.at(1), QStringLiteral("55"));
    QCOMPARE(pixel.at(5), QStringLiteral("orange"));

    ColorSpaceView space(s.world.context);
    space.tick();
    const QString colors = *space.numbers();
    QVERIFY(colors.startsWith(QStringLiteral("of\tY\tCb\tCr\tpixels\tclass\n")));
    int pixels = 0;
    for (const QString& row : colors.split(QLatin1Char('\n')))
      if (row.startsWith(QLatin1String("image\t"))) pixels += row.section(QLatin1Char('\t'), 4, 4).toInt();
    QCOMPARE(pixels, 40 * 30);
    QVERIFY(colors.contains(QStringLiteral("\ntable\t")) && colors.contains(QStringLiteral("\t\torange\n")));
  }
};

const GuiTest<AllViewsTest> kAllViewsTest;

}  // namespace widgets::test

#include "AllViewsTest.moc"
