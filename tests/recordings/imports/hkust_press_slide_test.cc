#include "recordings/imports/hkust_press_slide.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/support/temporary_folder.h"

namespace somato {
namespace {

constexpr const char* kRun =
    "time,Fx,Fy,Fz,Ft,mu,k_eff,mu_mean,mu_std,slip,micro,material\n"
    "1770943960.0089395,0.5,-0.25,2.0,0.1,0.2,0.3,0.4,0.5,0.6,0.7,Material_Wood_raw_1\n"
    "1770943960.009108,1.5,-1.25,-0.0,0.1,0.2,0.3,0.4,0.5,0.6,0.7,Material_Wood_raw_1\n";

TEST(ImportHkustPressSlide, ReadsForcesAtTheSensorsRate) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("data_raw"));
  folder.with("data_raw/Material_Wood_raw_10.csv", kRun);
  folder.with("data_raw/Material_Wood_raw_2.csv", kRun);
  for (const std::string& path : {folder.path(), folder.file("data_raw")}) {
    const Recording recording = import_hkust_press_slide(path).value();
    EXPECT_TRUE(validate(recording));
    ASSERT_EQ(recording.explorations.size(), 2U);
    const Exploration& run = recording.explorations[0];
    EXPECT_EQ(run.labels, (std::vector<Label>{{"material", "Wood"}, {"trial", "2"}}));
    Channel force{"force",
                  "N",
                  {"Fx", "Fy", "Fz"},
                  Matrix<float>(2, 3, {0.5F, -0.25F, 2.0F, 1.5F, -1.25F, -0.0F}),
                  {}};
    force.rate = 97.0;
    EXPECT_EQ(run.channels, std::vector<Channel>{force});
  }
}

TEST(ImportHkustPressSlide, RefusesAFileWithoutForce) {
  const TemporaryFolder folder;
  const std::string file = folder.with("Material_Wood_raw_1.csv", "time,Fx,Fy\n1,2,3\n");
  EXPECT_EQ(to_string(import_hkust_press_slide(folder.path()).error()),
            file + ":1: there is no column 'Fz'; did you mean 'Fx'?");
}

}  // namespace
}  // namespace somato
