// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/commands/CommandLine.h"

#include <gmock/gmock.h>

namespace robotlink {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// The words of a line as "column:text".
std::vector<std::string> shownWords(const std::vector<CommandWord>& words) {
  std::vector<std::string> texts;
  for (const CommandWord& word : words) texts.push_back(std::to_string(word.column) + ":" + word.text);
  return texts;
}

std::vector<std::string> wordsOfLine(const std::string& line) {
  const auto words = splitCommandLine(line);
  EXPECT_TRUE(words) << line;
  return words ? shownWords(*words) : std::vector<std::string>{};
}

TEST(SplitCommandLine, wordsHaveTheirColumns) {
  EXPECT_THAT(wordsOfLine("  go \t fast\r\n"), ElementsAre("3:go", "8:fast"));
  EXPECT_THAT(wordsOfLine(""), IsEmpty());
  EXPECT_THAT(wordsOfLine(" \t"), IsEmpty());
}

TEST(SplitCommandLine, aQuotedPartBelongsToItsWordEvenIfItIsEmpty) {
  EXPECT_THAT(wordsOfLine("a\"b c\"'d'e '' \"\""), ElementsAre("1:ab cde", "12:", "15:"));
}

TEST(SplitCommandLine, aBackslashEscapesInDoubleQuotesOnly) {
  EXPECT_THAT(wordsOfLine(R"("a\"b\\c\nd\t" 'e\n' f\n)"), ElementsAre("1:a\"b\\c\ndt", "16:e\\n", "22:f\\n"));
}

TEST(SplitCommandLine, aCommentBeginsWithAWord) {
  EXPECT_THAT(wordsOfLine("go # fast"), ElementsAre("1:go"));
  EXPECT_THAT(wordsOfLine("# go"), IsEmpty());
  EXPECT_THAT(wordsOfLine("go#fast '#' \"# b\""), ElementsAre("1:go#fast", "9:#", "13:# b"));
  EXPECT_THAT(wordsOfLine("go # it's \"open"), ElementsAre("1:go")) << "quotes in comments open nothing";
}

TEST(SplitCommandLine, aQuoteThatIsNotClosedHasItsColumn) {
  for (const char* line : {"say 'hello", "say \"hello", "say \"hello\\\""}) {
    const auto words = splitCommandLine(line);
    ASSERT_FALSE(words) << line;
    EXPECT_EQ(words.error().text, "the quote at column 5 is not closed") << line;
    EXPECT_EQ(words.error().where.column, 5) << line;
  }
  EXPECT_EQ(splitCommandLine("it's").error().where.column, 3) << "that of the quote, not of the word";
}

TEST(SplitUnfinishedLine, itKnowsWhetherTheLastWordGoesOn) {
  const auto inWord = [](const std::string& line) { return splitUnfinishedLine(line).isInWord; };
  EXPECT_TRUE(inWord("go fa"));
  EXPECT_FALSE(inWord("go fa "));
  EXPECT_FALSE(inWord(""));
  EXPECT_TRUE(inWord("go 'fa st"));
  EXPECT_TRUE(inWord("go 'fa st "));
  EXPECT_TRUE(inWord("go 'fast'")) << "more may follow the quote";
}

TEST(SplitUnfinishedLine, anOpenQuoteEndsWithTheLine) {
  EXPECT_THAT(shownWords(splitUnfinishedLine("go 'fa st").words), ElementsAre("1:go", "4:fa st"));
  EXPECT_THAT(shownWords(splitUnfinishedLine("go \"").words), ElementsAre("1:go", "4:"));
  EXPECT_THAT(shownWords(splitUnfinishedLine("go \"a\\").words), ElementsAre("1:go", "4:a\\"));
}

TEST(SplitUnfinishedLine, inACommentNothingIsCompleted) {
  const UnfinishedLine line = splitUnfinishedLine("go # fa");
  EXPECT_TRUE(line.isInComment);
  EXPECT_FALSE(line.isInWord);
  EXPECT_THAT(shownWords(line.words), ElementsAre("1:go"));
  EXPECT_FALSE(splitUnfinishedLine("go '# fa").isInComment);
  EXPECT_FALSE(splitUnfinishedLine("go fa#").isInComment);
}

TEST(QuotedWord, plainTextsStayAsTheyAre) {
  for (const char* text : {"go", "a#b", "C:\\x", "-5", "a=b;c", "größe"}) EXPECT_EQ(quotedWord(text), text);
}

TEST(QuotedWord, othersAreQuotedAsSimplyAsTheyCanBe) {
  EXPECT_EQ(quotedWord(""), "''");
  EXPECT_EQ(quotedWord("a b"), "'a b'");
  EXPECT_EQ(quotedWord("#b"), "'#b'");
  EXPECT_EQ(quotedWord("$x"), "'$x'") << "it is no variable";
  EXPECT_EQ(quotedWord("say \"hi\"\\"), "'say \"hi\"\\'");
  EXPECT_EQ(quotedWord("it's"), "\"it's\"");
  EXPECT_EQ(quotedWord("a\nb"), "\"a\\nb\"");
}

TEST(QuotedWord, isReadAsOneWordWhateverItHolds) {
  const std::string parts[] = {"a", " ", "'", "\"", "\\", "\n", "#", "$", "\t", "n"};
  for (const std::string& first : parts) {
    for (const std::string& second : parts) {
      for (const std::string& third : parts) {
        const std::string text = first + second + third;
        const auto words = splitCommandLine("x " + quotedWord(text) + " y");
        ASSERT_TRUE(words) << text;
        ASSERT_EQ(words->size(), 3U) << text;
        ASSERT_EQ((*words)[1].text, text);
      }
    }
  }
}

}  // namespace
}  // namespace robotlink
