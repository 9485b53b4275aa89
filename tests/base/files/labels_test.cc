#include "base/files/labels.h"

#include <gtest/gtest.h>

#include "base/support/temporary_folder.h"

namespace somato {
namespace {

TEST(Labels, AreOneALine) {
  const std::vector<std::string> expected = {"cup", "soft ball", "#3"};
  for (const char* text : {"cup\nsoft ball\n#3\n", "cup\r\nsoft ball\r\n#3",
                           "\xEF\xBB\xBF"
                           "cup \n\tsoft ball\n#3\n\n\n"}) {
    EXPECT_EQ(parse_labels(text, "f"), expected) << text;
  }
}

TEST(Labels, AreRefusedWithTheirLine) {
  EXPECT_EQ(to_string(parse_labels("a\n\n\nb\n", "f").error()),
            "f:2: the line is empty; write one label on every line");
  EXPECT_EQ(parse_labels("\n\n", "f").error().what, "there are no labels");
  EXPECT_EQ(parse_labels("a\n\xFF\n", "f").error().where, "f:2");
}

TEST(Labels, AreReadFromAFile) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_labels(folder.with("labels", "a\n"))->at(0), "a");
  EXPECT_EQ(read_labels(folder.file("missing")).error().kind, ErrorKind::kSystem);
}

}  // namespace
}  // namespace somato
