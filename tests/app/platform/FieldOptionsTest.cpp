// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/FieldOptions.h"

#include <gmock/gmock.h>

#include <CLI/CLI.hpp>

#include "app/core/platform/NumberRange.h"
#include "app/core/platform/PlatformAdapter.h"

using namespace app;
using testing::HasSubstr;
using testing::Not;

namespace {

/// A command line with the options of all adapters, as the window's program has it.
class OptionsOfAdapters : public testing::Test {
 protected:
  OptionsOfAdapters() {
    for (const PlatformAdapter& adapter : platformAdapters()) {
      for (const PlatformField& field : formOf(adapter).fields) {
        if (!field.option.empty()) options.addTo(command, field);
      }
    }
  }

  /// What the parser says about a command line; empty: it is right.
  std::string refusalOf(const std::string& line) {
    try {
      command.parse(line);
    } catch (const CLI::ParseError& error) {
      return error.what();
    }
    return {};
  }

  CLI::App command;
  FieldOptions options;
};

}  // namespace

TEST_F(OptionsOfAdapters, onlyWhatIsGivenHasAValue) {
  EXPECT_EQ(refusalOf("--robots 3 --kinematic --robot burger"), "");
  EXPECT_EQ(options.values,
            (FormValues{{"robots", 3.0}, {"kinematic", true}, {"kind", std::string("burger")}}));
}

TEST_F(OptionsOfAdapters, wholeNumbersAreShownAsSuchWithTheirRange) {
  const std::string help = command.help();
  EXPECT_THAT(help, HasSubstr("--robots INT:0 to 100 "));
  EXPECT_THAT(help, HasSubstr("--arcos INT:1 to 65435 "));
  EXPECT_THAT(help, HasSubstr("--seed INT:0 to 9000000000000000\n"));
  EXPECT_THAT(help, Not(HasSubstr("FLOAT")));
}

TEST_F(OptionsOfAdapters, aFractionIsRefusedWhereAWholeNumberIsMeant) {
  EXPECT_EQ(refusalOf("--robots 1.5"),
            "--robots: the number of robots must be a whole number between 0 and 100");
  EXPECT_EQ(refusalOf("--seed -1"), "--seed: the seed must be a whole number between 0 and 9000000000000000");
  EXPECT_EQ(refusalOf("--arcos 65436"),
            "--arcos: the first port must be a whole number between 1 and 65435, or 0 for none");
  EXPECT_EQ(refusalOf("--robots nan"),
            "--robots: the number of robots must be a whole number between 0 and 100");
  EXPECT_EQ(refusalOf("--robots many"), "Could not convert: --robots = many");
}

TEST_F(OptionsOfAdapters, aPortBelow1024IsForTheSystemToRefuse) {
  EXPECT_EQ(refusalOf("--arcos 80"), "");
  EXPECT_EQ(numberOf(options.values, "port"), 80);
}

TEST(FieldOptions, aFieldThatTakesSeveralValuesKeepsTheirOrder) {
  CLI::App command;
  FieldOptions options;
  options.addTo(command, {.name = "offset",
                          .kind = PlatformField::Kind::kNumber,
                          .initial = 0.0,
                          .noun = "offset",
                          .decimals = 3,
                          .option = "--offset",
                          .several = true});
  command.parse("--offset 2 --offset -1.5");
  EXPECT_EQ(options.lists.at("offset"), (std::vector<FormValue>{2.0, -1.5}));
  EXPECT_THROW(command.parse("--offset inf"), CLI::ValidationError);
}

TEST(FieldOptions, aTextIsCheckedByItsField) {
  CLI::App command;
  FieldOptions options;
  options.addTo(command, {.name = "name", .option = "--name", .check = [](const std::string& text) {
                            return text == "red1" ? "" : std::string("it must be red1");
                          }});
  EXPECT_THROW(command.parse("--name blue1"), CLI::ValidationError);
  command.parse("--name red1");
  EXPECT_EQ(textOf(options.values, "name"), "red1");
}

TEST(NumberRange, readsAsPeopleWriteNumbers) {
  CLI::App command;
  double seconds = 0;
  command.add_option("--seconds", seconds)->check(numberFrom(0.5, 1e6));
  EXPECT_THAT(command.help(), HasSubstr("--seconds FLOAT:0.5 to 1000000"));
  const auto refusalOf = [&](const std::string& line) {
    try {
      command.parse(line);
    } catch (const CLI::ParseError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusalOf("--seconds 1e7"), "--seconds: the number must be between 0.5 and 1000000, not 1e7");
  EXPECT_EQ(refusalOf("--seconds nan"), "--seconds: the number must be between 0.5 and 1000000, not nan");
  EXPECT_EQ(refusalOf("--seconds soon"), "Could not convert: --seconds = soon");
  EXPECT_EQ(refusalOf("--seconds 2"), "");
  EXPECT_EQ(seconds, 2);
}
