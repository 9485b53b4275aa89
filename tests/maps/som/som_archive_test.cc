#include "maps/som/som_archive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "maps/support/saved_maps.h"

namespace somato {
namespace {

using testing::with_line;
using testing::with_part;
using testing::without_part;

Archive archive_of(const Som& som) {
  Archive archive("test");
  add_som(archive, "map.", som);
  return archive;
}

Som small_som() {
  SomParameters parameters;
  parameters.rows = 2;
  parameters.columns = 2;
  return {resolve(parameters, 10, 3).value(),
          Matrix<float>(4, 3, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11})};
}

std::string parameters_text() {
  return *archive_of(small_som()).get<std::string>("map.parameters", "").value();
}

TEST(SomArchive, GivesTheSameMapBack) {
  Random random(1);
  for (const testing::Variant& variant : testing::all_variants()) {
    for (int map = 0; map < 5; ++map) {
      const Som som = testing::trained_som(variant, 1 + random.below(5), random);
      const Archive archive = archive_of(som);
      const Som again = som_from(archive, "map.", "here").value();
      EXPECT_EQ(again.weights(), som.weights()) << testing::name_of(variant);
      EXPECT_EQ(parameters_to_toml(again.parameters()), parameters_to_toml(som.parameters()));
      EXPECT_EQ(encode_archive(archive_of(again)), encode_archive(archive));
    }
  }
}

TEST(SomArchive, KeepsEveryWeightAndParameterThatIsPossible) {
  const Som som = small_som();
  LaneMatrix<float> weights = som.weights();
  weights(0, 0) = -0.0F;
  weights(1, 1) = std::numeric_limits<float>::denorm_min();
  weights(2, 2) = -std::numeric_limits<float>::max();
  SomParameters parameters = som.parameters();
  parameters.learning_rate_start = 0.1 + 0.2;
  parameters.radius_end = 1e-300;
  parameters.softmax_exponent = 1e300;
  parameters.seed = 1'000'000'000'000'000;
  parameters.arithmetic = Arithmetic::kInnerProducts;
  const Som odd(parameters, weights);
  const Som again = som_from(archive_of(odd), "map.", "here").value();
  EXPECT_TRUE(std::signbit(again.weights()(0, 0)));
  EXPECT_EQ(again.weights(), odd.weights());
  EXPECT_EQ(again.parameters().learning_rate_start, 0.1 + 0.2);
  EXPECT_EQ(again.parameters().radius_end, 1e-300);
  EXPECT_EQ(parameters_to_toml(again.parameters()), parameters_to_toml(parameters));
}

TEST(SomArchive, FindsTwoMapsByTheirPrefixes) {
  Archive archive("test");
  LaneMatrix<float> weights = small_som().weights();
  weights(3, 0) = 70.0F;
  const Som other(small_som().parameters(), weights);
  add_som(archive, "first.", small_som());
  add_som(archive, "second.", other);
  EXPECT_EQ(som_from(archive, "first.", "")->weights(), small_som().weights());
  EXPECT_EQ(som_from(archive, "second.", "")->weights(), other.weights());
}

void expect_refused(const Archive& archive, const std::string& because) {
  const auto som = som_from(archive, "map.", "a.somato");
  ASSERT_FALSE(som) << because;
  EXPECT_EQ(som.error().kind, ErrorKind::kData);
  EXPECT_TRUE(som.error().where.starts_with("a.somato")) << to_string(som.error());
  EXPECT_NE(som.error().what.find(because), std::string::npos) << to_string(som.error());
}

Som som_of_some_elements() {
  return {small_som().parameters(), small_som().weights(), StoredElements(300000, {7, 8, 299999})};
}

TEST(SomArchive, KeepsWhichElementsHaveWeights) {
  const Som again = som_from(archive_of(som_of_some_elements()), "map.", "here").value();
  EXPECT_EQ(again.elements(), som_of_some_elements().elements());
  EXPECT_EQ(again.weights(), small_som().weights());
  EXPECT_EQ(archive_of(again), archive_of(som_of_some_elements()));
  EXPECT_FALSE(archive_of(small_som()).find("map.elements"));
  EXPECT_FALSE(archive_of(small_som()).find("map.input_size"));
}

TEST(SomArchive, RefusesElementsThatCannotBe) {
  const Archive archive = archive_of(som_of_some_elements());
  const auto with_elements = [&](std::vector<std::uint64_t> shape,
                                 std::vector<std::int64_t> elements) {
    return with_part(archive, "map.elements",
                     Array<std::int64_t>{std::move(shape), std::move(elements)});
  };
  EXPECT_TRUE(som_from(with_elements({3}, {0, 1, 2}), "map.", ""));
  expect_refused(with_elements({3}, {7, 9, 8}), "'map.elements' is not an ascending list");
  expect_refused(with_elements({3}, {7, 7, 8}), "'map.elements' is not an ascending list");
  expect_refused(with_elements({1, 3}, {7, 8, 9}), "'map.elements' is not an ascending list");
  expect_refused(with_elements({3}, {7, 8, 300000}), "an element outside the input");
  expect_refused(with_elements({3}, {-1, 8, 9}), "an element outside the input");
  // As a number of 32 bits it would be 9.
  expect_refused(with_elements({3}, {7, 8, (std::int64_t{1} << 32) + 9}), "outside the input");
  expect_refused(with_elements({2}, {7, 8}), "'map.elements' does not fit the map's weights");
  expect_refused(with_elements({4}, {7, 8, 9, 10}), "'map.elements' does not fit");
  expect_refused(with_part(archive, "map.elements", Array<float>{{3}, {7, 8, 9}}), "another type");
  expect_refused(without_part(archive, "map.elements"), "'map.elements' is missing");
}

TEST(SomArchive, RefusesInputSizesThatCannotBe) {
  const Archive archive = archive_of(som_of_some_elements());
  const auto with_size = [&](std::vector<std::uint64_t> shape, std::vector<std::int64_t> size) {
    return with_part(archive, "map.input_size",
                     Array<std::int64_t>{std::move(shape), std::move(size)});
  };
  EXPECT_TRUE(som_from(with_size({1}, {std::int64_t{1} << 32}), "map.", ""));
  for (const std::int64_t size :
       {std::int64_t{0}, std::int64_t{-1}, (std::int64_t{1} << 32) + 1,
        std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min()}) {
    expect_refused(with_size({1}, {size}), "'map.input_size' is not a valid input size");
  }
  expect_refused(with_size({2}, {300000, 300000}), "'map.input_size' is not a valid input size");
  expect_refused(with_size({1, 1}, {300000}), "'map.input_size' is not a valid input size");
  expect_refused(with_size({1}, {299999}), "an element outside the input");
  expect_refused(without_part(archive, "map.input_size"), "'map.input_size' is missing");
}

void expect_line_refused(const std::string& key, const std::string& line,
                         const std::string& because) {
  expect_refused(
      with_part(archive_of(small_som()), "map.parameters", with_line(parameters_text(), key, line)),
      because);
}

TEST(SomArchive, RefusesMissingParts) {
  const Archive archive = archive_of(small_som());
  expect_refused(without_part(archive, "map.parameters"), "'map.parameters' is missing");
  expect_refused(without_part(archive, "map.weights"), "'map.weights' is missing");
}

TEST(SomArchive, RefusesPartsOfAnotherType) {
  const Archive archive = archive_of(small_som());
  expect_refused(with_part(archive, "map.parameters", Array<float>{{1}, {1}}), "another type");
  expect_refused(with_part(archive, "map.weights", std::string("0 1 2")), "another type");
  expect_refused(with_part(archive, "map.weights", Array<double>{{4, 3}, std::vector<double>(12)}),
                 "another type");
}

TEST(SomArchive, RefusesWeightsOfAnotherShape) {
  const Archive archive = archive_of(small_som());
  const auto with_shape = [&](std::vector<std::uint64_t> shape) {
    return with_part(archive, "map.weights",
                     Array<float>{std::move(shape), std::vector<float>(12)});
  };
  expect_refused(with_shape({12}), "not a matrix");
  expect_refused(with_shape({4, 3, 1}), "not a matrix");
  expect_refused(with_shape({3, 4}), "do not fit its grid");
  expect_refused(with_shape({12, 1}), "do not fit its grid");
  EXPECT_TRUE(som_from(with_shape({4, 3}), "map.", ""));
}

TEST(SomArchive, RefusesWeightsThatAreNotFinite) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const float wrong : {std::nanf(""), kInfinity, -kInfinity}) {
    for (const std::size_t place : {0U, 11U}) {
      std::vector<float> values(12);
      values[place] = wrong;
      expect_refused(
          with_part(archive_of(small_som()), "map.weights", Array<float>{{4, 3}, values}),
          "not finite");
    }
  }
}

TEST(SomArchive, RefusesParametersThatAreLeftAutomatic) {
  for (const char* key : {"normalize_input", "iterations", "radius_start", "radius_reached_at",
                          "learning_rate_reached_at", "arithmetic"}) {
    expect_line_refused(key, std::string(key) + " = \"automatic\"", "still automatic");
  }
}

TEST(SomArchive, RefusesParametersThatCannotBe) {
  expect_line_refused("rows", "rows = 0", "'rows' must be");
  expect_line_refused("rows", "rows = 2.0", "'rows' must be");
  expect_line_refused("rows", "rows = 3", "do not fit its grid");
  expect_line_refused("radius_end", "radius_end = nan", "'radius_end' must be");
  expect_line_refused("radius_end", "radius_end = inf", "'radius_end' must be");
  expect_line_refused("learning_rate_end", "learning_rate_end = 1.5", "'learning_rate_end' must");
  expect_line_refused("lattice", "lattice = \"triangular\"", "'lattice' must be one of");
  expect_line_refused("seed", "seeds = 3", "unknown key 'seeds'");
  expect_line_refused("seed", "[seed]", "must be a value");
  expect_line_refused("seed", "seed = ", "");
  expect_line_refused("seed", "rows = 2", "");  // twice
}

TEST(SomArchive, RefusesParametersThatContradictEachOther) {
  std::string text =
      with_line(parameters_text(), "radius_schedule", "radius_schedule = \"exponential\"");
  text = with_line(text, "radius_end", "radius_end = 0.0");
  expect_refused(with_part(archive_of(small_som()), "map.parameters", text), "at 0");
}

TEST(SomArchive, RefusesAGridBeyondMemory) {
  std::string text = with_line(parameters_text(), "rows", "rows = 16777216");
  text = with_line(text, "columns", "columns = 16777216");
  expect_refused(with_part(archive_of(small_som()), "map.parameters", text),
                 "a map of 16777216 x 16777216 has more than");
  expect_line_refused("rows", "rows = 9223372036854775807", "'rows' must be");
  expect_line_refused("rows", "rows = 4194304", "do not fit its grid");
}

Som graph_som() {
  SomParameters parameters;
  parameters.rows = 1;
  parameters.columns = 3;
  return {resolve(parameters, 1, 2).value(), Matrix<float>(3, 2, {0, 1, 2, 3, 4, 5}),
          std::make_shared<const NeuronGraph>(3, std::vector<NeuronGraph::Edge>{{0, 2}, {1, 2}})};
}

TEST(SomArchive, GivesTheSameGraphBack) {
  const Som som = graph_som();
  const Som again = som_from(archive_of(som), "map.", "here").value();
  EXPECT_EQ(again.grid(), som.grid());
  EXPECT_EQ(again.weights(), som.weights());
  EXPECT_EQ(encode_archive(archive_of(again)), encode_archive(archive_of(som)));
}

TEST(SomArchive, RefusesADamagedGraph) {
  using Integers = Array<std::int64_t>;
  const Archive archive = archive_of(graph_som());
  for (const Integers& graph :
       {Integers{{3, 2}, {4, 2, 0, 2, 1, 2}}, Integers{{3, 2}, {3, 1, 0, 2, 1, 2}},
        Integers{{3, 2}, {3, 2, 0, 3, 1, 2}}, Integers{{3, 2}, {3, 2, 2, 0, 1, 2}},
        Integers{{3, 2}, {3, 2, 1, 2, 0, 2}}, Integers{{3, 2}, {3, 2, 0, 2, 0, 2}},
        Integers{{3, 2}, {3, 2, -1, 2, 1, 2}}, Integers{{6}, {3, 2, 0, 2, 1, 2}}}) {
    const auto som = som_from(with_part(archive, "map.graph", graph), "map.", "here");
    ASSERT_FALSE(som);
    EXPECT_EQ(som.error().kind, ErrorKind::kData);
  }
}

}  // namespace
}  // namespace somato
