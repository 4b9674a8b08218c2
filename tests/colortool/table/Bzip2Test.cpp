// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/table/Bzip2.h"

#include <bzlib.h>
#include <gtest/gtest.h>

namespace colortool {
namespace {

std::string asBzip2(std::string contents) {
  std::string out(contents.size() + contents.size() / 100 + 600, '\0');
  auto size = static_cast<unsigned>(out.size());
  EXPECT_EQ(BZ2_bzBuffToBuffCompress(out.data(), &size, contents.data(),
                                     static_cast<unsigned>(contents.size()), 9, 0, 0),
            BZ_OK);
  out.resize(size);
  return out;
}

std::string reasonOf(std::string_view bytes, std::size_t max = 1000) {
  const auto contents = decompressBzip2(bytes, max, "table.bz2");
  return contents ? "" : contents.error().describe();
}

TEST(Bzip2, contentsComeBackAsTheyWere) {
  for (const std::size_t size : {0U, 1U, 1000U, 1'000'000U}) {
    const std::string contents(size, 'x');
    const auto back = decompressBzip2(asBzip2(contents), size, "table.bz2");
    ASSERT_TRUE(back) << back.error().text;
    EXPECT_EQ(*back, contents);
  }
}

TEST(Bzip2, isRecognizedByItsFirstBytes) {
  EXPECT_TRUE(isBzip2(asBzip2("a")));
  EXPECT_FALSE(isBzip2("BZ"));
  EXPECT_FALSE(isBzip2(""));
}

TEST(Bzip2, contentsThatAreTooLargeAreRefusedBeforeTheyFillTheMemory) {
  const std::string bomb = asBzip2(std::string(50'000'000, '\0'));
  EXPECT_LT(bomb.size(), 1000U);
  EXPECT_NE(reasonOf(bomb).find("larger than 1000 bytes"), std::string::npos) << reasonOf(bomb);
  EXPECT_EQ(reasonOf(asBzip2(std::string(1000, 'x'))), "") << "as many as allowed";
}

TEST(Bzip2, damageIsReportedWithTheFileAndThePlace) {
  const std::string whole = asBzip2("some contents of a color table");
  EXPECT_EQ(reasonOf(whole.substr(0, whole.size() - 4)), "table.bz2: this bzip2 file is damaged: at byte " +
                                                             std::to_string(whole.size() - 4) +
                                                             " it ends too early");
  EXPECT_NE(reasonOf(whole + "more").find("there is extra data after its end"), std::string::npos);
  std::string flipped = whole;
  flipped[whole.size() / 2] = static_cast<char>(~flipped[whole.size() / 2]);
  EXPECT_NE(reasonOf(flipped).find("damaged"), std::string::npos);
}

}  // namespace
}  // namespace colortool
