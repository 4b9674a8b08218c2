// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sceneedit/SceneCompletion.h"

#include <gtest/gtest.h>

#include "tests/widgets/sceneedit/ToyLanguage.h"

namespace widgets::test {
namespace {

QStringList wordList(const char* text) {
  return QString::fromLatin1(text).split(QLatin1Char(' '));
}

std::vector<SceneProposal> proposalsAt(const char* marked) {
  QString text = QString::fromUtf8(marked);
  const int position = text.indexOf(QLatin1Char('|'));
  text.remove(position, 1);
  return sceneProposals(ToyLanguage(), xmlPlaceAt(text, position), "room.sdf");
}

QStringList shownAt(const char* marked) {
  QStringList shown;
  for (const SceneProposal& one : proposalsAt(marked)) shown << one.shown;
  return shown;
}

TEST(SceneCompletionTest, elementsAreProposedThatMayBeThere) {
  EXPECT_EQ(shownAt("<|"), wordList("sdf"));
  EXPECT_EQ(shownAt("<sdf><world name=\"w\"><|</world></sdf>"), wordList("model include"));
  EXPECT_EQ(shownAt("<sdf><world name=\"w\"><inc|</world></sdf>"), wordList("include"));
  EXPECT_EQ(shownAt("<sdf><nothing><|"), QStringList());
}

TEST(SceneCompletionTest, aProposedElementIsWhole) {
  const auto model = proposalsAt("<sdf><world><mod|</world></sdf>").front();
  EXPECT_EQ(model.text, QStringLiteral("model name=\"\"></model>"));
  // The cursor stands between the quotes.
  EXPECT_EQ(model.text.right(model.back), QStringLiteral("\"></model>"));
  const auto mass = proposalsAt("<sdf><world><model><link><m|").front();
  EXPECT_EQ(mass.text, QStringLiteral("mass>1</mass>"));
  EXPECT_EQ(mass.text.right(mass.back), QStringLiteral("</mass>"));
  EXPECT_TRUE(mass.help.contains(QStringLiteral("kg")));
}

TEST(SceneCompletionTest, attributesAreProposedThatAreMissing) {
  EXPECT_EQ(shownAt("<sdf><world><model |>"), wordList("name fixed"));
  EXPECT_EQ(shownAt("<sdf><world><model name=\"a\" |>"), wordList("fixed"));
  EXPECT_EQ(proposalsAt("<sdf><world><model f|>").front().text, QStringLiteral("fixed=\"\""));
  EXPECT_EQ(shownAt("<sdf><world><model fixed=\"t|\">"), wordList("true"));
}

TEST(SceneCompletionTest, valuesAndModelsAreProposed) {
  EXPECT_EQ(shownAt("<sdf><world><model><static>|</static>"), wordList("true false"));
  EXPECT_EQ(shownAt("<sdf><world><include><uri>model://r|</uri>"), wordList("model://rover"));
  EXPECT_EQ(shownAt("<sdf><world></|"), wordList("world"));
}

TEST(SceneCompletionTest, helpIsAboutTheWordAtThePlace) {
  const QString text =
      QStringLiteral("<sdf><world name=\"w\"><model fixed=\"true\"><link/></model></world></sdf>");
  const auto helpAt = [&](const char* word) {
    return sceneHelpAt(ToyLanguage(), text, text.indexOf(QLatin1String(word)) + 1);
  };
  EXPECT_TRUE(helpAt("link").contains(QStringLiteral("rigid body")));
  EXPECT_TRUE(helpAt("fixed").contains(QStringLiteral("Whether it stays")));
  EXPECT_TRUE(helpAt("fixed").contains(QStringLiteral("bool, default false")));
  EXPECT_TRUE(helpAt("/model").contains(QStringLiteral("A model of the world")));
  EXPECT_EQ(sceneHelpAt(ToyLanguage(), QStringLiteral("<sdf>text</sdf>"), 7), QString());
}

}  // namespace
}  // namespace widgets::test
