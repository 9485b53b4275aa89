#include "studies/folds/senses.h"

#include <gtest/gtest.h>

#include "studies/support/two_senses.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;
using testing::two_senses;
using testing::two_senses_system;

System built(const std::string& more) {
  const Recording recording = two_senses(3, 2, 1);
  const StudyDescription description =
      testing::study_from("[study]\nname = 'senses'\nmap = 'felt'\n" + two_senses_system() + more);
  return System::build(description.system, layout_of(recording)).value();
}

Numbers named(const System& system, const std::vector<std::string>& names) {
  Numbers numbers;
  for (const std::string& name : names) numbers.push_back(*system.find(name));
  return numbers;
}

TEST(VectorsBehind, AreThoseOfTheMapThatCallsUpAndNotOfTheTarget) {
  const System system = built("");
  EXPECT_EQ(vectors_behind(system, *system.find("called")), named(system, {"seen_last"}));
  EXPECT_EQ(vectors_behind(system, *system.find("felt")), named(system, {"felt_last"}));
}

TEST(VectorsBehind, AreThoseOfAllMapsOfASum) {
  const System system = built("[module.both]\ntype = 'sum'\ninputs = ['felt', 'called']\n");
  EXPECT_EQ(vectors_behind(system, *system.find("both")),
            named(system, {"felt_last", "seen_last"}));
}

TEST(VectorsBehind, AreWhatBecomesOneValueWithoutAMap) {
  const System system = built(
      "[module.scaled]\ntype = 'scale'\ninput = 'seen_last'\nfactor = 2\n"
      "[module.direct]\ntype = 'association'\ninput = 'scaled'\ntarget = 'felt'\n"
      "[module.summed]\ntype = 'accumulate'\ninput = 'seen'\n"
      "[module.of_all]\ntype = 'association'\ninput = 'summed'\ntarget = 'felt'\n");
  EXPECT_EQ(vectors_behind(system, *system.find("direct")), named(system, {"seen_last"}));
  EXPECT_EQ(vectors_behind(system, *system.find("of_all")), named(system, {"summed"}));
}

TEST(VectorsOfMap, AreBeforeAStandardization) {
  const System system = built(
      "[module.unit]\ntype = 'standardization'\ninput = 'seen_last'\n"
      "[module.other]\ntype = 'som'\ninput = 'unit'\nrows = 2\ncolumns = 2\n");
  EXPECT_EQ(vectors_of_map(system, *system.find("other")), *system.find("seen_last"));
  EXPECT_EQ(vectors_of_map(system, *system.find("felt")), *system.find("felt_last"));
}

TEST(ValuesOf, ConcatenatesTheModules) {
  const System system = built("");
  const Recording recording = two_senses(3, 2, 1);
  const Numbers both = named(system, {"felt_last", "seen_last"});
  auto activations = evaluate_fixed(system, recording, both, 1).value();
  const ExplorationValues values = values_of(activations, both);
  EXPECT_EQ(values.explorations, (Numbers{0, 1, 2, 3, 4, 5}));
  ASSERT_EQ(values.samples.size(), 5U);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto& channels = recording.explorations[i].channels;
    const std::span<const float> sample = values.samples[i].values;
    for (std::size_t j = 0; j < 3; ++j) EXPECT_EQ(sample[j], channels[1].frames(3, j));
    for (std::size_t j = 0; j < 2; ++j) EXPECT_EQ(sample[3 + j], channels[0].frames(3, j));
  }
}

TEST(FindRecall, RefusesWhatHasNotTheShapeOfTheMap) {
  const System system = built("");
  const std::size_t map = *system.find("felt");
  EXPECT_EQ(find_recall(system, map, "called", "here").value(), *system.find("called"));
  const auto other = find_recall(system, map, "seen_map", "here");
  ASSERT_FALSE(other);
  EXPECT_EQ(to_string(other.error()),
            "here: 'seen_map' gives 2 x 3, every exploration, but the map gives 3 x 3, every "
            "exploration; name an association whose target is the map, or a sum of such "
            "associations and the map");
  EXPECT_FALSE(find_recall(system, map, "calle", "here"));
}

}  // namespace
}  // namespace somato
