#include "recordings/ros/field_reader.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "recordings/ros/cdr.h"
#include "recordings/ros/definition.h"

namespace somato {
namespace {

using Texts = std::vector<std::string>;

// The values in words.
class Words : public FieldSink {
 public:
  void take(const RosScalar& scalar, FieldPlace /*place*/) override {
    words.push_back(to_string(scalar));
  }
  Texts words;
};

std::shared_ptr<const RosType> compiled(const std::string& text) {
  auto type = compile_ros_definition("a/Top", "ros2msg", text);
  EXPECT_TRUE(type) << (type ? "" : to_string(type.error()));
  return std::make_shared<const RosType>(std::move(type).value());
}

// Two sensors with three and one taxels, in the layout of uSkin's.
std::shared_ptr<const RosType> skin_type() {
  return compiled(
      "string frame\nSensor[] sensors\nint8 last\n===\nMSG: a/Sensor\nstring model\nTaxel[] "
      "taxels\nfloat64[2] place\n===\nMSG: a/Taxel\nuint16 x\nuint16 y\nint32 z\n");
}

std::string skin_message() {
  CdrWriter writer;
  writer.text("hand").number(std::uint32_t{2});
  writer.text("tip").number(std::uint32_t{3});
  for (std::int32_t i = 0; i < 3; ++i) {
    writer.number(static_cast<std::uint16_t>(10 + i)).number(static_cast<std::uint16_t>(20 + i));
    writer.number(-30 - i);
  }
  writer.number(0.5).number(1.5);
  writer.text("").number(std::uint32_t{1});
  writer.number(std::uint16_t{13}).number(std::uint16_t{23}).number(std::int32_t{-33});
  writer.number(2.5).number(3.5).number(std::int8_t{-7});
  return writer.bytes();
}

Texts read(const std::shared_ptr<const RosType>& type, const std::string& path,
           const std::string& message, FieldKind kind = FieldKind::kNumbers) {
  Words sink;
  const auto reader = FieldReader::compile(type, path, kind);
  if (!reader) return {reader.error().what};
  const Result<void> done = reader->read(message, sink);
  return done ? sink.words : Texts{done.error().what};
}

TEST(FieldReader, APathSelectsFieldsAndElements) {
  const auto type = skin_type();
  const std::string message = skin_message();
  EXPECT_EQ(read(type, "sensors[*].taxels[*].z", message), (Texts{"-30", "-31", "-32", "-33"}));
  EXPECT_EQ(read(type, "sensors.taxels.x", message), (Texts{"10", "11", "12", "13"}));
  EXPECT_EQ(read(type, "sensors[0].taxels[1..2].y", message), (Texts{"21", "22"}));
  EXPECT_EQ(read(type, "sensors[1].taxels", message), (Texts{"13", "23", "-33"}));
  EXPECT_EQ(read(type, "sensors[*].place[1]", message), (Texts{"1.5", "3.5"}));
  EXPECT_EQ(read(type, "last", message), (Texts{"-7"}));
}

TEST(FieldReader, AStructureHoldsAllItsNumbersOrTexts) {
  EXPECT_EQ(read(skin_type(), "sensors", skin_message()),
            (Texts{"10", "20", "-30", "11", "21", "-31", "12", "22", "-32", "0.5", "1.5", "13",
                   "23", "-33", "2.5", "3.5"}));
  EXPECT_EQ(read(skin_type(), "sensors", skin_message(), FieldKind::kTexts), (Texts{"tip", ""}));
  EXPECT_EQ(read(skin_type(), "frame", skin_message(), FieldKind::kTexts), (Texts{"hand"}));
}

TEST(FieldReader, ValuesHaveTheirPlacesAsNames) {
  const auto reader = FieldReader::compile(skin_type(), "sensors[1]").value();
  EXPECT_EQ(reader.names(skin_message()).value(),
            (Texts{"sensors[1].taxels[0].x", "sensors[1].taxels[0].y", "sensors[1].taxels[0].z",
                   "sensors[1].place[0]", "sensors[1].place[1]"}));
  const auto last = FieldReader::compile(skin_type(), "last").value();
  EXPECT_EQ(last.names(skin_message()).value(), (Texts{"last"}));
}

TEST(FieldReader, EveryPrimitiveTypeIsANumber) {
  const auto type = compiled(
      "bool a\nbyte b\nchar c\nint8 d\nuint8 e\nint16 f\nuint16 g\nint32 h\nuint32 i\nint64 j\n"
      "uint64 k\nfloat32 l\nfloat64 m\n");
  CdrWriter writer;
  writer.number(std::uint8_t{1}).number(std::uint8_t{255}).number(std::uint8_t{128});
  writer.number(std::int8_t{-128}).number(std::uint8_t{200}).number(std::int16_t{-32768});
  writer.number(std::uint16_t{65535}).number(std::int32_t{-2147483647 - 1});
  writer.number(std::uint32_t{4294967295U}).number(std::int64_t{-9007199254740993});
  writer.number(std::uint64_t{18446744073709551615U}).number(0.1F).number(0.1);
  Texts all;
  for (const std::string& path : field_paths(*type, FieldKind::kNumbers, 99)) {
    const Texts words = read(type, path, writer.bytes());
    all.insert(all.end(), words.begin(), words.end());
  }
  EXPECT_EQ(all, (Texts{"1", "255", "128", "-128", "200", "-32768", "65535", "-2147483648",
                        "4294967295", "-9007199254740993", "18446744073709551615", "0.1", "0.1"}));
}

TEST(FieldReader, NumbersAreDoubles) {
  EXPECT_EQ((RosScalar{RosPrimitive::kInt16, 0xFFFF, {}}).number(), -1.0);
  EXPECT_EQ((RosScalar{RosPrimitive::kUint16, 0xFFFF, {}}).number(), 65535.0);
  EXPECT_EQ((RosScalar{RosPrimitive::kFloat32, 0x3F800000, {}}).number(), 1.0);
  EXPECT_EQ((RosScalar{RosPrimitive::kBool, 2, {}}).number(), 1.0);
}

TEST(FieldReader, ATypeWithoutFieldsIsPassedOver) {
  const auto type = compiled("Nothing[] n\nint8 x\n===\nMSG: a/Nothing\n");
  CdrWriter writer;
  writer.number(std::uint32_t{2}).number(std::uint8_t{0}).number(std::uint8_t{0});
  writer.number(std::int8_t{5});
  EXPECT_EQ(read(type, "x", writer.bytes()), (Texts{"5"}));
}

TEST(FieldReader, AnEmptySequenceNeedsNoPadding) {
  const auto type = compiled("float64[] x\nuint8 y\nfloat64[] z\n");
  CdrWriter writer;
  writer.number(std::uint32_t{0}).number(std::uint8_t{3}).number(std::uint32_t{1}).number(2.5);
  EXPECT_EQ(read(type, "y", writer.bytes()), (Texts{"3"}));
  EXPECT_EQ(read(type, "z", writer.bytes()), (Texts{"2.5"}));
  EXPECT_EQ(read(type, "x", writer.bytes()), Texts{});
}

TEST(FieldReader, AMessageThatEndsIsRefusedWithItsPlace) {
  const std::string message = skin_message();
  for (std::size_t length = 4; length < message.size(); ++length) {
    const Texts words = read(skin_type(), "last", message.substr(0, length));
    ASSERT_EQ(words.size(), 1U);
    EXPECT_NE(words[0].find("does not fit into the message"), std::string::npos) << length;
  }
  const auto reader = FieldReader::compile(skin_type(), "last").value();
  Words sink;
  EXPECT_EQ(reader.read(message.substr(0, message.size() - 1), sink).error().what,
            "the field 'last' does not fit into the message (at byte 116 of 116)");
}

TEST(FieldReader, SequencesAreCheckedAgainstTheirTypeAndThePath) {
  const auto type = compiled("uint8[<=2] x\n");
  CdrWriter writer;
  writer.number(std::uint32_t{3}).number(std::uint8_t{1}).number(std::uint8_t{1});
  writer.number(std::uint8_t{1});
  EXPECT_NE(read(type, "x", writer.bytes())[0].find("has 3 elements, more than 2"),
            std::string::npos);
  EXPECT_NE(read(skin_type(), "sensors[2].model", skin_message(), FieldKind::kTexts)[0].find(
                "has 2 elements, fewer than the path demands"),
            std::string::npos);
}

TEST(FieldReader, WideTextsAreOnlyPassedOverIfEmpty) {
  const auto type = compiled("wstring w\nint8 x\n");
  CdrWriter empty;
  empty.number(std::uint32_t{0}).number(std::int8_t{4});
  EXPECT_EQ(read(type, "x", empty.bytes()), (Texts{"4"}));
  CdrWriter full;
  full.number(std::uint32_t{1}).number(std::uint32_t{65}).number(std::int8_t{4});
  EXPECT_NE(read(type, "x", full.bytes())[0].find("depends on the middleware"), std::string::npos);
}

TEST(FieldReader, PathsThatSelectNothingAreRefused) {
  const auto type = skin_type();
  for (const std::string path :
       {"", ".", "last.", "last.x", "sensors[", "sensors[]", "sensors[x].place", "sensors[1..]",
        "sensors[3..1]", "sensors[-1]", "sensors]0[", "sensors[0]]", "sensors[0]x", "last[0]",
        "sensors[*].place[2]", "frame", "sensors[*].model", "sensors..taxels", "nothing"}) {
    const auto reader = FieldReader::compile(type, path);
    ASSERT_FALSE(reader) << path;
    EXPECT_EQ(reader.error().where, path);
  }
  EXPECT_FALSE(FieldReader::compile(type, "sensors[*].taxels", FieldKind::kTexts));
  const auto near = FieldReader::compile(type, "sensors[*].taxel");
  EXPECT_NE(to_string(near.error()).find("taxels"), std::string::npos);
}

TEST(FieldReader, PathsOfAllFieldsAreListed) {
  EXPECT_EQ(field_paths(*skin_type(), FieldKind::kNumbers, 99),
            (Texts{"sensors[*].taxels[*].x", "sensors[*].taxels[*].y", "sensors[*].taxels[*].z",
                   "sensors[*].place[*]", "last"}));
  EXPECT_EQ(field_paths(*skin_type(), FieldKind::kTexts, 99), (Texts{"frame", "sensors[*].model"}));
  EXPECT_EQ(field_paths(*skin_type(), FieldKind::kNumbers, 2).size(), 2U);
}

// Each structure contains two of the next: a message of 2^20 bytes, but a type of few lines.
TEST(FieldReader, ListsOfPathsAreBounded) {
  std::string text = "T1 a\nT1 b\n";
  for (int i = 1; i < 31; ++i) {
    const std::string next = i < 30 ? "T" + std::to_string(i + 1) : "int8";
    text += "===\nMSG: a/T" + std::to_string(i) + "\n" + next + " a\n" + next + " b\n";
  }
  EXPECT_EQ(field_paths(*compiled(text), FieldKind::kNumbers, 10).size(), 10U);
  EXPECT_TRUE(field_paths(*compiled(text), FieldKind::kTexts, 10).empty());
}

}  // namespace
}  // namespace somato
