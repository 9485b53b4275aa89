#include "studies/description/folds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;
using Folds = std::vector<Fold>;

// Samples that every protocol can divide: two groups at least, classes at random.
FoldSamples some_samples(std::size_t count, std::uint64_t seed = 1) {
  Random random(seed);
  FoldSamples samples;
  samples.samples = count;
  samples.test_samples = 3;
  samples.folds = 2 + random.below(count - 1);
  samples.seed = seed;
  for (std::size_t i = 0; i < count; ++i) {
    samples.groups.push_back(i < 2 ? i : random.below(4));
    samples.classes.push_back(random.below(3));
  }
  return samples;
}

bool contains(const Numbers& samples, std::size_t sample) {
  return std::find(samples.begin(), samples.end(), sample) != samples.end();
}

TEST(Protocol, TrainIsTestLearnsAndTestsAll) {
  EXPECT_EQ(folds(Protocol::kTrainIsTest, {3}), (Folds{{{0, 1, 2}, {0, 1, 2}}}));
  EXPECT_EQ(folds(Protocol::kTrainIsTest, {1}), (Folds{{{0}, {0}}}));
}

TEST(Protocol, LeaveOneOutTestsEachOnTheOthers) {
  EXPECT_EQ(folds(Protocol::kLeaveOneOut, {3}),
            (Folds{{{1, 2}, {0}}, {{0, 2}, {1}}, {{0, 1}, {2}}}));
}

TEST(Protocol, LeaveGroupOutTestsEachGroupOnTheOthers) {
  FoldSamples samples{5};
  samples.groups = {7, 2, 7, 9, 2};
  EXPECT_EQ(folds(Protocol::kLeaveGroupOut, samples),
            (Folds{{{0, 2, 3}, {1, 4}}, {{1, 3, 4}, {0, 2}}, {{0, 1, 2, 4}, {3}}}));
}

TEST(Protocol, TestDataLearnsAllAndTestsAllOfTheOther) {
  EXPECT_EQ(folds(Protocol::kTestData, {3, 2}), (Folds{{{0, 1, 2}, {3, 4}}}));
}

TEST(Protocol, LeaveClassOutHoldsAPartOfTheOthersOut) {
  for (std::uint64_t seed = 1; seed < 20; ++seed) {
    FoldSamples samples = some_samples(10 + seed, seed);
    samples.folds = 2 + seed % 4;
    const Folds parts = folds(Protocol::kFolds, samples);
    const Folds classes = folds(Protocol::kLeaveClassOut, samples);
    ASSERT_EQ(classes.size(), 3U);
    for (std::size_t number = 0; number < 3; ++number) {
      const Fold& fold = classes[number];
      for (std::size_t i = 0; i < samples.samples; ++i) {
        const bool is_unknown = samples.classes[i] == number;
        const bool is_held_out = contains(parts[number % samples.folds].test, i);
        EXPECT_EQ(contains(fold.test, i), is_unknown);
        EXPECT_EQ(contains(fold.known, i), !is_unknown && is_held_out);
        EXPECT_EQ(contains(fold.training, i), !is_unknown && !is_held_out);
      }
      EXPECT_TRUE(std::is_sorted(fold.known.begin(), fold.known.end()));
    }
  }
  FoldSamples one_class{3};
  one_class.classes = {0, 0, 0};
  one_class.folds = 2;
  EXPECT_THROW((void)folds(Protocol::kLeaveClassOut, one_class), InvalidArgument);
}

TEST(Protocol, TestLastTestsTheLastOfEachClassOnTheEarlierOnes) {
  FoldSamples samples{7};
  samples.classes = {0, 1, 0, 1, 0, 1, 0};
  samples.test_last = 2;
  const Folds last{{{0, 1, 2}, {3, 4, 5, 6}}};
  EXPECT_EQ(folds(Protocol::kFolds, samples), last);
  EXPECT_EQ(folds(Protocol::kObjectAfterObject, samples), last);
  EXPECT_EQ(folds(Protocol::kLeaveClassOut, samples),
            (Folds{{{1}, {0, 2, 4, 6}, {3, 5}}, {{0, 2}, {1, 3, 5}, {4, 6}}}));
  samples.test_last = 4;
  EXPECT_THROW((void)folds(Protocol::kFolds, samples), InvalidArgument);
}

TEST(Protocol, EverySampleIsTestedOnceAndItsFoldLearnsAllTheOthers) {
  for (const auto& [protocol, name] : Choices<Protocol>::all()) {
    if (protocol == Protocol::kLeaveClassOut) continue;  // holds out others: the preceding test
    const bool own = protocol == Protocol::kTestData;
    for (std::size_t count = 2; count < 20; ++count) {
      const FoldSamples samples = some_samples(count, count);
      Numbers tests(count + 3);
      for (const Fold& fold : folds(protocol, samples)) {
        for (const std::size_t sample : fold.test) ++tests.at(sample);
        EXPECT_TRUE(std::is_sorted(fold.training.begin(), fold.training.end())) << name;
        EXPECT_TRUE(std::is_sorted(fold.test.begin(), fold.test.end())) << name;
        const bool all = own || protocol == Protocol::kTrainIsTest;
        EXPECT_EQ(fold.training.size(), all ? count : count - fold.test.size()) << name;
      }
      for (std::size_t i = 0; i < count + 3; ++i) {
        EXPECT_EQ(tests[i], (i < count) == own ? 0U : 1U) << name << " " << count << " " << i;
      }
    }
  }
}

// The parts of each class in the order of the recording.
std::map<std::size_t, Numbers> parts_of_classes(const FoldSamples& samples) {
  const Folds parts = folds(Protocol::kFolds, samples);
  Numbers part_of(samples.samples);
  for (std::size_t part = 0; part < parts.size(); ++part) {
    for (const std::size_t sample : parts[part].test) part_of[sample] = part;
  }
  std::map<std::size_t, Numbers> classes;
  for (std::size_t i = 0; i < samples.samples; ++i) {
    classes[samples.classes[i]].push_back(part_of[i]);
  }
  return classes;
}

TEST(Blocks, KeepConsecutiveSamplesOfAClassTogether) {
  FoldSamples samples{12};
  samples.choice = FoldChoice::kBlocks;
  samples.classes = {0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1};
  samples.folds = 3;
  EXPECT_EQ(folds(Protocol::kFolds, samples), (Folds{{{4, 5, 6, 7, 8, 9, 10, 11}, {0, 1, 2, 3}},
                                                     {{0, 1, 2, 3, 8, 9, 10, 11}, {4, 5, 6, 7}},
                                                     {{0, 1, 2, 3, 4, 5, 6, 7}, {8, 9, 10, 11}}}));
  EXPECT_EQ(largest_block(samples), 2U);
}

TEST(Blocks, FollowEachOtherAndAreAsLargeAsInterleavedParts) {
  for (std::size_t count = 2; count < 40; ++count) {
    FoldSamples blocks = some_samples(count, count);
    blocks.choice = FoldChoice::kBlocks;
    FoldSamples interleaved = blocks;
    interleaved.choice = FoldChoice::kInterleaved;
    auto dealt = parts_of_classes(interleaved);
    std::size_t largest = 0;
    for (const auto& [number, parts] : parts_of_classes(blocks)) {
      EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end())) << count;
      std::sort(dealt[number].begin(), dealt[number].end());
      EXPECT_EQ(parts, dealt[number]) << count;
      for (const std::size_t part : parts) {
        largest = std::max(largest,
                           static_cast<std::size_t>(std::count(parts.begin(), parts.end(), part)));
      }
    }
    EXPECT_EQ(largest_block(blocks), largest);
    EXPECT_EQ(folds(Protocol::kFolds, blocks).size(), blocks.folds) << "none is empty";
  }
}

TEST(Blocks, DoNotDependOnTheSeed) {
  FoldSamples one = some_samples(30, 3);
  one.choice = FoldChoice::kBlocks;
  FoldSamples other = one;
  other.seed = 77;
  EXPECT_EQ(folds(Protocol::kFolds, one), folds(Protocol::kFolds, other));
  EXPECT_EQ(folds(Protocol::kLeaveClassOut, one), folds(Protocol::kLeaveClassOut, other));
}

TEST(Blocks, OfFewerSamplesThanFoldsAreSingleSamples) {
  FoldSamples samples{6};
  samples.choice = FoldChoice::kBlocks;
  samples.classes = {0, 0, 0, 1, 1, 1};
  samples.folds = 5;
  EXPECT_EQ(largest_block(samples), 1U);
  const Folds parts = folds(Protocol::kFolds, samples);
  ASSERT_EQ(parts.size(), 5U);
  for (const Fold& fold : parts) EXPECT_FALSE(fold.test.empty());
}

TEST(Protocol, NeverTrainsOnWhatItTests) {
  for (const Protocol protocol :
       {Protocol::kLeaveOneOut, Protocol::kLeaveGroupOut, Protocol::kFolds, Protocol::kTestData}) {
    for (std::size_t count = 2; count < 20; ++count) {
      for (const Fold& fold : folds(protocol, some_samples(count, count))) {
        for (const std::size_t sample : fold.test) EXPECT_FALSE(contains(fold.training, sample));
      }
    }
  }
}

TEST(Protocol, LeaveGroupOutNeverLearnsFromTheTestedGroup) {
  const FoldSamples samples = some_samples(30, 4);
  const Folds groups = folds(Protocol::kLeaveGroupOut, samples);
  EXPECT_EQ(groups.size(), 4U);
  for (const Fold& fold : groups) {
    const std::size_t group = samples.groups[fold.test.front()];
    for (const std::size_t sample : fold.test) EXPECT_EQ(samples.groups[sample], group);
    for (const std::size_t sample : fold.training) EXPECT_NE(samples.groups[sample], group);
  }
}

// How many samples of each class a part holds.
std::map<std::size_t, std::size_t> classes_in(const Fold& fold, const FoldSamples& samples) {
  std::map<std::size_t, std::size_t> counts;
  for (const std::size_t sample : fold.test) ++counts[samples.classes[sample]];
  return counts;
}

TEST(Protocol, FoldsAreEqualToWithinOneAndSpreadEachClass) {
  for (std::uint64_t seed = 1; seed < 40; ++seed) {
    const FoldSamples samples = some_samples(3 + seed, seed);
    const Folds parts = folds(Protocol::kFolds, samples);
    ASSERT_EQ(parts.size(), samples.folds);
    for (const Fold& a : parts) {
      for (const Fold& b : parts) {
        EXPECT_LE(a.test.size(), b.test.size() + 1);
        auto others = classes_in(b, samples);
        for (const auto& [its_class, count] : classes_in(a, samples)) {
          EXPECT_LE(count, others[its_class] + 1) << seed << ", class " << its_class;
        }
      }
    }
  }
}

TEST(Protocol, FoldsAreAFunctionOfTheSeed) {
  FoldSamples samples = some_samples(20, 6);
  samples.folds = 4;
  std::set<Numbers> first_parts;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    samples.seed = seed;
    const Folds parts = folds(Protocol::kFolds, samples);
    EXPECT_EQ(parts, folds(Protocol::kFolds, samples));
    first_parts.insert(parts.front().test);
  }
  EXPECT_GT(first_parts.size(), 5U);
}

// With as many parts as samples there is one way only.
TEST(Protocol, AsManyFoldsAsSamplesLeaveOneOut) {
  FoldSamples samples = some_samples(7, 2);
  samples.folds = 7;
  Folds parts = folds(Protocol::kFolds, samples);
  std::sort(parts.begin(), parts.end(),
            [](const Fold& a, const Fold& b) { return a.test < b.test; });
  EXPECT_EQ(parts, folds(Protocol::kLeaveOneOut, samples));
}

// Samples 2, 3 and 7 to 9: two of class 0, three of class 1, so that each of two parts has both.
TEST(Protocol, FoldsAmongChosenSamplesHaveTheirNumbers) {
  const Numbers chosen{2, 3, 7, 8, 9};
  const Numbers classes{5, 5, 0, 0, 5, 5, 5, 1, 1, 1};
  const Folds parts = folds_among(chosen, classes, 2, 3);
  ASSERT_EQ(parts.size(), 2U);
  for (const Fold& part : parts) {
    Numbers all = part.training;
    all.insert(all.end(), part.test.begin(), part.test.end());
    std::sort(all.begin(), all.end());
    EXPECT_EQ(all, chosen);
    EXPECT_EQ(std::count_if(part.test.begin(), part.test.end(),
                            [](std::size_t sample) { return sample < 4; }),
              1);
  }
  EXPECT_EQ(folds_among(chosen, classes, 99, 3).size(), chosen.size());
}

TEST(Protocol, NeedsSomethingToTrainOnAndToTest) {
  EXPECT_THROW(folds(Protocol::kTrainIsTest, {0}), InvalidArgument);
  EXPECT_THROW(folds(Protocol::kLeaveOneOut, {1}), InvalidArgument);
  EXPECT_THROW(folds(Protocol::kTestData, {0, 2}), InvalidArgument);
  EXPECT_THROW(folds(Protocol::kTestData, {2, 0}), InvalidArgument);
  FoldSamples samples = some_samples(4);
  samples.groups = {1, 1, 1, 1};
  EXPECT_THROW(folds(Protocol::kLeaveGroupOut, samples), InvalidArgument);
  samples.groups = {1, 2, 1};
  EXPECT_THROW(folds(Protocol::kLeaveGroupOut, samples), InvalidArgument);
  for (const std::size_t parts : {0U, 1U, 5U}) {
    samples.folds = parts;
    EXPECT_THROW(folds(Protocol::kFolds, samples), InvalidArgument) << parts;
  }
}

}  // namespace
}  // namespace somato
