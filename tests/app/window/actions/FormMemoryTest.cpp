// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/FormMemory.h"

#include <QJsonArray>
#include <QtTest>

#include "app/core/platform/PlatformAdapter.h"
#include "tests/widgets/GuiTest.h"

namespace app::test {
namespace {

using Kind = PlatformField::Kind;

PlatformField numberField(const char* name, const char* place) {
  PlatformField field;
  field.name = name;
  field.kind = Kind::kNumber;
  field.initial = 1.0;
  field.noun = name;
  field.max = 10;
  field.remembered = place;
  return field;
}

PlatformField textField(const char* name, const char* place, bool recent = false) {
  PlatformField field;
  field.name = name;
  field.remembered = place;
  field.recent = recent;
  return field;
}

PlatformForm formWith(std::vector<PlatformField> fields) {
  PlatformForm form;
  form.fields = std::move(fields);
  return form;
}

QJsonObject saved(const FormMemory& memory) {
  QJsonObject window;
  memory.save(window);
  return window;
}

}  // namespace

class FormMemoryTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void whatWasAcceptedIsThereTheNextTime() {
    const auto form = formWith({numberField("speed", "setup/0"), textField("map", "robot_map"),
                                numberField("robots", "setup/2"), textField("secret", "")});
    FormMemory memory;
    QVERIFY(memory.valuesOf(form).empty());
    const FormValues values{
        {"speed", 2.0}, {"map", std::string("a.map")}, {"robots", 3.0}, {"secret", std::string("token")}};
    memory.remember(form, values);
    FormValues kept = values;
    kept.erase("secret");
    QVERIFY(memory.valuesOf(form) == kept);
  }

  void fieldsOfAListHaveTheirPlacesInIt() {
    FormMemory memory;
    memory.remember(formWith({numberField("robots", "setup/2")}), {{"robots", 3.0}});
    QCOMPARE(saved(memory).value(QStringLiteral("setup")),
             QJsonValue(QJsonArray{QJsonValue(), QJsonValue(), 3.0}));
    memory.remember(formWith({numberField("speed", "setup/0")}), {{"speed", 2.0}});
    QCOMPARE(saved(memory).value(QStringLiteral("setup")), QJsonValue(QJsonArray{2.0, QJsonValue(), 3.0}));
  }

  void whatTheUserLeftOpenStaysAsItWas() {
    const auto form = formWith({numberField("speed", "setup/0"), numberField("robots", "setup/1")});
    FormMemory memory;
    memory.remember(form, {{"speed", 2.0}, {"robots", 3.0}});
    memory.remember(form, {{"robots", 4.0}});
    QVERIFY(memory.valuesOf(form) == (FormValues{{"speed", 2.0}, {"robots", 4.0}}));
  }

  void valuesThatAFieldCannotHaveAreSkipped() {
    const auto numbers = formWith({numberField("speed", "place")});
    FormMemory memory;
    memory.remember(formWith({textField("speed", "place")}), {{"speed", std::string("fast")}});
    QVERIFY2(memory.valuesOf(numbers).empty(), "a text");
    memory.remember(numbers, {{"speed", 11.0}});
    QVERIFY2(memory.valuesOf(numbers).empty(), "more than the maximum of a newer version");
    memory.remember(numbers, {{"speed", 10.0}});
    QVERIFY(!memory.valuesOf(numbers).empty());
  }

  void theLastTenTextsAreKeptTheNewestFirstEachOnce() {
    const PlatformField field = textField("address", "addresses", true);
    const auto form = formWith({field});
    FormMemory memory;
    QVERIFY(memory.recent(field).isEmpty());
    for (int i = 1; i <= 12; ++i) memory.remember(form, {{"address", "tcp://robot" + std::to_string(i)}});
    QCOMPARE(memory.recent(field).size(), FormMemory::kMaxRecent);
    QCOMPARE(memory.recent(field).first(), QStringLiteral("tcp://robot12"));
    QCOMPARE(memory.recent(field).last(), QStringLiteral("tcp://robot3"));
    memory.remember(form, {{"address", std::string("tcp://robot5")}});
    QCOMPARE(memory.recent(field).mid(0, 2),
             (QStringList{QStringLiteral("tcp://robot5"), QStringLiteral("tcp://robot12")}));
    QCOMPARE(memory.recent(field).count(QStringLiteral("tcp://robot5")), 1);
    QVERIFY(memory.valuesOf(form) == (FormValues{{"address", std::string("tcp://robot5")}}));
    QVERIFY2(memory.recent(textField("address", "addresses")).isEmpty(), "a field without recent values");
  }

  void theStateOfTheWindowKeepsWhatElseIsInIt() {
    FormMemory memory;
    memory.remember(formWith({textField("map", "robot_map")}), {{"map", std::string("a.map")}});
    QJsonObject window{{QStringLiteral("theme"), QStringLiteral("dark")},
                       {QStringLiteral("robot_map"), QStringLiteral("old.map")}};
    memory.save(window);
    QCOMPARE(window, (QJsonObject{{QStringLiteral("theme"), QStringLiteral("dark")},
                                  {QStringLiteral("robot_map"), QStringLiteral("a.map")}}));
  }

  void everyPlaceOfAnAdapterIsReadAgain() {
    int places = 0;
    for (const PlatformAdapter& adapter : platformAdapters()) {
      const PlatformForm form = formOf(adapter);
      FormMemory memory, again;
      FormValues values = initialValues(form);
      for (const PlatformField& field : form.fields) {
        if (field.kind == Kind::kText || field.kind == Kind::kFile) values[field.name] = std::string();
      }
      memory.remember(form, values);
      again.load(saved(memory));
      QCOMPARE(saved(again), saved(memory));
      places += saved(memory).size();
    }
    QVERIFY(places > 1);
  }

  void whatIsInTheFileByMistakeDoesNoHarm() {
    const PlatformField recent = textField("address", "recent_robots", true);
    FormMemory memory;
    memory.load({{QStringLiteral("recent_robots"), QJsonArray{1, QJsonValue(), QStringLiteral("tcp://a")}},
                 {QStringLiteral("simulation_setup"), QStringLiteral("no list")},
                 {QStringLiteral("unknown"), 5}});
    QVERIFY(memory.recent(recent).contains(QStringLiteral("tcp://a")));
    QVERIFY(memory.valuesOf(formWith({recent})).empty());
    QVERIFY(memory.valuesOf(formWith({numberField("robots", "simulation_setup/1")})).empty());
    QVERIFY(!saved(memory).contains(QStringLiteral("unknown")));
    memory.remember(formWith({numberField("robots", "simulation_setup/1")}), {{"robots", 4.0}});
    QVERIFY(memory.valuesOf(formWith({numberField("robots", "simulation_setup/1")})) ==
            (FormValues{{"robots", 4.0}}));
  }
};

const widgets::test::GuiTest<FormMemoryTest> kFormMemoryTest;

}  // namespace app::test

#include "FormMemoryTest.moc"
