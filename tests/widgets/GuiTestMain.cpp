// SPDX-License-Identifier: GPL-3.0-or-later
// The main() of all test programs with a GUI: many classes of tests in one program, because linking takes
// longer than most of them. PROGRAM [CLASS [FUNCTION...]] runs one class, or some of its functions.
#include <QApplication>
#include <cstdio>

#include "robotlink/base/KeptMemory.h"
#include "tests/widgets/Bench.h"

namespace widgets::test {

std::vector<GuiTestMaker>& guiTests() {
  static std::vector<GuiTestMaker> tests;
  return tests;
}

namespace {

QString nameOf(const QObject& test) {
  return QString::fromLatin1(test.metaObject()->className()).section(QStringLiteral("::"), -1);
}

/// Runs the class with a name, or all of them; returns the number of failures.
int run(const QString& wanted, const QStringList& arguments) {
  int failures = 0;
  bool found = false;
  for (const GuiTestMaker make : guiTests()) {
    const auto test = make();
    if (!wanted.isEmpty() && nameOf(*test) != wanted) continue;
    found = true;
    failures += QTest::qExec(test.get(), arguments);
  }
  if (!found) std::fprintf(stderr, "There is no class of tests named %s.\n", qPrintable(wanted));
  return found ? failures : 1;
}

}  // namespace
}  // namespace widgets::test

int main(int argc, char** argv) {
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  // QtTest ends a function after five minutes, in the midst of a soak test, and on a busy machine, where its
  // watch misses that another function has begun, the class. The limit is that of ctest.
  const double soak = qEnvironmentVariable("ROBOTCONTROL_SOAK_SECONDS").toDouble();
  if (!qEnvironmentVariableIsSet("QTEST_FUNCTION_TIMEOUT"))
    qputenv("QTEST_FUNCTION_TIMEOUT", QByteArray::number(static_cast<qint64>(1000 * (2 * soak + 3600))));
  robotlink::keepFreedMemory();
  QApplication application(argc, argv);
  const widgets::test::BenchHome home;
  QStringList arguments = QApplication::arguments();
  const bool isNamed = arguments.size() > 1 && !arguments[1].startsWith(QLatin1Char('-'));
  const QString wanted = isNamed ? arguments.takeAt(1) : QString();
  return widgets::test::run(wanted, arguments);
}
