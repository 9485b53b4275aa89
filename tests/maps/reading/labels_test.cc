#include "somato/maps/labels.h"

#include <gtest/gtest.h>

#include <optional>

#include "somato/core/check.h"

namespace somato {
namespace {

TEST(NeuronLabels, GoToTheMajorityAndTiesToTheLowestClass) {
  const auto labels = NeuronLabels::by_majority({0, 0, 0, 2, 2}, {1, 1, 0, 3, 2}, 4);
  EXPECT_EQ(labels[0], 1U);
  EXPECT_EQ(labels[1], std::nullopt);
  EXPECT_EQ(labels[2], 2U);
  EXPECT_EQ(labels.labelled(), (std::vector<std::size_t>{0, 2}));
}

TEST(NeuronLabels, ClassifyByTheMostSimilarLabelledNeuron) {
  SomParameters p;
  p.rows = 1;
  p.columns = 3;
  const Som som(resolve(p, 1, 1).value(), Matrix<float>(3, 1, {0, 5, 9}));
  const auto labels = NeuronLabels::by_majority({0, 2}, {7, 8}, 3);
  SomWorkspace workspace;
  const std::vector<float> near_middle{5.1F};  // the winner, neuron 1, has no label
  EXPECT_EQ(labels.classify(som, SignalView::dense(near_middle), workspace), 8U);
  const std::vector<float> left{4.0F};
  EXPECT_EQ(labels.classify(som, SignalView::dense(left), workspace), 7U);
  EXPECT_THROW((void)NeuronLabels().classify(som, SignalView::dense(left), workspace),
               InvalidArgument);
}

TEST(NeuronLabels, RefuseWinnersThatAreNotOnTheMap) {
  EXPECT_THROW(NeuronLabels::by_majority({4}, {0}, 4), InvalidArgument);
  EXPECT_THROW(NeuronLabels::by_majority({1, 2}, {0}, 4), InvalidArgument);
}

// Two votes against one; neuron 1 is removed with its votes, and a new neuron has none.
TEST(NeuronVotes, StayWithTheirNeurons) {
  NeuronVotes votes(3);
  votes.add_all({0, 0, 0, 1, 2}, {4, 3, 4, 1, 0});
  EXPECT_EQ(votes.of(0, 4), 2U);
  EXPECT_EQ(votes.of(0, 0), 0U);
  EXPECT_EQ(votes.classes(), 5U);
  const NeuronVotes moved = votes.moved_to({2, std::nullopt, 0});
  EXPECT_EQ(moved.labels(), NeuronLabels({0, std::nullopt, 4}));
  EXPECT_EQ(moved.of(2, 3), 1U);
  NeuronVotes more = moved;
  more.add(1, 7, 2);
  EXPECT_EQ(more.labels(), NeuronLabels({0, 7, 4}));
  EXPECT_EQ(NeuronVotes(2).classes(), 0U);
  EXPECT_THROW(votes.add(3, 0), InvalidArgument);
  EXPECT_THROW((void)votes.moved_to({3}), InvalidArgument);
}

TEST(Classes, AreNumberedInOrderOfFirstAppearance) {
  const Classes classes = Classes::from_names({"boule", "block", "boule", "boccia"});
  EXPECT_EQ(classes.names, (std::vector<std::string>{"boule", "block", "boccia"}));
  EXPECT_EQ(classes.of_sample, (std::vector<std::size_t>{0, 1, 0, 2}));
}

}  // namespace
}  // namespace somato
