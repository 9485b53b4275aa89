#include "views/skins/weights_picture.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "maps/pictures/panels.h"
#include "maps/svg/colours.h"

namespace somato {
namespace {

using test::Element;

// Two neurons in a row, with three weights each.
Som two_neurons() {
  SomParameters p;
  p.rows = 1;
  p.columns = 2;
  return Som(resolve(p, 3, 1).value(), Matrix<float>(2, 3, {0, 1, 2, 4, 3, 2}));
}

// Two elements, one above the other.
std::vector<ChannelPlaces> two_places(const std::vector<std::string>& elements) {
  return {{"touch", "pad.toml:1", elements, {{0, 0}, {0, 5}}, {}, {}}};
}

Result<std::string> drawn(const std::vector<std::string>& names,
                          const std::vector<ChannelPlaces>& layout,
                          std::optional<std::size_t> neuron = {}) {
  const auto elements = inputs_on_skin(two_neurons(), names, layout);
  if (!elements) return fail(elements.error());
  return draw_weights(two_neurons(), *elements, neuron, "a map");
}

std::vector<std::string> fills_of(const Result<std::string>& picture) {
  std::vector<std::string> fills;
  for (const Element& circle : elements(test::read_xml(picture.value()).value(), "circle")) {
    fills.push_back(circle["fill"]);
  }
  return fills;
}

std::string colour(double share) {
  return to_string(sequential_colour(share));
}

TEST(WeightsPicture, ElementsAreInputsByName) {
  const auto picture = drawn({"a", "b", "c"}, two_places({"c", "a"}));
  EXPECT_EQ(fills_of(picture),
            (std::vector<std::string>{colour(0.5), colour(0), colour(0.5), colour(1)}));
  EXPECT_EQ(
      texts(test::read_xml(*picture).value()),
      (std::vector<std::string>{"a map", "Weights of 1 x 2 neurons, rectangular plane on the skin",
                                "row 1, column 1", "row 1, column 2", "0", "4"}));
}

TEST(WeightsPicture, MayBeOfOneNeuron) {
  const auto picture = drawn({}, two_places({"2", "1"}), 1);
  EXPECT_EQ(fills_of(picture), (std::vector<std::string>{colour(0), colour(1)}));
}

TEST(WeightsPicture, RefusesOtherInputs) {
  const auto error = [](const std::vector<ChannelPlaces>& layout) {
    const auto picture = drawn({"a", "b", "c"}, layout);
    return picture ? "none" : to_string(picture.error());
  };
  EXPECT_NE(error(two_places({})).find("2 places, but 'touch' has 3 elements"), std::string::npos);
  EXPECT_NE(error(two_places({"a", "d"})).find("input 'd'"), std::string::npos);
  auto two = two_places({"a", "b"});
  two.push_back(two[0]);
  EXPECT_NE(error(two).find("2 channels"), std::string::npos);
}

}  // namespace
}  // namespace somato
