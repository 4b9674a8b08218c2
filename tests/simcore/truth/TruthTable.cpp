// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simcore/truth/TruthTable.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

namespace simcore::truth {
namespace {

struct Row {
  std::string quantity, reference, tolerance, unit;
  double error = 0;
};

/// "FrictionTruth" gives "Friction".
std::string areaOfTest() {
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string suite = test == nullptr ? "" : test->test_suite_name();
  return suite.substr(0, suite.find("Truth"));
}

std::string withUnit(double number, const std::string& unit) {
  return fmt::format("{:.3g}{}{}", number, unit.empty() ? "" : " ", unit);
}

/// The cells of a row that do not depend on the processor.
std::string stableCells(const std::string& area, const Row& row) {
  return fmt::format("| {} | {} | {} | {} |", area, row.quantity, row.reference, row.tolerance);
}

std::string contentsOf(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// The number of rows of the table in a document.
std::size_t rowsIn(const std::string& document) {
  std::istringstream table(document.substr(std::min(document.size(), document.find(kTableBegin))));
  std::size_t lines = 0;
  for (std::string line; std::getline(table, line);) lines += line.starts_with("| ") ? 1 : 0;
  return lines - std::min<std::size_t>(lines, 1);  // without its head
}

/// Collects the rows of all tests, and writes or checks the table at the end.
class Table : public testing::Environment {
 public:
  void add(const Row& row) {
    std::vector<Row>& rows = rows_[areaOfTest()];
    const auto found = std::ranges::find(rows, row.quantity, &Row::quantity);
    if (found == rows.end())
      rows.push_back(row);
    else
      found->error = largerOf(found->error, row.error);
  }

  void TearDown() override {
    if (const char* file = std::getenv("ROBOTCONTROL_TRUTH_TABLE"); file != nullptr && *file != 0)
      return write(file);
    const testing::UnitTest& all = *testing::UnitTest::GetInstance();
    if (all.test_to_run_count() < all.total_test_count() - all.disabled_test_count() || all.Failed()) return;
    const std::string document = contentsOf(ROBOTCONTROL_SOURCE_DIR "/simcore/TRUTH.md");
    std::size_t count = 0;
    for (const auto& [area, rows] : rows_) {
      for (const Row& row : rows) {
        ++count;
        EXPECT_NE(document.find(stableCells(area, row)), std::string::npos)
            << "simcore/TRUTH.md lacks the row '" << stableCells(area, row) << "'; write it again with "
            << "ROBOTCONTROL_TRUTH_TABLE=simcore/TRUTH.md";
      }
    }
    EXPECT_EQ(rowsIn(document), count) << "simcore/TRUTH.md has rows that no test writes any more";
  }

 private:
  void write(const std::string& file) const {
    const std::string before = contentsOf(file);
    std::ofstream out(file);
    out << before.substr(0, before.find(kTableBegin)) << kTableBegin << "\n\n"
        << "| area | quantity | held against | tolerance | error |\n|---|---|---|---|---|\n";
    for (const auto& [area, rows] : rows_) {
      for (const Row& row : rows)
        out << stableCells(area, row) << " " << withUnit(row.error, row.unit) << " |\n";
    }
    EXPECT_TRUE(out.good()) << file;
  }

  std::map<std::string, std::vector<Row>> rows_;
};

Table& table() {
  // GoogleTest owns and deletes it.
  static auto* const kTable = dynamic_cast<Table*>(testing::AddGlobalTestEnvironment(new Table));
  return *kTable;
}

/// Registers the table before the tests begin.
const bool kRegistered = (table(), true);

}  // namespace

double largerOf(double one, double other) {
  return std::isnan(one) || std::isnan(other) ? std::nan("") : std::max(one, other);
}

void compare(const Known& known, double measured, const boost::source_location& where) {
  const double error = std::abs(measured - known.expected);
  if (kRegistered)
    table().add({known.quantity, known.reference, withUnit(known.tolerance, known.unit), known.unit, error});
  if (std::isfinite(measured) && error <= known.tolerance) return;
  ADD_FAILURE_AT(where.file_name(), static_cast<int>(where.line()))
      << known.quantity << ": " << measured << " instead of " << known.expected << " " << known.unit << " ("
      << known.reference << "), off by " << error << ", tolerated " << known.tolerance;
}

}  // namespace simcore::truth
