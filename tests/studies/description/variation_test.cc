#include "studies/description/variation.h"

#include <gtest/gtest.h>

#include "base/files/toml_file.h"

namespace somato {
namespace {

const std::string kSystem = R"([study]
name = "small"
seeds = 3

[module.joints]
type = "channel"

[module.map]
type = "som"
rows = 5

[explore.plan]
grasps = 9

[[phase]]
learn = ["map"]

[[phase]]
learn = ["map"]
draws = 7
)";

Table table(const std::string& toml, const std::string& name = "system.toml") {
  return parse_toml(toml, name).value();
}

Result<std::vector<Variation>> variations(const std::string& toml) {
  return read_variations(table(toml, "question.toml"));
}

// The system as the first variation has it.
Result<Table> varied(const std::string& toml) {
  const auto read = variations(toml);
  if (!read) return fail(read.error());
  return with_changes(table(kSystem), read->at(0).changes);
}

// All of a table as lines "a.b = value", lists of tables numbered.
void add_lines(const Table& from, const std::string& prefix, std::vector<std::string>& lines) {
  for (const Table::Entry& entry : from.entries) {
    const std::string name = prefix + entry.name;
    if (const auto* value = std::get_if<Value>(&entry.content)) {
      lines.push_back(name + " = " + to_toml(*value));
    } else if (const auto* inner = std::get_if<Table>(&entry.content)) {
      add_lines(*inner, name + ".", lines);
    } else {
      const auto& list = std::get<std::vector<Table>>(entry.content);
      for (std::size_t i = 0; i < list.size(); ++i) {
        add_lines(list[i], name + std::to_string(i) + ".", lines);
      }
    }
  }
}

std::vector<std::string> lines_of(const Table& from) {
  std::vector<std::string> lines;
  add_lines(from, "", lines);
  return lines;
}

void expect_variation_refused(const std::string& toml, const std::string& message) {
  const auto changed = varied(toml);
  ASSERT_FALSE(changed) << message;
  EXPECT_EQ(changed.error().kind, ErrorKind::kUsage);
  EXPECT_EQ(to_string(changed.error()), message);
}

TEST(Variation, ChangesKeysAndAddsOthers) {
  const auto changed = varied(
      "[variation.wide]\nmodule.map.rows = 15\nmodule.map.columns = 4\nstudy.seeds = 1\n"
      "study.label = 'shape'\n");
  ASSERT_TRUE(changed);
  EXPECT_EQ(lines_of(*changed),
            (std::vector<std::string>{
                "study.name = \"small\"", "study.seeds = 1", "study.label = \"shape\"",
                "module.joints.type = \"channel\"", "module.map.type = \"som\"",
                "module.map.rows = 15", "module.map.columns = 4", "explore.plan.grasps = 9",
                "phase0.learn = [\"map\"]", "phase1.learn = [\"map\"]", "phase1.draws = 7"}));
}

TEST(Variation, MergesTablesAndAddsThoseThatAreNotThere) {
  const auto changed = varied(
      "[variation.free.explore.simulation]\nfree = true\n[variation.free.explore.plan]\nturn = 3\n"
      "[variation.free.recording]\nformat = 'mcap'\n");
  ASSERT_TRUE(changed);
  std::vector<std::string> expected = lines_of(table(kSystem));
  const auto phase = std::find(expected.begin(), expected.end(), "phase0.learn = [\"map\"]");
  expected.insert(phase, {"explore.plan.turn = 3", "explore.simulation.free = true"});
  expected.push_back("recording.format = \"mcap\"");
  EXPECT_EQ(lines_of(*changed), expected);
}

TEST(Variation, TakesAWholeListsPlace) {
  const auto changed = varied("[[variation.once.phase]]\nlearn = ['joints']\n");
  ASSERT_TRUE(changed);
  std::vector<std::string> expected = lines_of(table(kSystem));
  expected.resize(expected.size() - 3);
  expected.push_back("phase0.learn = [\"joints\"]");
  EXPECT_EQ(lines_of(*changed), expected);
}

TEST(Variation, WithoutChangesChangesNothing) {
  const auto changed = varied("[variation.same]\n");
  ASSERT_TRUE(changed);
  EXPECT_EQ(lines_of(*changed), lines_of(table(kSystem)));
}

TEST(Variation, OfAModuleThatIsNotThereIsRefusedAtItsLine) {
  expect_variation_refused("[variation.wide]\n[variation.wide.module.mpa]\nrows = 3\n",
                           "question.toml:2: unknown module 'mpa'; did you mean 'map'?");
}

TEST(Variation, TakesNoValueForATableNorTheReverse) {
  expect_variation_refused("[variation.v]\nmodule.map = 3\n",
                           "question.toml:2: 'map' is a table in the system's file; change its "
                           "keys, for example map.KEY = ...");
  expect_variation_refused(
      "[variation.v]\nmodule.map.rows.least = 3\n",
      "question.toml:2: 'rows' is not a table in the system's file; use a value");
  expect_variation_refused(
      "[variation.v]\nphase.draws = 3\n",
      "question.toml:2: 'phase' is not a table in the system's file; use a value");
}

TEST(ReadVariations, KeepsTheirOrderAndWhoTheyAreFor) {
  const auto read = variations(
      "[variation.wide]\nsystems = ['a', 'b']\nmodule.map.rows = 9\n[variation.narrow]\n"
      "module.map.rows = 2\n");
  ASSERT_TRUE(read);
  ASSERT_EQ(read->size(), 2U);
  EXPECT_EQ(read->at(0).name, "wide");
  EXPECT_EQ(read->at(0).where, "question.toml:1");
  EXPECT_EQ(read->at(0).systems, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(lines_of(read->at(0).changes), (std::vector<std::string>{"module.map.rows = 9"}));
  EXPECT_EQ(read->at(1).name, "narrow");
  EXPECT_TRUE(read->at(1).systems.empty());
}

TEST(ReadVariations, AreNoneInAFileWithoutThem) {
  const auto read = variations(kSystem);
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->empty());
}

TEST(ReadVariations, RefusesWhatIsNoneAtItsLine) {
  const std::string name = "write [variation.NAME] on a separate line";
  const std::string systems = "'systems' must be a list of names; write systems = [\"...\"]";
  expect_variation_refused("variation = 3\n",
                           "question.toml:1: a variation requires a name; " + name);
  expect_variation_refused("[[variation]]\nname = 'wide'\n",
                           "question.toml:1: a variation requires a name; " + name);
  expect_variation_refused("[variation]\nwide = 3\n",
                           "question.toml:2: 'wide' must be a table; write [variation.wide] on a "
                           "separate line, its changes below");
  expect_variation_refused("[variation.wide]\nsystems = 'a'\n", "question.toml:2: " + systems);
  expect_variation_refused("[variation.wide]\nsystems = [3]\n", "question.toml:2: " + systems);
  expect_variation_refused("[variation.wide.systems]\na = 1\n", "question.toml:1: " + systems);
}

}  // namespace
}  // namespace somato
