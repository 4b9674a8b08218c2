// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/samples/SampleFile.h"

#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "tests/TestFolder.h"
#include "tests/colortool/SampleFixture.h"

using namespace colortool;

namespace {

Samples richSamples() {
  Samples samples = quarterSamples();
  samples.settings.method = TrainingMethod::kGaussians;
  samples.settings.votes = {12.25, 0.4, 0.07, 0.5};
  samples.settings.supportVectors = {3, 1.0 / 3000, 33};
  samples.settings.cleanUp.fillHoles = false;
  samples.settings.correctCameras = true;
  ColorCorrection correction;
  correction.vignetting = {{-0.3, 0.01}, {2, 3}, {-1, 0.1}};
  correction.channels = {{{1.1, -4}, {0.97, 3}, {1, 0.1}}};
  samples.corrections = {{"other \"robot\"", correction}};
  const ColorImage image = quarters(64, 48, 15);
  addStroke(samples, {0, "später, 2.5 s", "other \"robot\"", "evening", 0, 0}, image,
            rectangleArea(64, 48, {3, 3}, {50, 40}), {2, true, 2.5, "rectangle"});
  return samples;
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

std::string joined(const std::vector<std::string>& all) {
  std::string text;
  for (const std::string& line : all) text += line + "\n";
  return text;
}

}  // namespace

TEST(SampleFile, whatWasWrittenIsReadAgain) {
  const Samples samples = richSamples();
  const auto read = parseSamples(samplesText(samples), "a.samples");
  ASSERT_TRUE(read) << read.error().describe();
  EXPECT_TRUE(read->problems.empty()) << robotlink::describe(read->problems);
  EXPECT_EQ(read->samples, samples);
  EXPECT_EQ(samplesText(read->samples), samplesText(samples));
}

TEST(SampleFile, aStrokeWithoutAThumbnailStaysAStroke) {
  Samples samples = quarterSamples();
  auto bare = std::make_shared<Stroke>(*samples.strokes[1]);
  bare->thumbnail = {};
  samples.strokes[1] = bare;
  const auto read = parseSamples(samplesText(samples), "a.samples");
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->problems.empty()) << robotlink::describe(read->problems);
  EXPECT_EQ(read->samples, samples);
}

TEST(SampleFile, filesAreWrittenWholeAndReadAgain) {
  const TestFolder folder;
  const auto file = folder.path() / "a.samples";
  ASSERT_TRUE(saveSamples(richSamples(), file));
  const auto read = loadSamples(file);
  ASSERT_TRUE(read) << read.error().describe();
  EXPECT_EQ(read->samples, richSamples());
  EXPECT_FALSE(saveSamples(richSamples(), file / "below a file"));
  EXPECT_FALSE(loadSamples(folder.path() / "b.samples"));
}

TEST(SampleFile, aDamagedLineCostsWhatItSaysAndNoMore) {
  const Samples samples = richSamples();
  std::vector<std::string> all = lines(samplesText(samples));
  const auto stroke =
      std::ranges::find_if(all, [](const auto& l) { return l.find("\"stroke\":2,") != l.npos; });
  ASSERT_NE(stroke, all.end());
  stroke->resize(stroke->size() / 2);
  const auto read = parseSamples(joined(all), "a.samples");
  ASSERT_TRUE(read);
  ASSERT_EQ(read->problems.size(), 1U);
  const auto number = static_cast<int>(stroke - all.begin()) + 1;
  EXPECT_EQ(read->problems[0].where.line, number);
  EXPECT_EQ(read->problems[0].describe().find("a.samples:" + std::to_string(number)), 0U);
  EXPECT_EQ(read->samples.strokes.size(), samples.strokes.size() - 1);
}

TEST(SampleFile, whatContradictsItselfIsSaid) {
  const auto problemWith = [](const std::string& from, const std::string& to) {
    std::string text = samplesText(quarterSamples());
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    const auto read = parseSamples(text, "f");
    return !read ? read.error().text : read->problems.empty() ? "" : read->problems[0].text;
  };
  EXPECT_NE(problemWith("\"stroke\":1,\"image\":1", "\"stroke\":1,\"image\":7").find("no image 7"),
            std::string::npos);
  EXPECT_NE(problemWith("\"stroke\":2", "\"stroke\":1").find("a stroke 1 before it"), std::string::npos);
  EXPECT_NE(problemWith("\"image\":1,\"class\":\"green\"", "\"image\":1,\"class\":\"grün\"").find("no class"),
            std::string::npos);
  EXPECT_NE(problemWith("\"weight\":1.0", "\"weight\":-1.0").find("weight"), std::string::npos);
  EXPECT_NE(problemWith("\"runs\":[", "\"runs\":[3,").find("three numbers"), std::string::npos);
  EXPECT_NE(problemWith("\"runs\":[4", "\"runs\":[400").find("not pixels"), std::string::npos);
  EXPECT_NE(problemWith("\"colors\":\"8c", "\"colors\":\"8x").find("digits"), std::string::npos);
  EXPECT_NE(problemWith("\"colors\":\"8c3cc8", "\"colors\":\"").find("28 colors for 29 pixels"),
            std::string::npos);
  EXPECT_NE(problemWith("\"width\":40", "\"width\":4000000").find("width"), std::string::npos);
  EXPECT_NE(problemWith("\"method\":\"votes\"", "\"method\":\"magic\"").find("magic"), std::string::npos);
  EXPECT_NE(problemWith("\"version\":1", "\"version\":2").find("version 2"), std::string::npos);
  EXPECT_NE(problemWith("robotcontrol samples", "something else").find("not a samples file"),
            std::string::npos);
}

TEST(SampleFile, aValueOfAnotherTypeIsAProblemOfItsLine) {
  const auto problemWith = [](const std::string& from, const std::string& to) {
    std::string text = samplesText(quarterSamples());
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    const auto read = parseSamples(text, "f");
    return !read ? read.error().text : read->problems.empty() ? "" : read->problems[0].text;
  };
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"\"format\":\"robotcontrol samples\"", "\"format\":5"},
      {"\"format\":\"robotcontrol samples\"", "\"format\":[1]"},
      {"\"version\":1", "\"version\":\"1\""},
      {"\"version\":1", "\"version\":1e99"},
      {"\"version\":1", "\"version\":18446744073709551615"},
      {"\"method\":\"votes\"", "\"method\":7"},
      {"\"votes\":{", "\"votes\":7,\"x\":{"},
      {"\"class\":\"green\"", "\"class\":7"},
      {"\"stroke\":1", "\"stroke\":-1"},
      {"\"stroke\":1", "\"stroke\":1.5"},
      {"\"width\":40", "\"width\":1e300"},
      {"\"width\":40", "\"width\":\"40\""},
      {"\"weight\":1.0", "\"weight\":true"},
      {"\"weight\":1.0", "\"weight\":1e999"},
      {"\"must_not_be\":false", "\"must_not_be\":0"},
      {"\"runs\":[", "\"runs\":[1e300,"},
      {"\"runs\":[", "\"runs\":\"\",\"x\":["},
      {"\"name\":\"", "\"name\":7,\"x\":\""},
      {"\"thumbnail\":{", "\"thumbnail\":0,\"x\":{"}};
  for (const auto& [from, to] : cases) {
    const std::string problem = problemWith(from, to);
    EXPECT_FALSE(problem.empty()) << to;
    EXPECT_EQ(problem.find("exception"), std::string::npos) << problem;
  }
}

TEST(SampleFile, anyBytesAreReadWithoutHarm) {
  const std::string good = samplesText(richSamples());
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round) {
    std::string bad = good.substr(0, random() % 4 == 0 ? random() % good.size() : good.size());
    for (int flips = 0; flips < 8 && !bad.empty(); ++flips)
      bad[random() % bad.size()] = static_cast<char>(random());
    const auto read = parseSamples(bad, "f");
    if (!read) continue;
    for (const StrokePtr& stroke : read->samples.strokes)
      EXPECT_EQ(stroke->colors.size(), pixelCount(stroke->area));
  }
}
