// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/plugins/Plugins.h"

#include <gmock/gmock.h>

#include <fstream>

#include "app/core/PlatformCommands.h"
#include "logplayer/file/LogImport.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Plugin.h"
#include "robotlink/commands/CommandRegistration.h"
#include "robotlink/session/Session.h"
#include "tests/TestFolder.h"

using namespace app;
using testing::HasSubstr;

namespace {

bool hasCommand(const std::string& name) {
  return std::ranges::any_of(allCommands(), [&](const auto& command) { return command.name == name; });
}

TEST(PluginsTest, whatAPluginRegistersIsThere) {
  const LoadedPlugin plugin = loadPlugin(GOOD_PLUGIN);
  EXPECT_EQ(plugin.problem, "");
  EXPECT_EQ(plugin.name, "good");
  EXPECT_EQ(plugin.version, "2.1");
  EXPECT_EQ(plugin.help, "Is good.");
  ASSERT_TRUE(hasCommand("good.check"));

  robotlink::Session session;
  robotlink::CommandTable commands(allCommands());
  robotlink::attachRegisteredCommands(commands, session);
  EXPECT_TRUE(commands.runLine("good.check 1"));
  EXPECT_THAT(commands.runLine("good.check -1").error().text, HasSubstr("it is negative"));
  EXPECT_THAT(commands.runLine("good.check 13").error().text,
              HasSubstr("good.check has failed: 13 is unlucky"));

  const TestFolder folder;
  const auto log = folder.write("some.test-log", "");
  EXPECT_TRUE(logplayer::canImport(log));
  EXPECT_THAT(logplayer::importLog(log, folder / "out.mcap", {}).error().text,
              HasSubstr("nothing can be read"));
  EXPECT_THAT(
      logplayer::importLog(folder.write("throwing.test-log", ""), folder / "out.mcap", {}).error().text,
      HasSubstr("the disk is round"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out.mcap"));
}

TEST(PluginsTest, whatAPluginThatThrowsHasRegisteredIsUndone) {
  EXPECT_EQ(loadPlugin(THROWING_PLUGIN).problem, "it has failed: no license");
  EXPECT_FALSE(hasCommand("throwing.command"));
}

TEST(PluginsTest, aNameThatIsTakenFailsThePluginAsAWhole) {
  EXPECT_EQ(loadPlugin(TWICE_PLUGIN).problem,
            "command \"robot.stop\": there already is a command of this name");
  EXPECT_FALSE(hasCommand("twice.new"));
  EXPECT_TRUE(hasCommand("robot.stop"));
}

TEST(PluginsTest, whatIsNoPluginOrOfAnotherVersionIsNotExecuted) {
  const TestFolder folder;
  EXPECT_EQ(loadPlugin(folder / "missing.so").problem, "there is no such file");
  EXPECT_EQ(loadPlugin(folder.path()).problem, "there is no such file");
  EXPECT_THAT(loadPlugin(folder.write("empty.so", "")).problem, HasSubstr("is no plug-in"));
  EXPECT_THAT(loadPlugin(folder.write("text.so", std::string(300'000, 'x'))).problem,
              HasSubstr("is no plug-in"));
  const std::string mark = ROBOTCONTROL_PLUGIN_MARK;
  // Also where the text lies across the pieces in which a file is read.
  for (const std::size_t before : {0U, 65'520U, 65'536U, 131'060U}) {
    const auto file = folder.write("old.so", std::string(before, 'x') + mark + "0 (g++ 4)" + '\0' + "rest");
    EXPECT_THAT(loadPlugin(file).problem,
                HasSubstr("it was built for the '" + mark + "0 (g++ 4)', but this is"))
        << before;
  }
  const auto broken = folder.write("broken.so", std::string(ROBOTCONTROL_PLUGIN_INTERFACE) + '\0');
  EXPECT_THAT(loadPlugin(broken).problem, HasSubstr("it cannot be loaded"));
}

TEST(PluginsTest, theOptionsOfPluginsAreFoundAmongOthers) {
  const char* const words[] = {"robotctl",      "--plugin",     "a.so", "sim",      "--seed", "1",
                               "--plugin=b.so", "--no-plugins", "--",   "--plugin", "c.so"};
  const PluginOptions options = pluginOptions(static_cast<int>(std::size(words)), words);
  EXPECT_THAT(options.files, testing::ElementsAre("a.so", "b.so"));
  EXPECT_FALSE(options.usesFolder);
  const char* const last[] = {"robotctl", "--plugin"};
  EXPECT_TRUE(pluginOptions(2, last).files.empty());
}

}  // namespace
