#include "systems/exchange/cod_file.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

// Three columns and two rows, as SOM Toolbox writes them.
const std::string kCodebook =
    "2 hexa 3 2 bubble\n"
    "#n length mass\n"
    "# a comment\n"
    "1 2 apple\n"
    "3 -4.5e-1\r\n"
    "5\t6 pear fig\n"
    "\n"
    "7 8\n"
    " 9 10  apple \n"
    "11 12";

using Texts = std::vector<std::string>;

TEST(CodFile, ReadsUnitsRowByRowWithNamesAndLabels) {
  const auto map = map_in_cod(kCodebook, "map.cod");
  ASSERT_TRUE(map) << to_string(map.error());
  const SomParameters& parameters = map->model.som.parameters();
  EXPECT_EQ(parameters.rows, 2);
  EXPECT_EQ(parameters.columns, 3);
  EXPECT_EQ(parameters.lattice, Lattice::kHexagonal);
  EXPECT_EQ(parameters.neighbourhood, NeighbourhoodShape::kBubble);
  EXPECT_EQ(map->model.som.weights().to_matrix(),
            Matrix<float>(6, 2, {1, 2, 3, -0.45F, 5, 6, 7, 8, 9, 10, 11, 12}));
  EXPECT_EQ(map->model.features, (Texts{"length", "mass"}));
  EXPECT_EQ(map->model.classes, (Texts{"apple", "pear"}));
  EXPECT_EQ(map->model.labels, NeuronLabels({0, std::nullopt, 1, std::nullopt, 0, std::nullopt}));
  ASSERT_EQ(map->notes.size(), 1);
  EXPECT_NE(map->notes[0].find("several labels: 1"), std::string::npos) << map->notes[0];
}

TEST(CodFile, NamesWhatItLeavesOut) {
  const auto map = map_in_cod("# first\n1 rect 1 2 spline\n#n a b\n1\n2\n", "map.cod");
  ASSERT_TRUE(map) << to_string(map.error());
  EXPECT_EQ(map->model.som.parameters().lattice, Lattice::kRectangular);
  EXPECT_TRUE(map->model.features.empty());
  EXPECT_TRUE(map->model.classes.empty());
  ASSERT_EQ(map->notes.size(), 2);
  EXPECT_NE(map->notes[0].find("'spline'"), std::string::npos) << map->notes[0];
  EXPECT_NE(map->notes[1].find("2 names"), std::string::npos) << map->notes[1];
}

TEST(CodFile, TakesWhatTheFileDoesNotContain) {
  SomParameters torus;
  torus.topology = Topology::kTorus;
  const auto map = map_in_cod("1 hexa 2 2 gaussian\n1\n2\n3\n4\n", "map.cod", torus);
  ASSERT_TRUE(map) << to_string(map.error());
  EXPECT_EQ(map->model.som.parameters().topology, Topology::kTorus);
  EXPECT_FALSE(map_in_cod("1 hexa 1 3 gaussian\n1\n2\n3\n", "map.cod", torus));
}

TEST(CodFile, NamesTheLineOfWhatIsWrong) {
  struct Case {
    std::string text;
    std::string message;
  };
  for (const Case& one : {
           Case{"", "map.cod:0: the file contains no map"},
           Case{"1 2 3\n", "map.cod:1: the first line"},
           Case{"1 rect 1 2\n1\n2\n", "map.cod:1: the first line has 4 fields"},
           Case{"1 rect 0 2 gaussian\n", "map.cod:1: '0' x '2'"},
           Case{"1 rect -1 2 gaussian\n", "'-1'"},
           Case{"1 rect 1.5 2 gaussian\n", "'1.5'"},
           Case{"1 rect 99999999999999999999 2 gaussian\n", "'99999999999999999999'"},
           Case{"1 rect 4294967296 4294967296 gaussian\n1\n", "neurons"},
           Case{"1000000 rect 1000 1000 gaussian\n1\n", "cannot contain"},
           Case{"2 rect 1 2 gaussian\n1 2\n3\n", "map.cod:3: the line has 1 numbers"},
           Case{"1 rect 1 2 gaussian\n1\nnan\n", "map.cod:3: 'nan'"},
           Case{"1 rect 1 2 gaussian\n1\ninf\n", "'inf'"},
           Case{"1 rect 1 2 gaussian\n1\nx\n", "'x'"},
           Case{"1 rect 1 2 gaussian\n1\n1,5\n", "'1,5'"},
           Case{"1 rect 1 2 gaussian\n1\n1e99\n", "'1e99'"},
           Case{"1 rect 1 2 gaussian\n1\n", "ends after 1 of 2 units"},
           Case{"1 rect 1 2 gaussian\n1\n2\n3\n", "map.cod:4: the map has only 2 units"},
           Case{std::string("1 rect 1 1 gaussian\n1 \0\n", 23), "map.cod"},
       }) {
    const auto map = map_in_cod(one.text, "map.cod");
    ASSERT_FALSE(map) << one.text;
    EXPECT_EQ(map.error().kind, ErrorKind::kData) << one.text;
    EXPECT_NE(to_string(map.error()).find(one.message), std::string::npos)
        << to_string(map.error());
  }
}

TEST(CodFile, KnowsItsFirstLine) {
  EXPECT_TRUE(is_cod("# c\n\n 4 rect 2 2 gaussian\n"));
  EXPECT_FALSE(is_cod("4 round 2 2 gaussian\n"));
  EXPECT_FALSE(is_cod("4\n"));
  EXPECT_FALSE(is_cod("0 rect\n"));
  EXPECT_FALSE(is_cod(""));
}

}  // namespace
}  // namespace somato
