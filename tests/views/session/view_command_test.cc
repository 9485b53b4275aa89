#include "views/session/view_command.h"

#include <gtest/gtest.h>

#include "base/support/json_schema.h"

namespace somato::live {
namespace {

template <typename Command>
Command read(const std::string& text) {
  const auto command = parse_view_command(text);
  EXPECT_TRUE(command) << text;
  EXPECT_TRUE(testing::text_fits_schema(text, "view.json#/$defs/Command")) << text;
  return std::get<Command>(*command);
}

std::string refusal(const std::string& text) {
  const auto command = parse_view_command(text);
  EXPECT_FALSE(command) << text;
  return command ? "" : command.error().what;
}

TEST(ViewCommand, IsReadFromJson) {
  read<PlayCommand>(R"({"command":"play"})");
  read<PauseCommand>(R"({"command":"pause"})");
  read<ExploreCommand>(R"({"command":"explore"})");
  read<TrainCommand>(R"({"command":"train"})");
  read<StopTrainingCommand>(R"({"command":"stop_training"})");
  read<DismissCommand>(R"({"command":"dismiss"})");
  EXPECT_EQ(read<StepCommand>(R"({"command":"step","frames":-2})").frames, -2);
  EXPECT_EQ(read<SeekCommand>(R"({"command":"seek","exploration":3,"frame":4})").frame, 4U);
  EXPECT_EQ(read<SpeedCommand>(R"({"speed":0.05,"command":"speed"})").speed, 0.05);
  EXPECT_EQ(read<ThingCommand>(R"({"command":"thing","name":"a \"b\""})").name, "a \"b\"");
  const Label given =
      read<NameCommand>(R"({"command":"name","label":"object","value":"tea cup"})").label;
  EXPECT_EQ(given, (Label{"object", "tea cup"}));
  const std::string named = R"({"command":"name","label":"object","value":"cup")";
  EXPECT_EQ(read<NameCommand>(named + "}").id, std::nullopt);
  EXPECT_EQ(read<NameCommand>(named + R"(,"id":7})").id, 7U);
  const auto undo =
      read<UndoNameCommand>(R"({"command":"undo_name","id":7,"label":"object","value":"cup"})");
  EXPECT_EQ(undo.id, 7U);
  EXPECT_EQ(undo.label, (Label{"object", "cup"}));
  EXPECT_EQ(read<PlanCommand>(R"({"command":"plan","each":5})").each, 5U);
  EXPECT_EQ(read<SystemCommand>(R"({"command":"system","name":"s"})").name, "s");
  EXPECT_EQ(
      read<PlacementCommand>(R"({"command":"placement","x":1,"y":-2.5,"turn":90})").placement.y,
      -2.5);
}

TEST(ViewCommand, SaysWhatIsWrong) {
  EXPECT_EQ(refusal("[]"), "a command must be a JSON object");
  EXPECT_EQ(refusal(R"({"command":"fly"})"), "unknown command");
  EXPECT_EQ(refusal(R"({"command":"step"})"), "'frames' is missing");
  EXPECT_EQ(refusal(R"({"command":"step","frames":1.5})"), "'frames' must be a whole number");
  EXPECT_EQ(refusal(R"({"command":"speed","speed":101})"),
            "'speed' must be a number from 0.05 to 100");
  EXPECT_EQ(refusal(R"({"command":"speed","speed":"1"})"),
            "'speed' must be a number from 0.05 to 100");
  for (const std::string value : {"", "two\\nlines"}) {
    EXPECT_EQ(refusal(R"({"command":"name","label":"object","value":")" + value + "\"}"),
              "'value' must be a text without line breaks and not empty");
  }
  EXPECT_EQ(refusal(R"({"command":"play","speed":1})"), "the command has an unknown field");
  EXPECT_EQ(refusal(R"({"command":"thing","name":")" + std::string(256, 'a') + "\"}"),
            "'name' must be a text of at most 255 bytes");
}

TEST(ViewCommand, AThingTurnsOnceAroundAtMost) {
  for (const double turn : {-360.0, 360.0}) {
    const std::string text = R"({"command":"placement","x":0,"y":0,"turn":)";
    EXPECT_EQ(read<PlacementCommand>(text + std::to_string(turn) + "}").placement.turn, turn);
    EXPECT_EQ(refusal(text + std::to_string(turn * 1.002) + "}"),
              "'turn' must be a number from -360 to 360");
  }
}

TEST(ViewCommand, IsRefusedWhereItsSchemaRefusesIt) {
  for (const std::string text : {R"([])",
                                 R"({})",
                                 R"({"command":"fly"})",
                                 R"({"command":"play","speed":1})",
                                 R"({"command":"step"})",
                                 R"({"command":"step","frames":1.5})",
                                 R"({"command":"step","frames":1000000001})",
                                 R"({"command":"seek","exploration":-1,"frame":0})",
                                 R"({"command":"seek","exploration":0})",
                                 R"({"command":"speed","speed":0.04})",
                                 R"({"command":"speed","speed":"1"})",
                                 R"({"command":"thing"})",
                                 R"({"command":"system","name":1})",
                                 R"({"command":"name","label":"object","value":"cup","id":-1})",
                                 R"({"command":"undo_name"})",
                                 R"({"command":"undo_name","id":1,"label":"object"})",
                                 R"({"command":"plan","each":1001})",
                                 R"({"command":"placement","x":0,"y":0})",
                                 R"({"command":"placement","x":0,"y":-50.1,"turn":0})",
                                 R"({"command":"placement","x":0,"y":0,"turn":361})"}) {
    EXPECT_FALSE(parse_view_command(text)) << text;
    EXPECT_FALSE(testing::text_fits_schema(text, "view.json#/$defs/Command")) << text;
  }
}

TEST(ViewCommand, IsNeverNested) {
  EXPECT_EQ(refusal(R"({"command":"thing","name":{"a":[1]}})"), "a command must be a JSON object");
}

}  // namespace
}  // namespace somato::live
