#include "somato/graph/system_description.h"

#include <gtest/gtest.h>

#include "base/support/temporary_folder.h"
#include "somato/graph/system_model.h"
#include "systems/support/systems.h"

namespace somato {
namespace {

using testing::build;
using testing::hand_recording;
using testing::trained;

Result<SystemDescription> read(const std::string& text) {
  return parse_toml(text, "f.toml").and_then([](const Table& table) { return read_system(table); });
}

void expect_refused(const std::string& text, const std::string& message) {
  const auto description = read(text);
  ASSERT_FALSE(description) << text;
  EXPECT_EQ(description.error().kind, ErrorKind::kUsage);
  EXPECT_EQ(to_string(description.error()).substr(0, message.size()), message);
}

TEST(SystemDescription, ReadsModulesAndPhasesInTheirOrder) {
  const auto description = read(
      "[system]\nname = \"S\"\n[module.b]\ntype = \"channel\"\n[module.a]\ninput = \"b\"\n"
      "[[phase]]\nlearn = [\"a\", \"b\"]\ndraws = 7\norder = \"without_replacement\"\n"
      "of = \"frames\"\n[[phase]]\nlearn = \"c\"\n");
  ASSERT_TRUE(description) << to_string(description.error());
  EXPECT_EQ(description->name, "S");
  ASSERT_EQ(description->modules.size(), 2U);
  EXPECT_EQ(description->modules[0].name, "b");
  EXPECT_EQ(description->modules[0].settings.where, "f.toml:3");
  EXPECT_EQ(description->modules[1].settings.entries[0].where, "f.toml:6");
  ASSERT_EQ(description->phases.size(), 2U);
  const PhaseDescription& first = description->phases[0];
  EXPECT_EQ(first.learn, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(first.draws, 7U);
  EXPECT_EQ(first.order, Draws::kWithoutReplacement);
  EXPECT_EQ(first.of, Rate::kFrame);
  EXPECT_EQ(first.where, "f.toml:7");
  EXPECT_EQ(description->phases[1].learn, std::vector<std::string>{"c"});
  EXPECT_FALSE(description->phases[1].draws || description->phases[1].of);
}

TEST(SystemDescription, RefusesWhatItDoesNotKnowWithItsLine) {
  const std::string module = "[module.a]\ntype = \"channel\"\n";
  expect_refused(module + "[modul.b]\n", "f.toml:3: unknown table 'modul'; did you mean 'module'?");
  expect_refused(module + "[study]\n", "f.toml:3: unknown table 'study'");
  expect_refused("[system]\nnam = \"x\"\n" + module, "f.toml:2: unknown key 'nam'");
  expect_refused("[system]\nname = 3\n" + module, "f.toml:2: 'name' must be a text");
  expect_refused("system = 3\n" + module, "f.toml:1: 'system' must be a table");
  expect_refused(module + "[[phase]]\nlearns = \"a\"\n",
                 "f.toml:4: unknown key 'learns'; did you mean 'learn'?");
  expect_refused(module + "[[phase]]\nlearn = \"a\"\ndraws = 0\n", "f.toml:5: 'draws' must be");
  expect_refused(module + "[[phase]]\nlearn = \"a\"\nof = \"frame\"\n", "f.toml:5: 'of' must be");
  expect_refused(module + "[phase]\nlearn = \"a\"\n", "f.toml:3: 'phase' must be a list of tables");
  expect_refused("module = 1\n", "f.toml:1: 'module' must hold tables");
  expect_refused("[module]\na = 1\n", "f.toml:2: 'a' must be a table");
  expect_refused("[[module.a]]\n", "f.toml:1: 'a' must be a table");
  expect_refused("[module.\"a b\"]\n", "f.toml:1: a module cannot be called 'a b'");
  expect_refused("[module.\"\"]\n", "f.toml:1: a module cannot be called ''");
  expect_refused("[module." + std::string(101, 'x') + "]\n", "f.toml:1: a module cannot be called");
  expect_refused("[module.a]\n[module.a]\n", "f.toml:2:");
  expect_refused("[system]\n", "f.toml:1: the description has no modules");
}

TEST(SystemDescription, IgnoresTablesOfOthers) {
  const auto table = parse_toml("[study]\nx = 1\n[module.a]\n", "f.toml");
  EXPECT_TRUE(read_system(*table, {"study"}));
  EXPECT_FALSE(read_system(*table, {"recording"}));
}

TEST(SystemDescription, TakesAtMost256Modules) {
  std::string text;
  for (int i = 0; i < 256; ++i) text += "[module.m" + std::to_string(i) + "]\ntype = \"channel\"\n";
  EXPECT_TRUE(read(text));
  expect_refused(text + "[module.last]\n", "f.toml:1: 257 modules exceed");
}

TEST(SystemDescription, WhatIsWrittenReadsBackAsTheSame) {
  const std::string text =
      "[system]\nname = \"a \\\"quoted\\\" \\u000A name\"\n"
      "\n[module.a-1_B]\ntype = \"one_hot\"\ninput = \"x\"\nlow = [0, 0.5]\nhigh = 1e-07\n"
      "elements = 3\n"
      "\n[module.m]\ntype = \"t_mpsom\"\ninputs = [\"a\", \"b\"]\nshape = []\nflag = true\n"
      "\n[[phase]]\nlearn = [\"m\"]\ndraws = 1000000000000000\norder = \"with_replacement\"\n"
      "of = \"frames\"\n"
      "\n[[phase]]\nlearn = [\"a\", \"b\"]\n";
  const auto description = read(text);
  ASSERT_TRUE(description) << to_string(description.error());
  EXPECT_EQ(to_toml(*description), text);
}

std::string saved(const System& system) {
  const TemporaryFolder folder;
  EXPECT_TRUE(save_system(folder.file("a"), system));
  return bytes_of(folder.file("a"));
}

SystemBuilder small_builder() {
  SomParameters parameters;
  parameters.rows = 3;
  parameters.columns = 2;
  parameters.similarity = Similarity::kDotProduct;
  parameters.seed = 99;
  SystemBuilder builder("small");
  builder.module("joints", "channel", {{"channel", {std::string("joints")}}})
      .module("map", "som", {{"input", {std::string("joints")}}}, parameters)
      .phase({{"map"}, 50, {}, Rate::kFrame});
  return builder;
}

TEST(SystemDescription, TheBuilderMakesWhatTheTextDoes) {
  const Recording recording = hand_recording(4, 1);
  const std::string text =
      "[system]\nname = \"small\"\n[module.joints]\ntype = \"channel\"\nchannel = \"joints\"\n"
      "[module.map]\ntype = \"som\"\ninput = \"joints\"\nrows = 3\ncolumns = 2\n"
      "similarity = \"dot_product\"\n[[phase]]\nlearn = \"map\"\ndraws = 50\nof = \"frames\"\n";
  const SystemDescription built = small_builder().description();
  EXPECT_EQ(to_toml(built), to_toml(*read(text)));
  auto system = System::build(built, layout_of(recording));
  ASSERT_TRUE(system) << to_string(system.error());
  EXPECT_EQ(saved(trained(std::move(*system), recording, 4)),
            saved(trained(build(text, recording), recording, 4)));
}

// Only a builder can make these errors.
TEST(SystemDescription, WhatNoTextCouldSayIsRefused) {
  const Recording recording = hand_recording(2, 1);
  const auto refused = [&](const SystemBuilder& builder, const std::string& because) {
    const auto system = System::build(builder.description(), layout_of(recording));
    ASSERT_FALSE(system) << because;
    EXPECT_EQ(system.error().kind, ErrorKind::kUsage);
    EXPECT_NE(to_string(system.error()).find(because), std::string::npos)
        << to_string(system.error());
  };
  const std::vector<SystemBuilder::Setting> joints{{"channel", {std::string("joints")}}};
  refused(small_builder().module("map", "channel", joints), "two modules have this name");
  refused(small_builder().module("a.b", "channel", joints), "description");
  refused(small_builder().module("", "channel", joints), "as TOML:");
  refused(small_builder().module(std::string(101, 'a'), "channel", joints), "cannot be called");
  refused(small_builder().module("x]\n[module.y", "channel", joints),
          "cannot be represented as TOML");
  refused(SystemBuilder("empty"), "the description has no modules");
  refused(SystemBuilder("twice").module("a", "channel", {joints[0], joints[0]}), "as TOML:");
  PhaseDescription endless{{"map"}, std::uint64_t{1} << 62U, {}, {}};
  refused(SystemBuilder("long")
              .module("joints", "channel", joints)
              .module("map", "som", {{"input", {std::string("joints")}}})
              .phase(endless),
          "'draws' must be");
}

}  // namespace
}  // namespace somato
