// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/commands/CommandCatalog.h"

#include <gmock/gmock.h>

#include <cctype>

using namespace robotlink;

TEST(CommandCatalog, everyRowIsCompleteAndUnique) {
  const CommandTable table(commandCatalog());  // ends the program if a name is there twice
  EXPECT_GT(table.all().size(), 70U);
  for (const auto& [name, command] : table.all()) {
    EXPECT_NE(name.find('.'), std::string::npos) << name << " has no group";
    ASSERT_FALSE(command.help.empty()) << name;
    EXPECT_TRUE(std::isupper(static_cast<unsigned char>(command.help.front()))) << name;
    EXPECT_NE(command.help.back(), '.') << name;
    EXPECT_EQ(command.help.find('\n'), std::string::npos) << name;
    for (const auto& argument : command.arguments) {
      EXPECT_FALSE(argument.name.empty()) << name;
      if (argument.initial) {
        const auto type = std::min(argument.type, CommandTable::Type::kText);
        EXPECT_EQ(argument.initial->index(), static_cast<std::size_t>(type)) << name;
      }
    }
  }
}

TEST(CommandCatalog, aRowHasNoHandler) {
  const CommandTable table(commandCatalog());
  EXPECT_EQ(table.unattached().size(), table.all().size());
  EXPECT_EQ(table.run("simulation.start").error().id, "command.unattached");
}
