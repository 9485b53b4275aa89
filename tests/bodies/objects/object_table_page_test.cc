#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <sstream>

#include "base/support/places.h"
#include "base/support/temporary_folder.h"
#include "bodies/support/object_tables.h"

namespace somato {
namespace {

std::string page() {
  return bytes_of(source_path("docs/objects.md"));
}

// The text between the fences of each TOML block.
std::vector<std::string> blocks(const std::string& text) {
  std::vector<std::string> blocks;
  const std::string fence = "```toml\n";
  for (std::size_t at = text.find(fence); at != std::string::npos; at = text.find(fence, at)) {
    at += fence.size();
    blocks.push_back(text.substr(at, text.find("```", at) - at));
  }
  return blocks;
}

TEST(ObjectsPage, ItsTablesAreRead) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("meshes"));
  folder.with("meshes/cup.stl", "solid cup");
  const std::vector<std::string> all = blocks(page());
  ASSERT_EQ(all.size(), 1U);
  const auto table = read_object_table(folder.with("things.toml", all[0]), declared());
  ASSERT_TRUE(table) << to_string(table.error());
  EXPECT_EQ(table->objects.size(), 8U);
  for (std::size_t i = 0; i < table->objects.size(); ++i) {
    // One of each shape, the cone twice.
    const std::size_t shape = i < 4 ? i : i - 1;
    EXPECT_EQ(table->objects[i].shape, Choices<Shape>::all()[shape].first);
  }
  EXPECT_EQ(table->materials.at(0).hardness, Hardness::kSoft);
}

TEST(ObjectsPage, WhatItSaysIsRefusedIsRefusedInTheseWords) {
  const std::regex row(R"(\| `(\{[^`]*\})` \| `([^`]*)` \|)");
  std::istringstream lines(page());
  std::size_t rows = 0;
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (!std::regex_match(line, match, row)) continue;
    ++rows;
    const auto table =
        parse_object_table("[object]\nit = " + match[1].str() + "\n", "t.toml", declared());
    ASSERT_FALSE(table) << line;
    const std::string message = to_string(table.error());
    EXPECT_NE(message.find(match[2].str()), std::string::npos) << message << "\n" << line;
  }
  EXPECT_EQ(rows, 10U);
}

}  // namespace
}  // namespace somato
