// SPDX-License-Identifier: GPL-3.0-or-later
// Color tables of all formats, and the texts beside them.
#include <bzlib.h>

#include "colortool/image/ClassPresets.h"
#include "colortool/table/TableImport.h"
#include "colortool/table/TekkotsuTable.h"
#include "tests/fuzz/FuzzTarget.h"

namespace table_import_fuzz {

using namespace colortool;

namespace {

void checkErrors(const robotlink::Errors& errors) {
  require(!errors.empty(), "a refusal has a reason");
  for (const robotlink::Error& error : errors) require(!error.text.empty(), "a refusal says why");
}

void checkClasses(const ColorClasses& classes) {
  if (classes.size() - 1 > ColorTableFile::kMaxClasses) return;
  const auto again = parseColorClasses(colorClassesText(classes), "again");
  require(again && *again == classes, "classes are read as they were written");
}

void checkTable(std::string_view bytes, std::optional<TableFormat> format) {
  const auto imported = parseTable(bytes, "fuzz", format);
  if (!imported) return checkErrors(imported.error());
  const NamedColorTable& table = imported->table;
  require(table.file.cells.size() == ColorTableFile::kCellCount, "a table has all its cells");
  for (const std::uint8_t cell : table.file.singleClasses())
    require(cell < table.classes.size(), "all classes have names");
  const auto again = ColorTableFile::parse(table.file.bytes(), "again");
  require(again && *again == table.file, "a table is read as it was written");
  checkClasses(table.classes);
}

std::string compressed(std::string bytes) {
  std::string out(bytes.size() + bytes.size() / 100 + 600, '\0');
  auto size = static_cast<unsigned>(out.size());
  BZ2_bzBuffToBuffCompress(out.data(), &size, bytes.data(), static_cast<unsigned>(bytes.size()), 1, 0, 0);
  out.resize(size);
  return out;
}

/// Bytes with some others in between.
std::string sprinkled(std::size_t size, char fill, int most) {
  std::string bytes(size, fill);
  for (std::size_t i = 0; i < size; i += 997)
    bytes[i] = static_cast<char>(static_cast<int>(i / 997) % (most + 1));
  return bytes;
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  checkTable(bytes, {});
  checkTable(bytes, TableFormat::kTekkotsu);
  checkTable(bytes, TableFormat::kC64);
  if (const auto classes = parseColorClasses(bytes, "fuzz"))
    checkClasses(*classes);
  else
    checkErrors(classes.error());
  if (const auto colors = parseTekkotsuColors(bytes, "fuzz"))
    checkClasses(*colors);
  else
    checkErrors(colors.error());
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  constexpr std::size_t k64 = ColorTableFile::kCellCount;
  ColorTableFile table;
  for (std::size_t i = 0; i < table.cells.size(); i += 20'000)
    table.cells[i] = static_cast<std::uint8_t>(i / 20'000);
  table.cells.back() = ColorTableFile::kSeveral | 5;
  return {table.bytes(),
          colorClassesText(findClassPreset("2002")->classes()),
          "0 (128 128 128) \"unclassified\" 8 1.00\n2 (108 191 73) \"green\" 8 0.75\n",
          "TMAP\nYUV'8\n2 4 8\n" + sprinkled(64, 1, 3),
          "TMAP\nYUV8\n1 1 1\n\2",
          compressed(table.bytes()),
          compressed("TMAP\nYUV8\n16 64 64\n" + sprinkled(65'536, 0, 6)),
          compressed(sprinkled(k64, 0, 255)),
          compressed(sprinkled(8 * k64, 0, 10)),
          compressed(sprinkled(8 * k64, 127, 10))};
}

const FuzzRegistration kTarget({"table_import", &fuzzSeeds, &runInput});

}  // namespace table_import_fuzz
