#include "views/exports/recording_export.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

TEST(RecordingExport, NamesStateTheFormat) {
  EXPECT_EQ(export_format_of("out/grasps.npz").value(), ExportFormat::kNpz);
  EXPECT_EQ(export_format_of("grasps_csv").value(), ExportFormat::kCsv);
  EXPECT_EQ(export_format_of("a.b_bag").value(), ExportFormat::kBag);
  EXPECT_EQ(export_format_of("csv").value(), ExportFormat::kCsv);
  EXPECT_FALSE(export_format_of("grasps"));
  EXPECT_FALSE(export_format_of("csv/grasps.mcap"));
}

TEST(RecordingExport, NamesAreFreeAndPlain) {
  std::set<std::string> taken{"time"};
  EXPECT_EQ(free_name("time", taken), "time_");
  EXPECT_EQ(free_name("time", taken), "time__");
  EXPECT_EQ(free_name("x", taken), "x");
  EXPECT_EQ(plain_name("a/b c.d-\u00fc9", "-."), "a_b_c.d-__9");
}

}  // namespace
}  // namespace somato
