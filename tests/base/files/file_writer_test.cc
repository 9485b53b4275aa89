#include "base/files/file_writer.h"

#include <gtest/gtest.h>

#include <utility>

#include "base/support/temporary_folder.h"

namespace somato {
namespace {

TEST(FileWriter, TheFileIsTheOldOneUntilAllIsWritten) {
  const TemporaryFolder folder;
  const std::string path = folder.with("x", "old");
  auto writer = FileWriter::begin(path);
  ASSERT_TRUE(writer);
  ASSERT_TRUE(writer->write("new "));
  ASSERT_TRUE(writer->write("content"));
  EXPECT_EQ(bytes_of(path), "old");
  ASSERT_TRUE(writer->commit());
  EXPECT_EQ(bytes_of(path), "new content");
  EXPECT_EQ(folder.count(), 1);
}

TEST(FileWriter, WhatIsNotFinishedLeavesNothingBehind) {
  const TemporaryFolder folder;
  {
    auto writer = FileWriter::begin(folder.file("x"));
    ASSERT_TRUE(writer->write("half"));
    const FileWriter moved = std::move(*writer);
  }
  EXPECT_EQ(folder.count(), 0);
}

TEST(FileWriter, ReportsErrorsOfTheSystem) {
  const TemporaryFolder folder;
  EXPECT_EQ(FileWriter::begin(folder.file("none/x")).error().kind, ErrorKind::kSystem);
}

}  // namespace
}  // namespace somato
