// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/control/ControllerCheck.h"

#include <gmock/gmock.h>

#include "simcore/control/Controllers.h"

namespace simcore {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using ParameterType = ControllerParameter::Type;

const ControllerRegistration kCheckedController{
    ControllerKind{"test_checked",
                   "Has a parameter of each type.",
                   {{"gain", ParameterType::kNumber, "any number"},
                    {"limits", ParameterType::kNumbers, "numbers of a range", "", false, -1, 2},
                    {"label", ParameterType::kText, "what is shown", "", true},
                    {"eye", ParameterType::kSensor, "a sensor"},
                    {"motor", ParameterType::kActuator, "a motor"},
                    {"ears", ParameterType::kSensors, "sensors"},
                    {"target", ParameterType::kModel, "a model"}},
                   [](ControllerSetup&) { return std::unique_ptr<Controller>(); }}};

/// Names and values.
using Arguments = std::vector<std::pair<std::string, std::string>>;

ControllerDescription checkedController(const Arguments& arguments, const std::string& name = "checked") {
  ControllerDescription description;
  description.kind = "test_checked";
  description.name = name;
  description.where = {"scene.sdf", 10, 3};
  for (const auto& [argument, value] : arguments) {
    const int line = 11 + static_cast<int>(description.arguments.size());
    description.arguments.push_back({argument, value, {"scene.sdf", line, 5}});
  }
  return description;
}

Port portAt(const std::string& path, Port::Kind portKind = Port::Kind::kSensor) {
  Port port;
  port.info.path = path;
  port.kind = portKind;
  return port;
}

/// What is wrong with a controller by itself, one problem a line.
std::string wrongWith(const Arguments& arguments, const std::string& object = "cart") {
  robotlink::Errors errors;
  checkController(checkedController(arguments), object, errors);
  return describe(errors);
}

/// What is wrong with the controllers of a world of one model, "cart", and of this model.
std::string wrongInWorld(std::vector<ControllerDescription> ofWorld,
                         std::vector<ControllerDescription> ofCart, const std::vector<Port>& ports = {}) {
  WorldDescription world;
  world.controllers = std::move(ofWorld);
  ModelDescription type;
  type.controllers = std::move(ofCart);
  ModelInstance cart;
  cart.name = "cart";
  cart.type = std::make_shared<const ModelDescription>(std::move(type));
  world.models.push_back(std::move(cart));
  robotlink::Errors errors;
  checkControllers(world, ports, errors);
  return describe(errors);
}

TEST(ControllerCheck, wordsAreSeparatedByBlanksOfAnyKind) {
  EXPECT_THAT(wordsOf("  a\tbc \n d "), ElementsAre("a", "bc", "d"));
  EXPECT_THAT(wordsOf(" \n"), IsEmpty());
}

TEST(ControllerCheck, numbersAreFiniteAndNothingElseIsBesideThem) {
  EXPECT_THAT(numbersOf("1 -2.5\t3e2").value(), ElementsAre(1, -2.5, 300));
  EXPECT_THAT(numbersOf("").value(), IsEmpty());
  for (const char* text : {"1,5", "1 x", "nan", "inf", "-infinity", "1e999", "0.5m", "--1"})
    EXPECT_FALSE(numbersOf(text)) << text;
}

TEST(ControllerCheck, aPortOfItsOwnModelHidesOneOfTheSameNameElsewhere) {
  const std::vector<Port> ports = {portAt("eye"), portAt("cart/eye"), portAt("cart/arm::eye"),
                                   portAt("other/eye")};
  ControllerDescription description;
  EXPECT_EQ(portPath(description, "cart", "eye", ports), "cart/eye");
  EXPECT_EQ(portPath(description, "", "eye", ports), "eye");
  EXPECT_EQ(portPath(description, "cart", "other/eye", ports), "other/eye");
  EXPECT_EQ(portPath(description, "cart", "nose", ports), "");
  description.prefix = "arm::";
  EXPECT_EQ(portPath(description, "cart", "eye", ports), "cart/arm::eye") << "of the model in its model";
  EXPECT_EQ(portPath(description, "other", "eye", ports), "other/eye");
}

TEST(ControllerCheck, whatFitsIsNotReported) {
  EXPECT_EQ(wrongWith({{"label", "a b"}, {"gain", "-1e6"}, {"limits", "-1 2 0.5"}, {"eye", ""}}), "");
  EXPECT_EQ(wrongWith({{"label", "x"}, {"limits", ""}}), "") << "no numbers are numbers, too";
}

TEST(ControllerCheck, aProblemHasTheLineOfItsParameterAndTheNameOfItsController) {
  EXPECT_THAT(wrongWith({{"label", "x"}, {"gain", "fast"}}),
              HasSubstr("scene.sdf:12:5: cart/checked: the parameter 'gain' must be one finite number, not "
                        "'fast'"));
  EXPECT_THAT(wrongWith({{"label", "x"}, {"gain", "fast"}}, ""), HasSubstr(":5: checked: the parameter"))
      << "of the world";
}

TEST(ControllerCheck, whatIsMissingHasTheLineOfTheController) {
  EXPECT_THAT(wrongWith({}), HasSubstr("scene.sdf:10:3: cart/checked: the controller 'test_checked' needs "
                                       "the parameter 'label': what is shown"));
  EXPECT_THAT(wrongWith({{"label", ""}}), HasSubstr("the parameter 'label' is empty"));
}

TEST(ControllerCheck, aNumberIsOneNumber) {
  for (const char* text : {"", "1 2", "nan"})
    EXPECT_THAT(wrongWith({{"label", "x"}, {"gain", text}}), HasSubstr("must be one finite number")) << text;
  EXPECT_THAT(wrongWith({{"label", "x"}, {"limits", "1 two"}}),
              HasSubstr("must be finite numbers, not '1 two'"));
}

TEST(ControllerCheck, eachOfSeveralNumbersIsInTheRange) {
  EXPECT_THAT(wrongWith({{"label", "x"}, {"limits", "0 1 2.5"}}),
              HasSubstr("must be between -1 and 2, not 2.5"));
  EXPECT_THAT(wrongWith({{"label", "x"}, {"limits", "-1.5"}}), HasSubstr("not -1.5"));
}

TEST(ControllerCheck, aLongValueIsShownShortened) {
  const std::string wrong = wrongWith({{"label", "x"}, {"gain", std::string(500, 'g')}});
  EXPECT_THAT(wrong, HasSubstr("'" + std::string(60, 'g') + "'"));
}

TEST(ControllerCheck, allProblemsOfAControllerAreReportedAtOnce) {
  robotlink::Errors errors;
  checkController(checkedController({{"gain", "x"}, {"gain", "1"}, {"colour", "red"}}), "cart", errors);
  ASSERT_EQ(errors.size(), 4U);
  EXPECT_THAT(errors[1].text, HasSubstr("'gain' is given twice"));
  EXPECT_THAT(errors[2].text, HasSubstr("has no parameter 'colour'"));
  EXPECT_THAT(errors[3].text, HasSubstr("needs the parameter 'label'"));
  EXPECT_THAT(errors[0].arguments, ElementsAre("checked"));
}

TEST(ControllerCheck, sensorsAndActuatorsAreNotTakenForEachOther) {
  const std::vector<Port> ports = {portAt("cart/eye"), portAt("cart/motor", Port::Kind::kServo),
                                   portAt("gate", Port::Kind::kDoor)};
  EXPECT_EQ(wrongInWorld({}, {checkedController({{"eye", "eye"}, {"motor", "gate"}})}, ports), "");
  EXPECT_THAT(wrongInWorld({}, {checkedController({{"eye", "motor"}})}, ports),
              HasSubstr("scene.sdf:11:5: cart/checked: there is no sensor 'motor'; "));
  EXPECT_THAT(wrongInWorld({}, {checkedController({{"motor", "eye"}})}, ports),
              HasSubstr("there is no actuator 'eye'; "));
}

TEST(ControllerCheck, onlyTheNamesThatAreMissingInAListAreReported) {
  const std::vector<Port> ports = {portAt("cart/left"), portAt("cart/right")};
  const std::string wrong = wrongInWorld({}, {checkedController({{"ears", "left middle right top"}})}, ports);
  EXPECT_THAT(wrong, HasSubstr("no sensor 'middle'"));
  EXPECT_THAT(wrong, HasSubstr("no sensor 'top'"));
  EXPECT_THAT(wrong, testing::Not(HasSubstr("no sensor 'left'")));
}

TEST(ControllerCheck, aModelIsFoundByItsName) {
  EXPECT_EQ(wrongInWorld({checkedController({{"target", "cart"}})}, {}), "");
  EXPECT_EQ(wrongInWorld({checkedController({{"target", ""}})}, {}), "") << "none is chosen";
  EXPECT_THAT(wrongInWorld({checkedController({{"target", "card"}})}, {}),
              HasSubstr("there is no model 'card'; did you mean 'cart'?"));
}

TEST(ControllerCheck, namesAreUniqueInTheirPlaceOnly) {
  EXPECT_EQ(wrongInWorld({checkedController({})}, {checkedController({})}), "");
  EXPECT_EQ(wrongInWorld({}, {checkedController({}), checkedController({}, "again")}), "");
  EXPECT_THAT(
      wrongInWorld({checkedController({}), checkedController({})}, {}),
      HasSubstr("there is another controller 'checked' here; give it a name with the attribute 'as'"));
}

TEST(ControllerCheck, aControllerDoesNotTakeThePathsOfOtherPorts) {
  EXPECT_THAT(wrongInWorld({}, {checkedController({})}, {portAt("cart/checked/angle")}),
              HasSubstr("the ports of 'checked' would have the same paths as others"));
  EXPECT_EQ(wrongInWorld({}, {checkedController({})}, {portAt("cart/checked2"), portAt("checked/angle")}),
            "");
  EXPECT_THAT(wrongInWorld({checkedController({})}, {}, {portAt("checked/angle")}),
              HasSubstr("would have the same paths as others"));
}

TEST(ControllerCheck, anUnknownKindIsReportedOnceAndItsParametersAreNotChecked) {
  ControllerDescription description = checkedController({{"gain", "x"}, {"eye", "nothing"}});
  description.kind = "test_chekced";
  robotlink::Errors errors;
  checkController(description, "cart", errors);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_THAT(errors[0].text, HasSubstr("did you mean 'test_checked'?"));
  EXPECT_EQ(wrongInWorld({}, {description}), "");
}

}  // namespace
}  // namespace simcore
