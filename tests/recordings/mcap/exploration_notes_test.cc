#include "recordings/mcap/exploration_notes.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

TEST(ExplorationNotes, KeepTheLastLabel) {
  ExplorationNotes notes;
  EXPECT_TRUE(notes.add(ExplorationNotes::label(2, {"object", "cup"})));
  EXPECT_TRUE(notes.add(ExplorationNotes::label(2, {"object", "mug"})));
  const std::vector<Label> own{{"object", "ball"}};
  EXPECT_EQ(notes.labels(1, own), own);
  EXPECT_EQ(notes.labels(2, own), (std::vector<Label>{{"object", "mug"}}));
}

TEST(ExplorationNotes, LeaveExplorationsOut) {
  ExplorationNotes notes;
  EXPECT_TRUE(notes.add(ExplorationNotes::left_out(3)));
  EXPECT_TRUE(notes.is_left_out(3));
  EXPECT_FALSE(notes.is_left_out(2));
}

TEST(ExplorationNotes, AreNotAnyOtherRecord) {
  ExplorationNotes notes;
  for (const McapMetadata& other :
       {McapMetadata{"lab", {{"exploration", "1"}, {"name", "a"}, {"value", "b"}}},
        McapMetadata{"somato.label", {{"exploration", "1"}, {"name", "a"}}},
        McapMetadata{"somato.label", {{"exploration", "x"}, {"name", "a"}, {"value", "b"}}},
        McapMetadata{"somato.label", {{"exploration", "-1"}, {"name", "a"}, {"value", "b"}}},
        McapMetadata{"somato.label", {{"exploration", "1"}, {"name", "\xFF"}, {"value", "b"}}},
        McapMetadata{"somato.left_out", {}},
        McapMetadata{"somato.left_out", {{"exploration", ""}}}}) {
    EXPECT_FALSE(notes.add(other)) << other.name;
  }
  EXPECT_TRUE(notes.labels(1, {}).empty());
}

}  // namespace
}  // namespace somato
