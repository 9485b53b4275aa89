#include "systems/exchange/map_array.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/arrays/npy_numbers.h"

namespace somato {
namespace {

template <typename T>
std::string array_bytes(const std::vector<T>& numbers, const std::vector<std::size_t>& shape) {
  return npy_of_numbers<T>(numbers, shape);
}

// Row r, column c and feature d have the weight 100 r + 10 c + d.
const Matrix<float> kNumbered(6, 2, {0, 1, 10, 11, 20, 21, 100, 101, 110, 111, 120, 121});

std::vector<double> numbered() {
  return {kNumbered.values().begin(), kNumbered.values().end()};
}

// The same in Fortran order: the first index changes first.
std::string in_fortran_order() {
  const std::vector<std::size_t> shape{2, 3, 2};
  std::string bytes = npy_file_start("<f8", shape, true);
  for (int d = 0; d < 2; ++d) {
    for (int c = 0; c < 3; ++c) {
      for (int r = 0; r < 2; ++r) append_little_endian(bytes, 100.0 * r + 10.0 * c + d);
    }
  }
  return bytes;
}

TEST(MapArray, ReadsRowsColumnsAndFeaturesInEitherOrder) {
  for (const std::string& bytes : {array_bytes(numbered(), {2, 3, 2}), in_fortran_order()}) {
    const auto array = map_array_in_npy(bytes, "w.npy");
    ASSERT_TRUE(array) << to_string(array.error());
    EXPECT_EQ(array->weights, kNumbered);
    const auto model = map_of_weights({}, *array, {"x", "y"}, "w.npy");
    ASSERT_TRUE(model) << to_string(model.error());
    EXPECT_EQ(model->som.grid().rows(), 2);
    EXPECT_EQ(model->som.grid().columns(), 3);
    EXPECT_EQ(model->som.weight(5, 1), 121.0F);
    EXPECT_TRUE(load_som_model("/nowhere").error().kind == ErrorKind::kSystem);
    EXPECT_TRUE(decode_som_model(encode_som_model(*model), "bytes"));
  }
}

TEST(MapArray, TakesTheSidesOfAListOfNeurons) {
  const auto sides = [](std::optional<std::size_t> rows, std::optional<std::size_t> columns) {
    SomParameters parameters;
    parameters.rows = rows;
    parameters.columns = columns;
    const auto model = map_of_weights(parameters, {{6, 2}, kNumbered}, {}, "w.npy");
    return model ? std::pair(model->som.grid().rows(), model->som.grid().columns())
                 : std::pair<std::size_t, std::size_t>();
  };
  using Sides = std::pair<std::size_t, std::size_t>;
  EXPECT_EQ(sides(2, {}), (Sides{2, 3}));
  EXPECT_EQ(sides({}, 2), (Sides{3, 2}));
  EXPECT_EQ(sides(1, 6), (Sides{1, 6}));
  EXPECT_EQ(sides({}, {}), Sides());
  EXPECT_EQ(sides(4, {}), Sides());
  EXPECT_EQ(sides(2, 2), Sides());
  EXPECT_EQ(sides(0, {}), Sides());
  EXPECT_EQ(sides(std::size_t{1} << 63, 2), Sides());
}

TEST(MapArray, SaysWhatIsWrongWithAnArray) {
  const auto message = [](const std::string& bytes) {
    const auto array = map_array_in_npy(bytes, "w.npy");
    return array ? std::string() : to_string(array.error());
  };
  EXPECT_NE(message(array_bytes<double>({1, 2}, {2})).find("1 dimensions"), std::string::npos);
  EXPECT_NE(message(array_bytes<double>({1, 2}, {2, 1, 1, 1})).find("4 dimensions"),
            std::string::npos);
  EXPECT_NE(message(array_bytes<double>({}, {2, 0, 3})).find("empty"), std::string::npos);
  EXPECT_NE(message(array_bytes<double>({1, 2}, {2, 2, 2})).find("truncated"), std::string::npos);
  EXPECT_NE(message(array_bytes<double>({1}, {std::size_t{1} << 40, std::size_t{1} << 40, 1}))
                .find("w.npy"),
            std::string::npos);
  EXPECT_NE(message(array_bytes<double>({1, NAN}, {2, 1})).find("row 2, column 1"),
            std::string::npos);
  EXPECT_NE(message(array_bytes<double>({1.7e9, 1.7e9 + 1}, {2, 1})).find("w.npy"),
            std::string::npos);
}

TEST(MapArray, RefusesWeightsThatDoNotFitTheParameters) {
  const MapArray array{{2, 3, 2}, kNumbered};
  const auto refused = [&](const auto& change, MapArray weights) {
    SomParameters parameters;
    change(parameters);
    const auto model = map_of_weights(parameters, std::move(weights), {}, "w.npy");
    return !model && model.error().kind == ErrorKind::kUsage;
  };
  EXPECT_TRUE(refused([](SomParameters& p) { p.rows = 3; }, array));
  EXPECT_TRUE(refused([](SomParameters& p) { p.columns = 2; }, array));
  EXPECT_TRUE(refused([](SomParameters& p) { p.similarity = Similarity::kDotProduct; }, array));
  EXPECT_FALSE(map_of_weights({}, array, {"x"}, "w.npy"));
  MapArray spoiled = array;
  spoiled.weights(4, 1) = NAN;
  EXPECT_TRUE(refused([](SomParameters&) {}, spoiled));
  const MapArray odd{{3, 2, 1}, Matrix<float>(6, 1, {1, 2, 3, 4, 5, 6})};
  EXPECT_TRUE(refused(
      [](SomParameters& p) {
        p.lattice = Lattice::kHexagonal;
        p.topology = Topology::kTorus;
      },
      odd));
  SomParameters dot;
  dot.similarity = Similarity::kDotProduct;
  EXPECT_TRUE(map_of_weights(dot, {{1, 2, 2}, Matrix<float>(2, 2, {0.6F, 0.8F, -1, 0})}, {}, "w"));
}

}  // namespace
}  // namespace somato
