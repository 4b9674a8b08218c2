// SPDX-License-Identifier: GPL-3.0-or-later
// Files of samples, lists of strokes and lists of classes.

#include "colortool/samples/SampleFile.h"
#include "colortool/samples/StrokeList.h"
#include "colortool/table/NamedColorTable.h"
#include "colortool/training/TableTrainer.h"
#include "tests/colortool/SampleFixture.h"
#include "tests/fuzz/FuzzTarget.h"

namespace sample_file_fuzz {

using namespace colortool;

namespace {

void checkSamples(const Samples& samples) {
  std::uint64_t last = 0;
  for (const StrokePtr& stroke : samples.strokes) {
    const SampleImage* image = samples.image(stroke->image);
    require(image != nullptr, "each stroke has its image");
    require(isValid(stroke->area, image->width, image->height), "each stroke is inside of it");
    require(stroke->colors.size() == pixelCount(stroke->area), "each pixel has a color");
    require(stroke->colorClass < samples.classes.size(), "each stroke has a class");
    require(stroke->id > last || last == 0, "strokes are sorted");
    last = stroke->id;
  }
  const auto again = parseSamples(samplesText(samples), "again");
  require(again && again->problems.empty() && again->samples == samples,
          "samples are read as they were written");
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto read = parseSamples(bytes, "fuzz");
  if (read)
    checkSamples(read->samples);
  else
    require(!read.error().text.empty(), "a refusal says why");
  if (const auto strokes = parseStrokeList(bytes, "fuzz"); !strokes)
    require(!strokes.error().empty(), "a refusal has a reason");
  if (const auto classes = parseColorClasses(bytes, "fuzz"); !classes)
    require(!classes.error().empty(), "a refusal has a reason");
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  Samples samples = quarterSamples();
  samples.corrections = {{"nao", {}}};
  restate(samples, {2}, {2, true, 3});
  return {samplesText(samples), samplesText(emptySamples()), colorClassesText(samples.classes),
          "image,class,x,y,radius\n000.yuyv,orange,12,13.5,3\n000.yuyv,background,1e3,-1,0\n"};
}

const FuzzRegistration kTarget({"sample_file", &fuzzSeeds, &runInput});

}  // namespace sample_file_fuzz
