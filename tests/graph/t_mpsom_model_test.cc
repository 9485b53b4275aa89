#include "somato/graph/t_mpsom_model.h"

#include <gtest/gtest.h>

#include "somato/files/archive.h"
#include "support/damaged_files.h"
#include "support/saved_maps.h"

namespace somato {
namespace {

TMpsom small_map() {
  return TMpsom(testing::small_t_mpsom_parameters());
}

TEST(TMpsomModel, IsTheSameWhenLoaded) {
  const TemporaryFolder folder;
  ASSERT_TRUE(save_t_mpsom(folder.file("a"), small_map()));
  const auto loaded = load_t_mpsom(folder.file("a"));
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  EXPECT_EQ(*loaded, small_map());
  ASSERT_TRUE(save_t_mpsom(folder.file("b"), *loaded));
  EXPECT_EQ(bytes_of(folder.file("b")), bytes_of(folder.file("a")));
}

TEST(TMpsomModel, RefusesEveryTruncationAndEveryTurnedBit) {
  const TemporaryFolder folder;
  const std::string path = folder.file("model.somato");
  ASSERT_TRUE(save_t_mpsom(path, small_map()));
  testing::expect_damage_refused(path, load_t_mpsom);
}

Archive saved_t_mpsom() {
  const TemporaryFolder folder;
  EXPECT_TRUE(save_t_mpsom(folder.file("a"), small_map()));
  return load_archive(folder.file("a")).value();
}

void expect_t_mpsom_model_refused(const Archive& archive, const std::string& because) {
  const TemporaryFolder folder;
  const std::string path = folder.file("hostile.somato");
  ASSERT_TRUE(save_archive(path, archive));
  const auto map = load_t_mpsom(path);
  ASSERT_FALSE(map) << because;
  EXPECT_EQ(map.error().kind, ErrorKind::kData);
  EXPECT_TRUE(map.error().where.starts_with(path)) << to_string(map.error());
  EXPECT_NE(map.error().what.find(because), std::string::npos) << to_string(map.error());
}

// What the map's own parts may be is tested with t_mpsom_archive.
TEST(TMpsomModel, RefusesWhatIsNoMapOfItsKind) {
  Archive other("som");
  const Archive archive = saved_t_mpsom();
  for (const Archive::Entry& entry : archive.entries()) other.add(entry.name, entry.content);
  expect_t_mpsom_model_refused(other, "the file holds 'som', not 't_mpsom'");
  expect_t_mpsom_model_refused(testing::without_part(archive, "t_mpsom.weights_1"), "is missing");
  expect_t_mpsom_model_refused(
      testing::with_part(archive, "t_mpsom.parameters", std::string("shape = [0]")),
      "'shape' must be");
  expect_t_mpsom_model_refused(
      testing::with_part(archive, "t_mpsom.weights_3", Array<float>{{6, 1}, std::vector<float>(6)}),
      "unknown part 't_mpsom.weights_3'");
}

TEST(TMpsomModel, SaysWhyAFileCannotBeRead) {
  const TemporaryFolder folder;
  const auto map = load_t_mpsom(folder.file("missing.somato"));
  ASSERT_FALSE(map);
  EXPECT_EQ(map.error().kind, ErrorKind::kSystem);
}

}  // namespace
}  // namespace somato
