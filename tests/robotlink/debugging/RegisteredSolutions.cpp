// SPDX-License-Identifier: GPL-3.0-or-later
// As a folder of solutions does it: keys and solutions that nothing names, in an OBJECT library.
#include "foxglove/Image.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/debugging/Solution.h"

namespace robotlink {
namespace {

const ImageDrawingKey kEdgeKey{"registry-test/edge", "The edge"};

class Nothing final : public Solution {
 public:
  explicit Nothing(SolutionContext& /*context*/) {}
  void execute() override {}
};

const SolutionRegistration kSecond =
    SolutionBuilder<Nothing>("registry-test", "second", "Does nothing either.").needs(kCameraImage);
const SolutionRegistration kFirst = SolutionBuilder<Nothing>("registry-test", "first", "Does nothing.")
                                        .needs(kCameraImage)
                                        .uses(kOracleWorld)
                                        .yields(kBallPercept)
                                        .keys({&kEdgeKey})
                                        .parameters<robotcontrol::KeyMode>();

}  // namespace
}  // namespace robotlink
