#include <cmath>
#include <string>
#include <vector>

#include "program/support/program_test.h"
#include "somato/graph/som_model.h"

namespace somato {
namespace {

// Four kinds of rows; `b` is 10 a, and the one-hot columns name the sign of a.
class Layers : public ProgramTest {
 protected:
  void SetUp() override {
    write("rows.csv", "a,b,low,high,note\n-2,-20,1,0,x\n-1,-10,1,0,x\n1,10,0,1,x\n2,20,0,1,x\n");
  }

  static Words training(const std::string& layers, const Words& more = {}) {
    Words words{"som",      "train",      "rows.csv",  "--skip",   "note",
                "--rows",   "1",          "--columns", "4",        "--initial-weights",
                "samples",  "--training", "batch",     "--epochs", "0",
                "--layers", layers,       "-o",        "x.map"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
};

const std::string kThree = "first=a; second=b:manhattan:2 ;kind=low,high:cosine:1:0.5";

TEST_F(Layers, HaveTheColumnsDistancesWeightsAndScalesThatAreGiven) {
  output_of(training(kThree));
  const auto layers = load_som_model(path("x.map"))->som.parameters().layers;
  ASSERT_EQ(layers.size(), 3U);
  // The mean of |a - a'|: 1, 3, 4, 2, 3 and 1.
  EXPECT_EQ(layers[0], (Layer{"first", 0, 1, Similarity::kEuclidean, 1.0, 14.0 / 6.0}));
  EXPECT_EQ(layers[1], (Layer{"second", 1, 1, Similarity::kManhattan, 2.0, 140.0 / 6.0}));
  EXPECT_EQ(layers[2], (Layer{"kind", 2, 2, Similarity::kCosine, 1.0, 0.5}));
}

// The neurons start at the four rows, each of which is its own winner by any layer but the classes.
TEST_F(Layers, ArePredictedFromTablesWithoutTheirColumns) {
  write("others.csv", "low,high,b\n1,0,-12\n0,1,19\n");
  write("values.csv", "b,a\n-12,-1\n19,2\n");
  for (const Words& more : {Words{}, {"--standardize"}}) {
    output_of(training(kThree, more));
    EXPECT_EQ(output_of({"som", "predict", "x.map", "others.csv", "--layer", "first"}),
              "sample,a,greatest\n1,-1,a\n2,2,a\n");
    EXPECT_EQ(output_of({"som", "predict", "x.map", "values.csv", "--layer", "kind"}),
              "sample,low,high,greatest\n1,1,0,low\n2,0,1,high\n");
    EXPECT_EQ(run({"som", "map", "x.map", "rows.csv"}).exit_code, 0);
  }
  output_of({"som", "predict", "x.map", "others.csv", "--layer", "first", "-o", "out.csv"});
  EXPECT_EQ(read("out.csv"), "sample,a,greatest\n1,-1,a\n2,2,a\n");
}

TEST_F(Layers, AreTheSameWithACheckpoint) {
  Words words = training(kThree);
  *std::find(words.begin(), words.end(), "0") = "2";
  output_of(words);
  const std::string expected = read("x.map");
  words.insert(words.end(), {"--checkpoint", "c"});
  output_of(words);
  EXPECT_TRUE(read("x.map") == expected);
}

TEST_F(Layers, AreRefusedWithTheReason) {
  const auto refused = [&](const std::string& layers, const std::string& reason) {
    expect_refused(2, training(layers), {"--layers", reason});
  };
  refused("first=a;second=b", "column low is in no layer");
  refused("first=a,b;second=b,low,high", "in another layer, too");
  refused("first=a,low;second=b,high", "are not neighbours");
  refused("first=a,b,low,hight", "hight");
  refused("first=a,b,low,high,note", "note");
  refused("first=a,b,low,high:dot_product", "'dot_product' is not");
  refused("first=a,b,low,high:chess", "chess");
  refused("first=a,b,low,high:euclidean:much", "'much' in layer 'first' is not a number");
  refused("first=a,b,low,high:euclidean:0", "above 0");
  refused("a,b,low,high", "is not a layer");
  refused(";", "there is no layer");
  output_of(training(kThree));
  expect_refused(2, {"som", "predict", "x.map", "rows.csv", "--layer", "third"},
                 {"x.map", "no layer 'third'", "first, second, kind"});
  expect_refused(2, training(kThree, {"--similarity", "manhattan"}), {"similarity"});
}

}  // namespace
}  // namespace somato
