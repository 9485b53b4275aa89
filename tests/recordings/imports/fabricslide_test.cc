#include "recordings/imports/fabricslide.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/support/temporary_folder.h"

namespace somato {
namespace {

// The header of the data set, with its blanks.
std::string header() {
  std::string line = "timestamp, proximity1, proximity2";
  for (int i = 1; i <= 16; ++i) line += fmt::format(", channel{}", i);
  return line + "\n";
}

// A row whose taxels are first, first + 1, ...
std::string row(int time, int first) {
  std::string line = fmt::format("{},0,65535", time);
  for (int i = 0; i < 16; ++i) line += fmt::format(",{}", first + i);
  return line + "\n";
}

TEST(ImportFabricslide, ReadsTaxelsTimesAndSpeed) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("fabric"));
  folder.with("fabric/Linen_F120_V-100mmps_0.csv", header() + row(4328073, 10) + row(4328101, 50));
  folder.with("README.md", "not read");
  for (const std::string& path : {folder.path(), folder.file("fabric")}) {
    const Recording recording = import_fabricslide(path).value();
    EXPECT_TRUE(validate(recording));
    ASSERT_EQ(recording.explorations.size(), 1U);
    const Exploration& slide = recording.explorations[0];
    EXPECT_EQ(slide.labels,
              (std::vector<Label>{
                  {"fabric", "Linen"}, {"force", "120"}, {"velocity", "-100"}, {"trial", "0"}}));
    ASSERT_EQ(slide.channels.size(), 2U);
    const Channel& touch = slide.channels[0];
    EXPECT_EQ(touch.name, "touch");
    EXPECT_EQ(touch.unit, "counts");
    EXPECT_EQ(touch.times, (std::vector<double>{0, 0.028}));
    ASSERT_EQ(touch.frames.columns(), 16U);
    for (std::size_t i = 0; i < 16; ++i) {
      EXPECT_EQ(touch.element_names[i], fmt::format("channel{}", i + 1));
      EXPECT_EQ(touch.frames(0, i), static_cast<float>(10 + i));
      EXPECT_EQ(touch.frames(1, i), static_cast<float>(50 + i));
    }
    EXPECT_EQ(slide.channels[1], (Channel{"speed", "mm/s", {}, Matrix<float>(1, 1, 100.0F), {}}));
  }
}

TEST(ImportFabricslide, RefusesAnotherLayout) {
  const TemporaryFolder folder;
  std::string lacking = header();
  lacking.replace(lacking.find("channel16"), 9, "channel17");
  const std::string file = folder.with("Linen_F120_V100mmps_0.csv", lacking + row(1, 1));
  EXPECT_EQ(to_string(import_fabricslide(folder.path()).error()),
            file + ":1: there is no column 'channel16'; did you mean 'channel1'?");
}

TEST(ImportFabricslide, RefusesAnotherName) {
  const TemporaryFolder folder;
  const std::string file = folder.with("Linen_F120_Vfastmmps_0.csv", header() + row(1, 1));
  EXPECT_EQ(import_fabricslide(folder.path()).error().where, file);
}

}  // namespace
}  // namespace somato
