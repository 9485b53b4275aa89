#include "maps/t_mpsom/t_mpsom_archive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "maps/support/saved_maps.h"
#include "maps/support/t_mpsom_problems.h"

namespace somato {
namespace {

using testing::small_t_mpsom_parameters;
using testing::with_line;
using testing::with_part;
using testing::without_part;

Archive archive_of(const TMpsom& map) {
  Archive archive("test");
  add_t_mpsom(archive, "map.", map);
  return archive;
}

TMpsom small_map() {
  return TMpsom(small_t_mpsom_parameters());
}

std::string t_mpsom_text() {
  return *archive_of(small_map()).get<std::string>("map.parameters", "").value();
}

TEST(TMpsomArchive, GivesTheSameMapBack) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const TMpsomParameters parameters = testing::random_parameters(random);
    const auto weights = testing::random_weights(random, parameters, testing::Sign::kEither);
    const TMpsom map = TMpsom::from_weights(parameters, weights).value();
    const Archive archive = archive_of(map);
    const TMpsom again = t_mpsom_from(archive, "map.", "here").value();
    EXPECT_EQ(again, map);
    EXPECT_EQ(encode_archive(archive_of(again)), encode_archive(archive));
  }
}

TEST(TMpsomArchive, KeepsParametersAndWeightsOfSeveralInputsOnAnAxis) {
  const TMpsom again = t_mpsom_from(archive_of(small_map()), "map.", "here").value();
  EXPECT_EQ(again.parameters(), small_t_mpsom_parameters());
  for (std::size_t input = 0; input < 3; ++input) {
    EXPECT_EQ(again.weights(input), small_map().weights(input));
  }
}

TEST(TMpsomArchive, FindsTwoMapsByTheirPrefixes) {
  TMpsomParameters other = small_t_mpsom_parameters();
  other.seed = 3;
  Archive archive("test");
  add_t_mpsom(archive, "first.", small_map());
  add_t_mpsom(archive, "second.", TMpsom(other));
  EXPECT_EQ(t_mpsom_from(archive, "first.", "").value(), small_map());
  EXPECT_EQ(t_mpsom_from(archive, "second.", "").value(), TMpsom(other));
}

void expect_t_mpsom_refused(const Archive& archive, const std::string& because) {
  const auto map = t_mpsom_from(archive, "map.", "a.somato");
  ASSERT_FALSE(map) << because;
  EXPECT_EQ(map.error().kind, ErrorKind::kData);
  EXPECT_TRUE(map.error().where.starts_with("a.somato")) << to_string(map.error());
  EXPECT_NE(map.error().what.find(because), std::string::npos) << to_string(map.error());
}

void expect_t_mpsom_line_refused(const std::string& key, const std::string& line,
                                 const std::string& because) {
  expect_t_mpsom_refused(
      with_part(archive_of(small_map()), "map.parameters", with_line(t_mpsom_text(), key, line)),
      because);
}

TEST(TMpsomArchive, RefusesMissingParts) {
  const Archive archive = archive_of(small_map());
  for (const char* name : {"map.parameters", "map.weights_0", "map.weights_1", "map.weights_2"}) {
    expect_t_mpsom_refused(without_part(archive, name), "'" + std::string(name) + "' is missing");
  }
}

TEST(TMpsomArchive, RefusesPartsOfAnotherTypeOrShape) {
  const Archive archive = archive_of(small_map());
  expect_t_mpsom_refused(with_part(archive, "map.parameters", Array<float>{{1}, {1}}),
                         "another type");
  expect_t_mpsom_refused(with_part(archive, "map.weights_1", std::string("0")), "another type");
  const auto with_shape = [&](std::vector<std::uint64_t> shape) {
    return with_part(archive, "map.weights_1",
                     Array<float>{std::move(shape), std::vector<float>(18)});
  };
  expect_t_mpsom_refused(with_shape({18}), "not a matrix");
  expect_t_mpsom_refused(with_shape({3, 6}), "the weights of input 1 are 3 x 6, not 6 x 3");
  EXPECT_TRUE(t_mpsom_from(with_shape({6, 3}), "map.", ""));
}

TEST(TMpsomArchive, RefusesWeightsThatAreNotFinite) {
  for (const float wrong : {std::nanf(""), std::numeric_limits<float>::infinity()}) {
    std::vector<float> values(6);
    values[5] = wrong;
    expect_t_mpsom_refused(
        with_part(archive_of(small_map()), "map.weights_2", Array<float>{{6, 1}, values}),
        "not finite");
  }
}

TEST(TMpsomArchive, RefusesParametersThatCannotBe) {
  expect_t_mpsom_line_refused("arbor_sigma", "arbor_sigma = 0.0", "'arbor_sigma' must be");
  expect_t_mpsom_line_refused("arbor_sigma", "arbor_sigma = nan", "'arbor_sigma' must be");
  expect_t_mpsom_line_refused("combination", "combination = \"divided\"",
                              "'combination' must be one of");
  expect_t_mpsom_line_refused("seed", "seeds = 3", "unknown key 'seeds'");
  expect_t_mpsom_line_refused("shape", "shape = []", "'shape' is empty");
  expect_t_mpsom_line_refused("input_sizes", "input_sizes = []", "'input_sizes' is empty");
  expect_t_mpsom_line_refused("shape", "shape = [2, 3, 1]", "");
  expect_t_mpsom_line_refused("input_axes", "input_axes = [0, 0, 0]", "");
  expect_t_mpsom_line_refused("input_axes", "input_axes = [0, 7, 0]", "");
}

TEST(TMpsomArchive, RefusesSizesBeyondMemory) {
  expect_t_mpsom_line_refused("shape", "shape = [16777216, 16777216]", "");
  expect_t_mpsom_line_refused("shape", "shape = [9223372036854775807, 9223372036854775807]", "");
  expect_t_mpsom_line_refused("shape", "shape = [4096, 4096]", "");
  expect_t_mpsom_line_refused("input_sizes", "input_sizes = [4, 100000000, 1]", "");
}

}  // namespace
}  // namespace somato
