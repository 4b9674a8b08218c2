// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/solutions/ParameterModel.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QtTest>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "tests/widgets/GuiTest.h"

namespace widgets::test {
namespace {

/// Parameters with a list of groups.
robotcontrol::SonarReadings sonars(int count) {
  robotcontrol::SonarReadings sonars;
  sonars.set_maximum(5);
  for (int i = 0; i < count; ++i) sonars.add_readings()->set_range(i + 1);
  return sonars;
}

QByteArray bytesOf(const robotcontrol::SonarReadings& value) {
  return QByteArray::fromStdString(value.SerializeAsString());
}

}  // namespace

class ParameterModelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    robotcontrol::ParameterValues values;
    values.mutable_value()->set_type(sonars(2).GetTypeName());
    values.mutable_value()->set_data(sonars(2).SerializeAsString());
    QVERIFY(model_.setParameters(values));
  }

  void rowsFollowAListThatBecomesShorterOrLonger() {
    const QAbstractItemModelTester tester(&model_, QAbstractItemModelTester::FailureReportingMode::QtTest);
    const int before = model_.rowCount();
    model_.setValue(bytesOf(sonars(4)));
    QCOMPARE(model_.rowCount(), before + 2);
    QCOMPARE(valueOf("readings[3].range"), QStringLiteral("4"));
    model_.setValue(bytesOf(sonars(1)));
    QCOMPARE(model_.rowCount(), before - 1);
    QCOMPARE(valueOf("readings[0].range"), QStringLiteral("1"));
    QCOMPARE(valueOf("readings[1].range"), QString());
  }

  void otherValuesAloneKeepTheRows() {
    const QSignalSpy resets(&model_, &QAbstractItemModel::modelReset);
    robotcontrol::SonarReadings changed = sonars(2);
    changed.mutable_readings(1)->set_range(7);
    model_.setValue(bytesOf(changed));
    QCOMPARE(resets.count(), 0);
    QCOMPARE(valueOf("readings[1].range"), QStringLiteral("7"));
    model_.setValue(QByteArray("\xff\xff no message"));
    QCOMPARE(valueOf("readings[1].range"), QStringLiteral("7"));
  }

 private:
  /// The value in the row of a field; empty if there is no such row.
  QString valueOf(const char* path, const QModelIndex& parent = {}) const {
    for (int row = 0; row < model_.rowCount(parent); ++row) {
      const QModelIndex field = model_.index(row, ParameterModel::kField, parent);
      if (model_.data(field, ParameterModel::kPathRole).toString() == QLatin1String(path))
        return model_.data(model_.index(row, ParameterModel::kValue, parent), Qt::DisplayRole).toString();
      if (const QString below = valueOf(path, field); !below.isEmpty()) return below;
    }
    return {};
  }

  ParameterModel model_;
};

const GuiTest<ParameterModelTest> kParameterModelTest;

}  // namespace widgets::test

#include "ParameterModelTest.moc"
