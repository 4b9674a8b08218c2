// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of solutions, in protobuf's text format.
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/debugging/SolutionParameters.h"
#include "tests/TestFolder.h"
#include "tests/fuzz/FuzzTarget.h"

namespace parameter_files_fuzz {

using namespace robotlink;

int runInput(const std::uint8_t* data, std::size_t size) {
  static const TestFolder folder;
  static const robotcontrol::Request prototype;  // has messages, lists, texts and numbers in it
  SolutionDescription solution;
  solution.task = "task";
  solution.name = "solution";
  solution.parameters = &prototype;
  {
    std::filesystem::remove(
        folder / "task.solution.textproto");  // disks take their time with files that are written over
    std::ofstream file(folder / "task.solution.textproto", std::ios::binary);
    file.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  }
  const auto loaded = SolutionParameters::load(solution, folder.path(), {});
  if (loaded || !loaded.error().empty()) return 0;
  std::fputs("a refusal has no errors\n", stderr);
  std::abort();
}

std::vector<std::string> fuzzSeeds() {
  robotcontrol::Request request;
  request.set_id(7);
  request.set_robot("red1");
  request.mutable_set_parameters()->set_task("ball-percept");
  request.mutable_set_parameters()->mutable_value()->set_type("x");
  return {request.DebugString(), "id: 3 stop { engaged: true } # a comment\n",
          "set_parameters < task: 'a' solution: \"b\" >\n"};
}

const FuzzRegistration kTarget({"parameter_files", &fuzzSeeds, &runInput});

}  // namespace parameter_files_fuzz
