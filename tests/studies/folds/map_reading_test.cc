#include "studies/folds/map_reading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>

#include "maps/grid/size_order.h"
#include "studies/measures/most_similar.h"
#include "studies/support/known_metrics.h"
#include "studies/support/made_study.h"
#include "studies/support/prepared_study.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;
using ByName = std::map<std::string, double>;

constexpr std::uint64_t kReadingSeed = 3;

StudyParameters study_reading(const std::vector<std::string>& mapped_with,
                              std::size_t wrong_groupings = 50) {
  StudyParameters study;
  study.mapped_with = mapped_with;
  study.wrong_groupings = wrong_groupings;
  return study;
}

ByName by_name(const std::vector<MeasuredValue>& readings) {
  testing::expect_known_metrics(readings);
  ByName values;
  for (const MeasuredValue& reading : readings) values[reading.name] = reading.value;
  return values;
}

const Grid kRow(1, 9, Lattice::kRectangular, Topology::kPlane);

ByName read(const StudyParameters& study, const PreparedStudy& prepared, const Numbers& winners,
            const Grid& grid = kRow) {
  return by_name(read_map(study, prepared, grid, winners, kReadingSeed));
}

// only C at 8; A and B share 4; the nearest to the first A is the B beside it.
//   neuron  0 1 . . 4 . . . 8
//   sample  A B     AB      CC
TEST(ReadMap, CountsSeparatedClassesAndNeighboursOfTheSameClass) {
  const PreparedStudy prepared = testing::study_of({testing::letter_label("object", "ABABCC")});
  const ByName values =
      read(study_reading({"A B", "B A", "A C", "C C"}), prepared, {0, 1, 4, 4, 8, 8});
  EXPECT_EQ(values.at("classes_separated"), 1.0);
  EXPECT_EQ(values.at("samples_ambiguous"), 2.0);
  EXPECT_EQ(values.at("neighbours_same_class"), 2.0);
  EXPECT_EQ(values.at("winner_shared_within_class"), 2.0);
  EXPECT_EQ(values.at("mapped_with A B"), 2.0);
  EXPECT_EQ(values.at("mapped_with B A"), 2.0);
  EXPECT_EQ(values.at("mapped_with A C"), 0.0);
  EXPECT_EQ(values.at("mapped_with C C"), 2.0);
}

// Only A's first sample is mapped with B: its nearest is the B at 1, while that B's nearest is 0.
TEST(ReadMap, CountsWhichIsMappedWithWhich) {
  const PreparedStudy prepared = testing::study_of({testing::letter_label("object", "ABBAA")});
  const ByName values = read(study_reading({"A B", "B A"}), prepared, {1, 2, 2, 7, 8});
  EXPECT_EQ(values.at("mapped_with A B"), 1.0);
  EXPECT_EQ(values.at("mapped_with B A"), 0.0);
}

// Two neurons with two samples each, a class a neuron: every other dealing mixes both.
TEST(ReadMap, ReportsValuesByChance) {
  const PreparedStudy prepared = testing::study_of({testing::letter_label("object", "AABB")});
  const ByName together = read(study_reading({}), prepared, {0, 0, 8, 8});
  EXPECT_EQ(together.at("classes_separated"), 2.0);
  EXPECT_EQ(together.at("classes_separated_chance"), 0.0);
  EXPECT_EQ(together.at("samples_ambiguous"), 0.0);
  EXPECT_EQ(together.at("samples_ambiguous_chance"), 4.0);
  EXPECT_EQ(together.at("neighbours_same_class"), 4.0);
  EXPECT_EQ(together.at("neighbours_same_class_chance"), 0.0);
  EXPECT_EQ(together.at("winner_shared_within_class"), 4.0);
  EXPECT_EQ(together.at("winner_shared_within_class_chance"), 0.0);
  // With separate winners all classes are separated, for every grouping.
  const ByName apart = read(study_reading({}), prepared, {0, 2, 4, 6});
  EXPECT_EQ(apart.at("classes_separated_chance"), 2.0);
  EXPECT_EQ(apart.at("samples_ambiguous_chance"), 0.0);
}

// The first two samples share a neuron. There are two wrong groupings of A B B A: A A B B, for
// which the map separates both classes, and A B A B, for which it separates none.
TEST(ReadMap, KeepsTheValueOfEachWrongGrouping) {
  const PreparedStudy prepared = testing::study_of({testing::letter_label("object", "ABBA")});
  for (const MeasuredValue& reading :
       read_map(study_reading({}), prepared, kRow, {0, 0, 4, 8}, kReadingSeed)) {
    if (reading.name == "classes_separated_chance") {
      ASSERT_EQ(reading.of_each.size(), 2U);
      EXPECT_EQ(reading.of_each.at(0.0) + reading.of_each.at(2.0), 50U);
      EXPECT_EQ(reading.value, 2.0 * static_cast<double>(reading.of_each.at(2.0)) / 50.0);
    } else if (reading.name == "on_border_chance") {
      EXPECT_EQ(reading.of_each, (Distribution{{1.0, 1}}));  // a row is all border
    } else if (!reading.name.ends_with("_chance")) {
      EXPECT_TRUE(reading.of_each.empty()) << reading.name;
    }
  }
}

TEST(ReadMap, SaysNothingAboutChanceWithoutWrongGroupings) {
  const PreparedStudy prepared = testing::study_of({testing::letter_label("object", "AABB")});
  const ByName values = read(study_reading({}, 0), prepared, {0, 0, 8, 8});
  EXPECT_TRUE(values.contains("classes_separated"));
  for (const char* name :
       {"classes_separated_chance", "samples_ambiguous_chance", "neighbours_same_class_chance"}) {
    EXPECT_FALSE(values.contains(name)) << name;
  }
}

TEST(ReadMap, MeasuresEveryLabel) {
  const PreparedStudy prepared = testing::study_of(
      {testing::letter_label("object", "ABCD"), testing::letter_label("shape", "rrss")});
  const ByName values = read(study_reading({"A B"}), prepared, {0, 0, 4, 8});
  EXPECT_EQ(values.at("classes_separated"), 2.0);
  EXPECT_EQ(values.at("shape.classes_separated"), 2.0);
  EXPECT_EQ(values.at("samples_ambiguous"), 2.0);
  EXPECT_EQ(values.at("shape.samples_ambiguous"), 0.0);
  EXPECT_EQ(values.at("winner_shared_within_class"), 0.0);
  EXPECT_EQ(values.at("shape.winner_shared_within_class"), 2.0);
  EXPECT_FALSE(values.contains("shape.mapped_with A B"));
  EXPECT_FALSE(values.contains("order_around"));
}

// 4 x 4 neurons, 12 of them on the border; three of five winners.
TEST(ReadMap, SeesTheBorder) {
  const Grid square(4, 4, Lattice::kRectangular, Topology::kPlane);
  const PreparedStudy prepared = testing::study_of({testing::letter_label("object", "AABBC")});
  const ByName values = read(study_reading({}), prepared, {0, 5, 7, 10, 14}, square);
  EXPECT_EQ(values.at("on_border"), 0.6);
  EXPECT_EQ(values.at("on_border_chance"), 0.75);
}

// (3, 4) and (4, 3) of different classes have the cosine 24/25; the last one was not learned from.
TEST(ReadMap, ComparesTheVectorsWhereNothingBeforeTheMapLearns) {
  PreparedStudy prepared = testing::study_of({testing::letter_label("object", "ABA")});
  prepared.samples.samples = 2;
  EXPECT_FALSE(read(study_reading({}), prepared, {0, 8}).contains("cosine_between_classes"));
  prepared.fixed_vectors =
      ExplorationValues{{0, 1, 2}, Samples(Matrix<float>(3, 2, {3, 4, 4, 3, -5, 1}))};
  EXPECT_DOUBLE_EQ(read(study_reading({}), prepared, {0, 8}).at("cosine_between_classes"), 0.96);
}

// Explorations of what is tested with stand after those that were learned from.
TEST(ReadMap, UsesOnlyTheTrainingSamples) {
  PreparedStudy prepared = testing::study_of({testing::letter_label("object", "AABBAB")});
  prepared.samples.samples = 4;
  prepared.samples.test_samples = 2;
  prepared.order = StudiedOrder{{0, 0, 1, 2, 3, 4}, {1, 2, 3, 9, 0.5}, {0, 0, 0, 0, 0}};
  const ByName values = read(study_reading({}), prepared, {0, 0, 8, 8});
  EXPECT_EQ(values.at("neighbours_same_class"), 4.0);
  EXPECT_EQ(values.at("neighbours_same_class_chance"), 0.0);
  EXPECT_TRUE(values.contains("order_around"));
}

// Four individuals at the corners of a 3 x 3 grid, two samples each.
//   0 1 2
//   3 4 5
//   6 7 8
class ReadOrder : public ::testing::Test {
 protected:
  static ByName read_numbers(const std::vector<double>& numbers,
                             const Numbers& groups = {0, 0, 0, 0}) {
    const Grid square(3, 3, Lattice::kRectangular, Topology::kPlane);
    PreparedStudy prepared = testing::study_of({testing::letter_label("object", "AABBCCDD")});
    prepared.order = StudiedOrder{{0, 0, 1, 1, 2, 2, 3, 3}, numbers, groups};
    return read(study_reading({}), prepared, {0, 0, 2, 2, 8, 8, 6, 6}, square);
  }
};

TEST_F(ReadOrder, IsWholeAroundTheMapInEitherDirection) {
  EXPECT_DOUBLE_EQ(read_numbers({10, 20, 30, 40}).at("order_around"), 1.0);
  EXPECT_DOUBLE_EQ(read_numbers({30, 20, 10, 40}).at("order_around"), 1.0);
  EXPECT_DOUBLE_EQ(read_numbers({10, 20, 30, 40}).at("order_within"), 1.0);
}

// Around it 1 3 2 4, or from another corner 3 2 4 1, 2 4 1 3, 4 1 3 2, and back. Against places 1
// to 4 the squared differences are at least 1 + 1 = 2: 1 - 6 * 2 / (4 * 15) = 0.8.
TEST_F(ReadOrder, HasARankCorrelation) {
  EXPECT_DOUBLE_EQ(read_numbers({1, 3, 2, 4}).at("order_around"), 0.8);
}

TEST_F(ReadOrder, CountsExceptionsAndHasTheBestThatTheNumbersPermit) {
  const ByName values = read_numbers({1, 3, 2, 4});
  EXPECT_EQ(values.at("exceptions_around"), 1.0);
  EXPECT_EQ(values.at("exceptions_within"), 1.0);
  EXPECT_GT(values.at("exceptions_around_chance"), 0.4);  // 1 in 4 of the 6 orders
  EXPECT_LT(values.at("exceptions_around_chance"), 0.9);
  EXPECT_EQ(values.at("order_around_greatest"), 1.0);
  EXPECT_EQ(values.at("exceptions_around_least"), 0.0);
  // 1 3 and 2 4 overlap.
  EXPECT_EQ(read_numbers({1, 3, 2, 4}, {0, 0, 1, 1}).at("order_around_greatest"), 0.8);
  EXPECT_FALSE(read_numbers({2, 2, 2, 2}).contains("order_around_greatest"));
}

// There are three ways around of four numbers, up to start and direction: 1 2 3 4 with 1,
// 1 3 2 4 and 1 2 4 3 with 0.8 each.
TEST_F(ReadOrder, ByChanceIsBetweenTheWorstAndTheBest) {
  const ByName values = read_numbers({1, 3, 2, 4});
  EXPECT_GT(values.at("order_around_chance"), 0.8);
  EXPECT_LT(values.at("order_around_chance"), 0.95);
  EXPECT_GT(values.at("order_within_chance"), 0.8);
}

// From left to right 4 2 3 1: the squared differences from 1 to 4 are 9 + 9, and 1 - 6 * 18 / 60 is
// -0.8. In the 24 orders of four numbers the absolute correlation is 1 in 2, 0.8 in 6, 0.6 in 2,
// 0.4 in 8, 0.2 in 4 and 0 in 2.
TEST_F(ReadOrder, AlongTheMapIsAbsoluteAndComparedWithChance) {
  PreparedStudy prepared = testing::study_of({testing::letter_label("object", "ABCD")});
  prepared.order = StudiedOrder{{0, 1, 2, 3}, {4, 2, 3, 1}, {0, 0, 0, 0}};
  const ByName values = read(study_reading({}), prepared, {0, 3, 4, 8});
  EXPECT_DOUBLE_EQ(values.at("order_along"), 0.8);
  EXPECT_NEAR(values.at("order_along_chance"), 12.0 / 24, 0.1);
}

// A and B are of one group, C and D of the other; A and C are the small ones. The C at 1 lies with
// A; the C at 5 and the D at 6 lie with each other.
//   neuron  0 0 1 5 6 8 8
//   sample  A A C C D B B
TEST_F(ReadOrder, FindsOutliersOfTheRightSize) {
  PreparedStudy prepared = testing::study_of({testing::letter_label("object", "AACCDBB")});
  prepared.order = StudiedOrder{{0, 0, 1, 1, 2, 3, 3}, {1, 3, 4, 2}, {0, 1, 1, 0}};
  const ByName values = read(study_reading({}), prepared, {0, 0, 1, 5, 6, 8, 8});
  EXPECT_EQ(values.at("right_size_wrong_group"), 1.0);
  EXPECT_GT(values.at("right_size_wrong_group_chance"), 0.0);
}

// Two of a group are always in order, so they count for nothing.
TEST_F(ReadOrder, WithinGroupsOfTwoIsNone) {
  EXPECT_EQ(read_numbers({1, 2, 3, 4}, {0, 0, 1, 1}).at("order_within"), 0.0);
}

// Known: individuals 0 (1.0, group 0), 1 (2.0, group 0), 2 (1.2, group 1), at neurons 0, 3, 6; then
// three new ones. The most similar to 1.4 in group 0 is 0, to 1.5 both 0 and 1, to 9 in group 1 is
// 2; of group 2 there is none.
class ReadPlaced : public ::testing::Test {
 protected:
  ReadPlaced() {
    outcome_.map.grid = kRow;
    prepared_.samples.samples = 4;
    prepared_.samples.test_samples = 4;
    prepared_.order = StudiedOrder{
        {0, 1, 2, 2, 3, 4, 5, 6}, {1.0, 2.0, 1.2, 1.4, 1.5, 9.0, 1.0}, {0, 0, 1, 0, 0, 1, 2}};
    outcome_.training_winners = {0, 3, 6, 6};
    outcome_.winners = {1, 2, 5, 8};
  }

  ByName placed(const Numbers& named_by, const Neighbours& nearest) {
    outcome_.named_by = named_by;
    outcome_.nearest = nearest;
    return by_name(read_placed(prepared_, outcome_, kReadingSeed));
  }

  PreparedStudy prepared_;
  FoldOutcome outcome_;
};

TEST_F(ReadPlaced, IsTheShareWithOneOfTheMostSimilar) {
  const Neighbours none{{2, 2, 0, 0}, {2, 2, 0, 0}};
  EXPECT_EQ(placed({0, 0, 6, 0}, none).at("placed_with_most_similar"), 0.75);
  EXPECT_EQ(placed({0, 3, 6, 6}, none).at("placed_with_most_similar"), 0.75);
  EXPECT_EQ(placed({3, 6, 6, 0}, none).at("placed_with_most_similar"), 0.25);
  EXPECT_EQ(placed({3, 6, 0, 0}, none).at("placed_with_most_similar"), 0.0);
  EXPECT_EQ(placed({0, 0, 6, 0}, none).at("baseline_placed_with_most_similar"), 0.0);
}

// Nearest samples, 3 being the other one of individual 2.
TEST_F(ReadPlaced, StandsBesideTheBetterBaseline) {
  EXPECT_EQ(
      placed({0, 0, 0, 0}, {{0, 2, 3, 0}, {1, 2, 3, 0}}).at("baseline_placed_with_most_similar"),
      0.5);
  EXPECT_EQ(
      placed({0, 0, 0, 0}, {{1, 2, 2, 0}, {0, 1, 2, 3}}).at("baseline_placed_with_most_similar"),
      0.75);
}

// Neurons 0, 1 and 2 are one part, 3, 5 and 6 another, 8 a third one, which no known sample has
// won. Individual 0 is in the first part, 1 and 2 are in the second. Most similar are 0 (new sample
// 0), 0 or 1 (sample 1, whose number is between theirs), 2 (sample 2) and none (sample 3).
TEST_F(ReadPlaced, LooksAtTheConnectedParts) {
  outcome_.map.grid = Grid(std::make_shared<const NeuronGraph>(
      9, std::vector<NeuronGraph::Edge>{{0, 1}, {1, 2}, {3, 5}, {5, 6}}));
  const Neighbours none{{2, 2, 0, 0}, {2, 2, 0, 0}};
  outcome_.winners = {1, 5, 2, 8};
  const auto values = placed({0, 0, 6, 0}, none);
  const auto similar =
      most_similar({{1.0, 0}, {2.0, 0}, {1.2, 1}}, {{1.4, 0}, {1.5, 0}, {9.0, 1}, {1.0, 2}});
  ASSERT_EQ(similar, (std::vector<Numbers>{{0}, {0, 1}, {2}, {}}));
  EXPECT_EQ(values.at("placed_in_part_of_most_similar"), 0.5);
  // Right places among the four: 2 for sample 0, 3 for sample 1, 1 for sample 2, none for sample 3.
  EXPECT_EQ(values.at("placed_in_part_of_most_similar_chance"), 6.0 / 16.0);
}

TEST_F(ReadPlaced, IsNothingWithoutAnOrder) {
  prepared_.order.reset();
  EXPECT_TRUE(placed({0, 0, 0, 0}, {{0, 0, 0, 0}, {0, 0, 0, 0}}).empty());
}

// Explorations of things with a size, each once.
Recording sized(const std::vector<std::pair<std::string, std::string>>& things) {
  Recording recording;
  for (const auto& [name, size] : things) {
    const auto number = static_cast<float>(recording.explorations.size());
    recording.explorations.push_back(
        {{{"object", name}, {"size", size}, {"shape", "round"}},
         {},
         {{"joints", "deg", {}, Matrix<float>(1, 3, {number, 1.0F + number, 2.0F * number}), {}}}});
  }
  return recording;
}

std::map<std::string, std::string> size_groups(const PreparedStudy& prepared) {
  const StudiedLabel& groups = prepared.labels.back();
  EXPECT_EQ(groups.name, "size_group");
  std::map<std::string, std::string> found;
  for (std::size_t i = 0; i < prepared.recording.explorations.size(); ++i) {
    found[prepared.recording.explorations[i].labels[0].value] =
        groups.classes.names[groups.classes.of_sample[i]];
  }
  return found;
}

// In a group of five, two are small and three large. Many new large ones would shift the median,
// and must not.
TEST(SizeGroups, OfTheKnownStayWhateverIsTestedWith) {
  const StudyDescription description = testing::study_from(
      "[study]\nname = 'sizes'\nindividual = 'object'\norder = 'size'\nwithin = 'shape'\n" +
      testing::joints_system());
  const Recording known = sized({{"a", "1"}, {"b", "2"}, {"c", "3"}, {"d", "4"}, {"e", "5"}});
  const Recording fresh =
      sized({{"p", "2.9"}, {"q", "3"}, {"r", "30"}, {"s", "31"}, {"t", "32"}, {"u", "33"}});
  const auto single = size_groups(prepare_study(description, known, nullptr, 1).value());
  EXPECT_EQ(single, (std::map<std::string, std::string>{{"a", "small round"},
                                                        {"b", "small round"},
                                                        {"c", "large round"},
                                                        {"d", "large round"},
                                                        {"e", "large round"}}));
  auto with_new = size_groups(prepare_study(description, known, &fresh, 1).value());
  for (const auto& [name, group] : single) EXPECT_EQ(with_new.at(name), group) << name;
  EXPECT_EQ(with_new.at("p"), "small round");
  for (const char* name : {"q", "r", "u"}) EXPECT_EQ(with_new.at(name), "large round") << name;
}

}  // namespace
}  // namespace somato
