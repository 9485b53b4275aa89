#include "hardware/devices/state_log.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "somato/core/check.h"

namespace somato::devices {
namespace {

TEST(StateLog, WritesStatesAsCsvWithEmptyCellsForWhatIsUnknown) {
  StateLog states({"wrist"});
  ServoReport report;
  report.position = 1512.0;
  report.error = 32;
  states.add(0.25, std::array{10.0}, std::array{2.5}, std::array{report},
             std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(states.to_csv(),
            "time,frame_age,wrist target,wrist position,wrist reported,wrist current,wrist error\n"
            "0.2500,,10,2.5,1512,,32\n");
}

TEST(StateLog, KeepsTheLastFifty) {
  StateLog states({"wrist"});
  const std::array<ServoReport, 1> report;
  for (int i = 0; i < 120; ++i) {
    states.add(i, std::array{0.0}, std::array{0.0}, report, 0.0);
  }
  EXPECT_EQ(states.size(), 50U);
  const std::string text = states.to_csv();
  EXPECT_EQ(text.substr(text.find('\n') + 1, 8), "70.0000,");
  EXPECT_NE(text.find("\n119.0000,"), std::string::npos);
  EXPECT_THROW(states.add(0.0, {}, {}, {}, 0.0), InvalidArgument);
}

}  // namespace
}  // namespace somato::devices
