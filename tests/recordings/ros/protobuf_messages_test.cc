#include "recordings/ros/protobuf_messages.h"

#include <gtest/gtest.h>

#include "recordings/ros/topic_type.h"

#ifdef SOMATO_WITH_PROTOBUF

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/dynamic_message.h>
#include <google/protobuf/text_format.h>
#include <google/protobuf/timestamp.pb.h>

#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "base/support/temporary_folder.h"
#include "recordings/bags/bag_import.h"
#include "recordings/bags/inspect_bag.h"
#include "recordings/bags/made_bag.h"
#include "recordings/explorations/collected_explorations.h"
#include "recordings/ros/channel_reader.h"

namespace somato {
namespace {

namespace pb = google::protobuf;

using Numbers = std::vector<double>;

constexpr const char* kNumbers = R"(
  name: "numbers.proto" package: "t" syntax: "proto3"
  enum_type { name: "Finger" value { name: "THUMB" number: 0 } value { name: "INDEX" number: 7 } }
  message_type {
    name: "All"
    field { name: "d" number: 1 type: TYPE_DOUBLE label: LABEL_OPTIONAL }
    field { name: "f" number: 2 type: TYPE_FLOAT label: LABEL_OPTIONAL }
    field { name: "i32" number: 3 type: TYPE_INT32 label: LABEL_OPTIONAL }
    field { name: "i64" number: 4 type: TYPE_INT64 label: LABEL_OPTIONAL }
    field { name: "u32" number: 5 type: TYPE_UINT32 label: LABEL_OPTIONAL }
    field { name: "u64" number: 6 type: TYPE_UINT64 label: LABEL_OPTIONAL }
    field { name: "s32" number: 7 type: TYPE_SINT32 label: LABEL_OPTIONAL }
    field { name: "s64" number: 8 type: TYPE_SINT64 label: LABEL_OPTIONAL }
    field { name: "x32" number: 9 type: TYPE_FIXED32 label: LABEL_OPTIONAL }
    field { name: "x64" number: 10 type: TYPE_FIXED64 label: LABEL_OPTIONAL }
    field { name: "sx32" number: 11 type: TYPE_SFIXED32 label: LABEL_OPTIONAL }
    field { name: "sx64" number: 12 type: TYPE_SFIXED64 label: LABEL_OPTIONAL }
    field { name: "b" number: 13 type: TYPE_BOOL label: LABEL_OPTIONAL }
    field { name: "finger" number: 14 type: TYPE_ENUM type_name: ".t.Finger" label: LABEL_OPTIONAL }
    field { name: "bytes" number: 15 type: TYPE_BYTES label: LABEL_OPTIONAL }
    field { name: "packed" number: 16 type: TYPE_SINT32 label: LABEL_REPEATED }
    field { name: "plain" number: 17 type: TYPE_FLOAT label: LABEL_REPEATED options { packed: false } }
    field { name: "flags" number: 18 type: TYPE_BOOL label: LABEL_REPEATED }
    field { name: "fingers" number: 19 type: TYPE_ENUM type_name: ".t.Finger" label: LABEL_REPEATED }
    field { name: "blobs" number: 20 type: TYPE_BYTES label: LABEL_REPEATED }
    field { name: "text" number: 21 type: TYPE_STRING label: LABEL_OPTIONAL }
    field { name: "last" number: 22 type: TYPE_INT32 label: LABEL_OPTIONAL }
  })";

constexpr const char* kHandMessages = R"(
  name: "hand.proto" package: "t" syntax: "proto3" dependency: "google/protobuf/timestamp.proto"
  message_type {
    name: "Taxel"
    field { name: "x" number: 1 type: TYPE_FLOAT label: LABEL_OPTIONAL }
    field { name: "count" number: 2 type: TYPE_INT32 label: LABEL_OPTIONAL }
  }
  message_type {
    name: "Hand"
    nested_type {
      name: "ForcesEntry"
      field { name: "key" number: 1 type: TYPE_STRING label: LABEL_OPTIONAL }
      field { name: "value" number: 2 type: TYPE_DOUBLE label: LABEL_OPTIONAL }
      options { map_entry: true }
    }
    nested_type {
      name: "CountsEntry"
      field { name: "key" number: 1 type: TYPE_SINT32 label: LABEL_OPTIONAL }
      field { name: "value" number: 2 type: TYPE_MESSAGE type_name: ".t.Taxel" label: LABEL_OPTIONAL }
      options { map_entry: true }
    }
    oneof_decl { name: "held" }
    oneof_decl { name: "_grip" }
    field { name: "timestamp" number: 1 type: TYPE_MESSAGE label: LABEL_OPTIONAL
            type_name: ".google.protobuf.Timestamp" }
    field { name: "name" number: 2 type: TYPE_STRING label: LABEL_REPEATED }
    field { name: "position" number: 3 type: TYPE_DOUBLE label: LABEL_REPEATED }
    field { name: "taxels" number: 4 type: TYPE_MESSAGE type_name: ".t.Taxel" label: LABEL_REPEATED }
    field { name: "tip" number: 5 type: TYPE_MESSAGE type_name: ".t.Taxel" label: LABEL_OPTIONAL }
    field { name: "forces" number: 6 type: TYPE_MESSAGE type_name: ".t.Hand.ForcesEntry"
            label: LABEL_REPEATED }
    field { name: "counts" number: 7 type: TYPE_MESSAGE type_name: ".t.Hand.CountsEntry"
            label: LABEL_REPEATED }
    field { name: "mass" number: 8 type: TYPE_INT64 label: LABEL_OPTIONAL oneof_index: 0 }
    field { name: "is_soft" number: 9 type: TYPE_BOOL label: LABEL_OPTIONAL oneof_index: 0 }
    field { name: "grip" number: 10 type: TYPE_FLOAT label: LABEL_OPTIONAL oneof_index: 1
            proto3_optional: true }
    field { name: "object" number: 11 type: TYPE_STRING label: LABEL_OPTIONAL }
  })";

constexpr const char* kProto2 = R"(
  name: "old.proto" package: "t"
  message_type {
    name: "Old"
    nested_type {
      name: "Part"
      field { name: "u" number: 1 type: TYPE_UINT32 label: LABEL_OPTIONAL }
    }
    field { name: "number" number: 1 type: TYPE_INT32 label: LABEL_REQUIRED }
    field { name: "optional" number: 2 type: TYPE_INT32 label: LABEL_OPTIONAL }
    field { name: "five" number: 3 type: TYPE_INT32 label: LABEL_OPTIONAL default_value: "5" }
    field { name: "part" number: 4 type: TYPE_GROUP type_name: ".t.Old.Part" label: LABEL_OPTIONAL }
    field { name: "packed" number: 5 type: TYPE_INT32 label: LABEL_REPEATED options { packed: true } }
  })";

pb::FileDescriptorProto file_of(const std::string& text) {
  pb::FileDescriptorProto file;
  EXPECT_TRUE(pb::TextFormat::ParseFromString(text, &file));
  return file;
}

std::string set_of(const std::vector<pb::FileDescriptorProto>& files) {
  pb::FileDescriptorSet set;
  for (const pb::FileDescriptorProto& file : files) *set.add_file() = file;
  return set.SerializeAsString();
}

pb::FileDescriptorProto timestamp_file() {
  pb::FileDescriptorProto file;
  pb::Timestamp::descriptor()->file()->CopyTo(&file);
  return file;
}

// The descriptors of all types here; a file may stand before those that it imports.
std::string made_set() {
  return set_of({file_of(kHandMessages), file_of(kNumbers), file_of(kProto2), timestamp_file()});
}

// The message that a text describes, in protobuf.
std::string message_of(const std::string& type, const std::string& text) {
  pb::DescriptorPool pool;
  pool.BuildFile(timestamp_file());
  for (const char* file : {kNumbers, kHandMessages, kProto2}) pool.BuildFile(file_of(file));
  pb::DynamicMessageFactory factory;
  const std::unique_ptr<pb::Message> message(
      factory.GetPrototype(pool.FindMessageTypeByName(type))->New());
  EXPECT_TRUE(pb::TextFormat::ParseFromString(text, message.get())) << text;
  return message->SerializeAsString();
}

ProtobufType compiled_protobuf(const std::string& type) {
  auto compiled = compile_protobuf_schema(type, made_set());
  EXPECT_TRUE(compiled) << (compiled ? "" : to_string(compiled.error()));
  return std::move(compiled).value();
}

std::shared_ptr<const RosType> plain_type(const ProtobufType& type) {
  return std::make_shared<const RosType>(type.type);
}

// The numbers at paths of a message that a text describes.
class ReadMessage {
 public:
  ReadMessage(const std::string& type, const std::string& text)
      : type_(compiled_protobuf(type)),
        cdr_(cdr_of_protobuf(type_, message_of(type, text)).value()) {}

  Numbers operator()(const std::string& path) const {
    Numbers values;
    const auto reader = ChannelReader::compile(plain_type(type_), {path});
    EXPECT_TRUE(reader) << to_string(reader.error());
    EXPECT_TRUE(reader->read(cdr_, values));
    return values;
  }
  bool lacks(const std::string& path) const {
    const Numbers values = (*this)(path);
    return values.size() == 1 && std::isnan(values[0]);
  }

 private:
  ProtobufType type_;
  std::string cdr_;
};

std::string refusal_of(const std::string& name, const std::string& set) {
  const auto type = compile_protobuf_schema(name, set);
  return type ? "accepted" : to_string(type.error());
}

TEST(ProtobufMessages, AllTypesOfNumbersAreRead) {
  const ReadMessage all("t.All", R"(d: 0.1 f: -0.5 i32: -2147483648 i64: -9007199254740992
      u32: 4294967295 u64: 18446744073709551615 s32: -3 s64: -4 x32: 5 x64: 6 sx32: -7 sx64: -8
      b: true finger: INDEX bytes: "\001\377\200" packed: [-1, 2, -3] plain: [0.5, 1.5]
      flags: [true, false] fingers: [INDEX, THUMB] blobs: ["\001\002", "", "\003"]
      text: "a\000b" last: 9)");
  EXPECT_EQ(all("d"), Numbers{0.1});
  EXPECT_EQ(all("f"), Numbers{-0.5});
  EXPECT_EQ(all("i32"), Numbers{-2147483648.0});
  EXPECT_EQ(all("i64"), Numbers{-9007199254740992.0});
  EXPECT_EQ(all("u32"), Numbers{4294967295.0});
  EXPECT_EQ(all("u64"), Numbers{18446744073709551616.0});
  EXPECT_EQ(all("s32"), Numbers{-3});
  EXPECT_EQ(all("s64"), Numbers{-4});
  EXPECT_EQ(all("x32"), Numbers{5});
  EXPECT_EQ(all("x64"), Numbers{6});
  EXPECT_EQ(all("sx32"), Numbers{-7});
  EXPECT_EQ(all("sx64"), Numbers{-8});
  EXPECT_EQ(all("b"), Numbers{1});
  EXPECT_EQ(all("finger"), Numbers{7});
  EXPECT_EQ(all("bytes"), (Numbers{1, 255, 128}));
  EXPECT_EQ(all("packed"), (Numbers{-1, 2, -3}));
  EXPECT_EQ(all("plain[1]"), Numbers{1.5});
  EXPECT_EQ(all("flags"), (Numbers{1, 0}));
  EXPECT_EQ(all("fingers"), (Numbers{7, 0}));
  EXPECT_EQ(all("blobs[*].items"), (Numbers{1, 2, 3}));
  EXPECT_EQ(all("last"), Numbers{9});
}

TEST(ProtobufMessages, ZerosOfProto3AreNotInTheMessage) {
  const ReadMessage all("t.All", "");
  for (const char* path : {"d", "f", "i64", "b", "finger", "last"}) {
    EXPECT_EQ(all(path), Numbers{0}) << path;
  }
  EXPECT_TRUE(all("packed").empty() && all("bytes").empty());
}

TEST(ProtobufMessages, WhatIsMissingIsNoNumber) {
  const ReadMessage nothing("t.Hand", "");
  for (const char* path : {"tip.x", "tip.count", "mass", "is_soft", "grip", "timestamp.nanos"}) {
    EXPECT_TRUE(nothing.lacks(path)) << path;
  }
  const ReadMessage zeros("t.Hand", "tip {} mass: 0 grip: 0 taxels {}");
  for (const char* path : {"tip.x", "tip.count", "mass", "grip", "taxels[0].x"}) {
    EXPECT_EQ(zeros(path), Numbers{0}) << path;
  }
  EXPECT_TRUE(zeros.lacks("is_soft"));
  EXPECT_EQ(ReadMessage("t.Hand", "is_soft: true")("is_soft"), Numbers{1});
}

TEST(ProtobufMessages, MessagesAreStructuresAndMapsAreSorted) {
  const ReadMessage hand("t.Hand", R"(taxels { x: 1 count: 2 } taxels { x: 3 } tip { x: 5 count: 6 }
      forces { key: "b" value: 2 } forces { key: "a" value: 1 } forces { key: "c" value: 3 }
      counts { key: 3 value { x: 30 } } counts { key: -1 value { count: 8 } })");
  EXPECT_EQ(hand("taxels"), (Numbers{1, 2, 3, 0}));
  EXPECT_EQ(hand("taxels[1].x"), Numbers{3});
  EXPECT_EQ(hand("tip"), (Numbers{5, 6}));
  EXPECT_EQ(hand("forces[*].value"), (Numbers{1, 2, 3}));
  EXPECT_EQ(hand("counts[*].key"), (Numbers{-1, 3}));
  EXPECT_EQ(hand("counts[*].value"), (Numbers{0, 8, 30, 0}));
}

TEST(ProtobufMessages, Proto2HasRequiredFieldsGroupsAndDefaultValues) {
  const ReadMessage filled("t.Old", "number: -1 optional: 2 five: 3 Part { u: 4 } packed: [6, 7]");
  EXPECT_EQ(filled("number"), Numbers{-1});
  EXPECT_EQ(filled("optional"), Numbers{2});
  EXPECT_EQ(filled("five"), Numbers{3});
  EXPECT_EQ(filled("part.u"), Numbers{4});
  EXPECT_EQ(filled("packed"), (Numbers{6, 7}));
  const ReadMessage least("t.Old", "number: 1");
  EXPECT_TRUE(least.lacks("optional") && least.lacks("part.u"));
  EXPECT_EQ(least("five"), Numbers{5});
  const auto lacking = cdr_of_protobuf(compiled_protobuf("t.Old"), "\x18\x01");
  ASSERT_FALSE(lacking);
  EXPECT_EQ(to_string(lacking.error()), "the message lacks 'number', which a t.Old requires");
}

TEST(ProtobufMessages, NamesPlaceTheirValues) {
  const ProtobufType type = compiled_protobuf("t.Hand");
  const auto cdr =
      cdr_of_protobuf(type, message_of("t.Hand", R"(name: ["a", "b"] position: [1, 2])")).value();
  const auto reader = ChannelReader::compile(plain_type(type), {"position[b,a]"}).value();
  ElementOrder order = reader.order();
  Numbers values;
  EXPECT_TRUE(reader.read(cdr, order, values).value());
  EXPECT_EQ(values, (Numbers{2, 1}));
}

TEST(ProtobufMessages, DescriptorsThatAreNoneAreRefused) {
  const std::string set = made_set();
  EXPECT_EQ(refusal_of("t.Nothing", set), "protobuf descriptors: they have no message 't.Nothing'");
  EXPECT_NE(refusal_of("t.Finger", set), "accepted");
  EXPECT_NE(refusal_of("t.All", "").find("the 0 bytes are no google.protobuf.FileDescriptorSet"),
            std::string::npos);
  EXPECT_NE(refusal_of("t.Hand", set_of({file_of(kHandMessages)}))
                .find("google/protobuf/timestamp.proto"),
            std::string::npos);
  const std::string circle = set_of({file_of("name: 'a.proto' dependency: 'b.proto'"),
                                     file_of("name: 'b.proto' dependency: 'a.proto'")});
  EXPECT_NE(refusal_of("t.All", circle).find("a.proto"), std::string::npos);
  for (std::size_t size = 0; size < set.size(); size += 7) {
    const std::string cut = set.substr(0, size);
    EXPECT_NE(refusal_of("t.All", cut).find("protobuf descriptors"), std::string::npos) << size;
  }
}

TEST(ProtobufMessages, TypesThatContainThemselvesAreRefused) {
  const auto file = file_of(R"(name: "r.proto" syntax: "proto3"
    message_type { name: "A" field { name: "b" number: 1 type: TYPE_MESSAGE type_name: ".B"
                                     label: LABEL_REPEATED } }
    message_type { name: "B" field { name: "a" number: 1 type: TYPE_MESSAGE type_name: ".A"
                                     label: LABEL_OPTIONAL } })");
  EXPECT_EQ(refusal_of("A", set_of({file})),
            "protobuf descriptors: messages of A contain themselves");
}

// Each message has the next one twice, so that a missing one would have 2^depth values.
pb::FileDescriptorProto doubling_file(int depth) {
  pb::FileDescriptorProto file = file_of("name: 'd.proto' syntax: 'proto3'");
  for (int i = 0; i < depth; ++i) {
    pb::DescriptorProto& message = *file.add_message_type();
    message.set_name("M" + std::to_string(i));
    for (int number = 1; number <= 2; ++number) {
      pb::FieldDescriptorProto& field = *message.add_field();
      field.set_name("f" + std::to_string(number));
      field.set_number(number);
      field.set_label(pb::FieldDescriptorProto::LABEL_OPTIONAL);
      field.set_type(pb::FieldDescriptorProto::TYPE_DOUBLE);
      if (i + 1 == depth) continue;
      field.set_type(pb::FieldDescriptorProto::TYPE_MESSAGE);
      field.set_type_name(".M" + std::to_string(i + 1));
    }
  }
  return file;
}

TEST(ProtobufMessages, TypesThatAreTooDeepOrTooLargeAreRefused) {
  EXPECT_EQ(refusal_of("M0", set_of({doubling_file(10)})), "accepted");
  EXPECT_NE(refusal_of("M0", set_of({doubling_file(32)})).find("are too large"), std::string::npos);
  EXPECT_NE(refusal_of("M0", set_of({doubling_file(40)})).find("more than 32 levels"),
            std::string::npos);
}

TEST(ProtobufMessages, OtherBytesAreRefusedAndNothingIsPrinted) {
  const ProtobufType type = compiled_protobuf("t.Hand");
  const std::string message =
      message_of("t.Hand", R"(timestamp { seconds: 1 nanos: 2 } taxels { x: 1 } object: "cup")");
  ::testing::internal::CaptureStderr();
  const auto cut = cdr_of_protobuf(type, message.substr(0, message.size() - 1));
  ASSERT_FALSE(cut);
  EXPECT_EQ(to_string(cut.error()),
            "the message of 17 bytes is no t.Hand in protobuf, or is cut off");
  EXPECT_FALSE(cdr_of_protobuf(type, "\x5A\x01\xFF"));  // A text that is not UTF-8.
  EXPECT_NE(refusal_of("t.Hand", set_of({file_of(kHandMessages), file_of(kHandMessages)})),
            "accepted");
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    std::string bytes = message;
    for (int k = 0; k < 3; ++k) bytes[random() % bytes.size()] = static_cast<char>(random());
    const auto cdr = cdr_of_protobuf(type, bytes);
    Numbers values;
    const auto reader = ChannelReader::compile(plain_type(type), {"grip"}).value();
    EXPECT_TRUE(!cdr || reader.read(*cdr, values));
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(ProtobufMessages, BagsAreInspectedAndImported) {
  const TemporaryFolder folder;
  MadeBag made(folder.file("hand.mcap"));
  const auto hand = made.topic("/hand", {0, "t.Hand", "protobuf", made_set()}, "protobuf");
  made.add(hand, 10, message_of("t.Hand", R"(timestamp { seconds: 5 nanos: 500000000 }
      name: ["a", "b"] position: [1, 2] object: "cup")"));
  made.add(hand, 20, message_of("t.Hand", R"(timestamp { seconds: 6 }
      name: ["b", "a"] position: [4, 3] object: "cup")"));
  made.finish();
  const auto summary = inspect_bag(find_bags(folder.path()).value()[0]);
  ASSERT_TRUE(summary) << to_string(summary.error());
  EXPECT_NE(summary->topics[0].reason.find("position[*]"), std::string::npos);
  BagImport description;
  description.channels.push_back({"joints", "rad", "/hand", {"position[b,a]"}, "name", {}, 1.0});
  description.trials.clock = BagClock::kHeader;
  std::vector<Exploration> explorations;
  CollectedExplorations collected([&](Exploration exploration) {
    explorations.push_back(std::move(exploration));
    return Result<void>();
  });
  const auto report =
      import_bags(folder.file("hand.mcap"), description, collected, [] { return true; });
  ASSERT_TRUE(report) << to_string(report.error());
  const Channel& joints = explorations[0].channels[0];
  EXPECT_EQ(joints.times, (Numbers{0.0, 0.5}));
  EXPECT_EQ(joints.frames, Matrix<float>(2, 2, {2, 1, 4, 3}));
}

}  // namespace
}  // namespace somato

#else

namespace somato {
namespace {

TEST(ProtobufMessages, ABuildWithoutThemSaysSo) {
  const std::string reason = topic_type({"a.B", "protobuf", "protobuf", "..."}).reason;
  EXPECT_NE(reason.find("which this build does not read"), std::string::npos) << reason;
  EXPECT_NE(reason.find("libprotobuf-dev"), std::string::npos) << reason;
}

}  // namespace
}  // namespace somato

#endif
