#include "views/exports/bag_export.h"

#include <gtest/gtest.h>

#include "base/files/toml_file.h"
#include "base/support/temporary_folder.h"
#include "recordings/bags/bag_description.h"
#include "recordings/bags/bag_import.h"
#include "recordings/explorations/collected_explorations.h"
#include "recordings/explorations/exploration_frames.h"
#include "views/exports/varied_recording.h"

namespace somato {
namespace {

class BagExportTest : public ::testing::Test {
 protected:
  void write(const Recording& recording) const {
    auto to = BagExport::begin(folder_.file("out")).value();
    for (const Exploration& exploration : recording.explorations) {
      ASSERT_TRUE(hand_frames(exploration, *to));
    }
    ASSERT_TRUE(to->finish());
  }

  std::vector<Exploration> read() const {
    std::vector<Exploration> explorations;
    const auto description = read_toml(folder_.file("out/import.toml")).and_then(read_bag_import);
    EXPECT_TRUE(description) << to_string(description.error());
    CollectedExplorations collected([&](Exploration exploration) {
      explorations.push_back(std::move(exploration));
      return Result<void>();
    });
    const auto report =
        import_bags(folder_.file("out"), description.value(), collected, [] { return true; });
    EXPECT_TRUE(report) << to_string(report.error());
    return explorations;
  }

  TemporaryFolder folder_;
};

TEST_F(BagExportTest, ABagIsReadBackToTheSameExplorations) {
  const Recording written = varied_recording();
  write(written);
  const std::vector<Exploration> back = read();
  ASSERT_EQ(back.size(), written.explorations.size());
  for (std::size_t e = 0; e < back.size(); ++e) {
    Exploration expected = written.explorations[e];
    EXPECT_EQ(back[e].labels, expected.labels);
    Channel& joints = expected.channels[0];
    for (std::size_t i = 0; i < joints.frames.rows(); ++i) {
      joints.times.push_back(static_cast<double>(i) / 50.0);
    }
    joints.rate = 0.0;
    expected.channels[2].element_names.clear();
    EXPECT_EQ(back[e].channels, expected.channels);
  }
}

TEST_F(BagExportTest, NamesOfTopicsAreThoseThatRos2Permits) {
  Channel touch{"2 touch//x", "", {}, Matrix<float>(1, 1, 1.0F), {0.0}, 0.0};
  Channel same{"2-touch//x", "", {}, Matrix<float>(1, 1, 2.0F), {0.0}, 0.0};
  Channel events{"exploration", "", {}, Matrix<float>(1, 1, 3.0F), {0.0}, 0.0};
  write({{{{{"a b", "1"}, {"a/b", "2"}}, "", {touch, same, events}}}});
  const std::string metadata = bytes_of(folder_.file("out/metadata.yaml"));
  for (const char* topic : {"/_2_touch/_/x", "/_2_touch/_/x_", "/exploration_", "/exploration",
                            "/labels/a_b", "/labels/a_b_"}) {
    EXPECT_NE(metadata.find(std::string("name: ") + topic + "\n"), std::string::npos) << topic;
  }
  const std::vector<Exploration> back = read();
  ASSERT_EQ(back.size(), 1U);
  EXPECT_EQ(back[0].labels, (std::vector<Label>{{"a b", "1"}, {"a/b", "2"}}));
  EXPECT_EQ(back[0].channels.at(2).frames(0, 0), 3.0F);
}

TEST_F(BagExportTest, TimesOfACalendarAreKept) {
  Channel touch{"touch", "", {}, Matrix<float>(2, 1, 1.0F), {1.7e9, 1.7e9 + 2}, 0.0};
  write({{{{{"object", "cup"}}, "", {touch}}}});
  EXPECT_NE(bytes_of(folder_.file("out/metadata.yaml"))
                .find("nanoseconds_since_epoch: 1699999999998000000\n"),
            std::string::npos);
}

}  // namespace
}  // namespace somato
