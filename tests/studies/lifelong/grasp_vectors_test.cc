#include "studies/lifelong/grasp_vectors.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

// A channel with one element.
Channel channel(const std::string& name, std::vector<float> values) {
  const std::size_t frames = values.size();
  return {name, "deg", {}, Matrix<float>(frames, 1, std::move(values)), {}};
}

Exploration exploration(std::vector<float> wrist, std::vector<float> joint) {
  return {{{"object", "ball"}},
          {},
          {channel("wrist", std::move(wrist)), channel("joint", std::move(joint))}};
}

const GraspChannels kChannels{{"wrist"}, 0.5, {"joint", "wrist"}};

TEST(GraspVectors, AreTheLastFramesOfEachPose) {
  const Recording recording{{exploration({0, 0.4F, 10, 0}, {1, 2, 3, 4}),
                             exploration({0, 10.2F, 10, -0.5F}, {5, 6, 7, 8})}};
  const auto vectors = grasp_vectors(recording, kChannels);
  ASSERT_TRUE(vectors);
  ASSERT_EQ(vectors->size(), 3U);
  const std::vector<std::vector<float>> expected{{2, 0.4F}, {3, 10}, {4, 0}};
  for (std::size_t grasp = 0; grasp < 3; ++grasp) {
    const SignalView view = (*vectors)[grasp][0];
    EXPECT_EQ(std::vector<float>(view.values.begin(), view.values.end()), expected[grasp]);
  }
  EXPECT_EQ((*vectors)[1][1].values[0], 7.0F);
}

TEST(GraspVectors, RefuseWhatDoesNotFit) {
  const auto refused = [](const Exploration& other, const GraspChannels& channels, ErrorKind kind) {
    const auto vectors = grasp_vectors({{exploration({0, 10}, {1, 2}), other}}, channels);
    ASSERT_FALSE(vectors);
    EXPECT_EQ(vectors.error().kind, kind);
  };
  refused(exploration({0, 0}, {1, 2}), kChannels, ErrorKind::kData);   // one grasp only
  refused(exploration({0, 11}, {1, 2}), kChannels, ErrorKind::kData);  // another pose
  refused(exploration({0, 10}, {1, 2, 3}), kChannels, ErrorKind::kData);
  refused(exploration({0, 10}, {1, 2}), {{"wirst"}, 0.5, {"joint"}}, ErrorKind::kUsage);
  refused(exploration({0, 10}, {1, 2}), {{}, 0.5, {"joint"}}, ErrorKind::kData);
}

}  // namespace
}  // namespace somato
