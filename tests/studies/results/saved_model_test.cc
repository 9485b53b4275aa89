#include "studies/results/saved_model.h"

#include <gtest/gtest.h>

#include "base/files/whole_file.h"
#include "base/support/temporary_folder.h"
#include "recordings/support/made_recording.h"
#include "studies/support/made_study.h"
#include "studies/support/study_results.h"

namespace somato {
namespace {

TEST(HashOfFile, IsThatOfItsBytes) {
  const TemporaryFolder folder;
  const std::string path = folder.file("letter");
  ASSERT_TRUE(save_whole(path, "a"));
  EXPECT_EQ(hash_of_file(path).value(), "fnv1a64:af63dc4c8601ec8c");  // a published test value
  EXPECT_EQ(hash_of_file(folder.file("missing")).error().kind, ErrorKind::kSystem);
}

TEST(SaveModel, RecordsTheFileInTheResults) {
  const TemporaryFolder folder;
  StudyOutcome outcome =
      testing::outcome_of(testing::small_study(), testing::objects_apart(3, 4, 2.0, 1));
  ASSERT_TRUE(save_model(folder.path(), "trained.somato", outcome.model, outcome.results));
  ASSERT_TRUE(outcome.results.model);
  EXPECT_EQ(outcome.results.model->path, "trained.somato");
  EXPECT_EQ(outcome.results.model->hash, hash_of_file(folder.file("trained.somato")).value());
  EXPECT_EQ(outcome.results.model->seed, outcome.results.pairs.front().seed);
  EXPECT_TRUE(load_system(folder.file("trained.somato")));
}

}  // namespace
}  // namespace somato
