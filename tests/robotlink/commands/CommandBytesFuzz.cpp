// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of scripts and of clients of a running workbench, as anybody may send them.

#include "robotlink/commands/CommandCompletion.h"
#include "robotlink/commands/CommandLine.h"
#include "robotlink/commands/LineReader.h"
#include "robotlink/commands/ScriptLine.h"
#include "tests/fuzz/FuzzTarget.h"

namespace command_bytes_fuzz {

using namespace robotlink;

namespace {

void requirePlace(const Error& error, const std::string& line) {
  require(!error.text.empty(), "a refusal says why");
  require(error.where.column >= 0 && error.where.column <= static_cast<int>(line.size()) + 1,
          "its place is in the line");
}

const CommandTable& commands() {
  static const CommandTable table(
      {{"a.b", "", {{"c"}, {"d", CommandTable::Type::kNumber, "", 1.0}}, [](const auto&) -> Result<void> {
          return {};
        }}});
  return table;
}

void useLine(const std::string& line) {
  if (const auto words = splitCommandLine(line)) {
    for (const CommandWord& word : *words) {
      const auto again = splitCommandLine(quotedWord(word.text));
      require(again && again->size() == 1 && again->front().text == word.text, "a quoted word is that word");
    }
  }
  if (const auto done = commands().runLine(line); !done) requirePlace(done.error(), line);
  require(complete(commands(), line, line.size() / 2).from <= line.size() / 2, "what is replaced is before");
  const auto text = withVariables(line, [](const std::string& name) { return std::optional(name + name); });
  if (!text) return requirePlace(text.error(), line);
  if (const auto read = readScriptLine(*text); !read) requirePlace(read.error(), *text);
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  LineReader reader;
  reader.feed(bytes.substr(0, size / 2));
  while (const auto line = reader.next()) useLine(*line);
  reader.feed(bytes.substr(size / 2));
  while (const auto line = reader.next()) {
    require(line->size() <= LineReader::kMaxLine, "lines are bounded");
    useLine(*line);
  }
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  return {"a.b 'c d' 2 # x\nwait until a.b > $c for 3\n", "set x \"1\\n\"\nassert ${x} == $$y\ninclude 'z'\n",
          "wait 5\nscreenshot image a.png\n", std::string(20'000, 'a') + "\n"};
}

const FuzzRegistration kTarget({"command_bytes", &fuzzSeeds, &runInput});

}  // namespace command_bytes_fuzz
