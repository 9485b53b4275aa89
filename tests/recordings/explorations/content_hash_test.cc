#include "recordings/explorations/content_hash.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace somato {
namespace {

Recording one_exploration() {
  return {{{{{"object", "ball"}},
            "ball_1.txt",
            {{"joints",
              "deg",
              {"thumb", "index"},
              Matrix<float>(2, 2, {1.0F, -0.0F, 0.5F, 3.25F}),
              {0.0, 0.25}}}}}};
}

// The offset basis of the 64-bit hash; the second was worked out by a program of its own.
TEST(ContentHash, IsFnv1aOfTheContent) {
  EXPECT_EQ(content_hash({}), "fnv1a64:cbf29ce484222325");
  EXPECT_EQ(content_hash(one_exploration()), "fnv1a64:02560ac64e1b4afd");
}

TEST(ContentHash, DoesNotDependOnTheSource) {
  Recording elsewhere = one_exploration();
  elsewhere.explorations[0].source = "copy/ball_1.txt";
  EXPECT_EQ(content_hash(elsewhere), content_hash(one_exploration()));
}

TEST(ContentHash, DiffersWhenAnythingElseDoes) {
  const std::vector<std::function<void(Exploration&)>> changes{
      [](Exploration&) {},
      [](Exploration& e) { e.labels[0].value = "bowl"; },
      [](Exploration& e) { e.labels[0].name = "thing"; },
      [](Exploration& e) { e.labels[0] = {"objectb", "all"}; },
      [](Exploration& e) { e.channels[0].shape = {2, 1}; },
      [](Exploration& e) { e.channels[0].rate = 8.0; },
      [](Exploration& e) { e.channels[0].valid = Matrix<std::uint8_t>(2, 2, 1); },
      [](Exploration& e) { e.labels.clear(); },
      [](Exploration& e) { e.labels.push_back({"trial", "1"}); },
      [](Exploration& e) { e.channels[0].name = "wrist"; },
      [](Exploration& e) { e.channels[0].unit = "rad"; },
      [](Exploration& e) { e.channels[0].element_names[1] = "ring"; },
      [](Exploration& e) { e.channels[0].element_names = {"thumbi", "ndex"}; },
      [](Exploration& e) { e.channels[0].element_names.clear(); },
      [](Exploration& e) { e.channels[0].frames(1, 1) = 3.5F; },
      [](Exploration& e) { e.channels[0].frames(0, 1) = 0.0F; },
      [](Exploration& e) {
        e.channels[0].frames = Matrix<float>(1, 4, {1.0F, -0.0F, 0.5F, 3.25F});
      },
      [](Exploration& e) { e.channels[0].times[1] = 0.5; },
      [](Exploration& e) { e.channels[0].times.clear(); },
      [](Exploration& e) { e.channels.push_back(e.channels[0]); },
      [](Exploration& e) { e.channels.clear(); },
  };
  std::set<std::string> hashes;
  for (const auto& change : changes) {
    Recording recording = one_exploration();
    change(recording.explorations[0]);
    hashes.insert(content_hash(recording));
  }
  EXPECT_EQ(hashes.size(), changes.size());
}

TEST(ContentHash, DependsOnTheOrderOfTheExplorations) {
  Recording there = one_exploration();
  there.explorations.push_back(there.explorations[0]);
  there.explorations[1].labels[0].value = "bowl";
  Recording back = there;
  std::swap(back.explorations[0], back.explorations[1]);
  EXPECT_NE(content_hash(there), content_hash(back));
}

}  // namespace
}  // namespace somato
