#include "bodies/body/driving.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace somato {
namespace {

std::size_t columns_of(std::vector<std::string> names, std::vector<std::size_t> shape) {
  ChannelDescription sensor;
  sensor.name = "touch";
  sensor.element_names = std::move(names);
  sensor.shape = std::move(shape);
  return detail::empty_channel(sensor).frames.columns();
}

TEST(EmptyChannel, HasAColumnForEachElementThatIsNamedOrOfTheShape) {
  EXPECT_EQ(columns_of({"a", "b", "c"}, {}), 3U);
  EXPECT_EQ(columns_of({}, {4, 5}), 20U);
  EXPECT_EQ(columns_of({"a", "b"}, {2, 1}), 2U);
  EXPECT_EQ(columns_of({}, {}), 0U);  // only known from its frames
}

}  // namespace
}  // namespace somato
