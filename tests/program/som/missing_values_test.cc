#include <cmath>
#include <limits>

#include "program/support/program_test.h"
#include "somato/files/npy.h"
#include "somato/graph/som_model.h"

namespace somato {
namespace {

Words with_words(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// Rows with three missing values in two rows; oracles are files that were filled by hand.
class MissingValues : public ProgramTest {
 protected:
  static Words training(const Words& more, const std::string& output = "x.map") {
    return with_words({"som", "train", "--rows", "2", "--columns", "3", "--training", "batch",
                       "--epochs", "3", "-o", output},
                      more);
  }

  // Means of the known values: 3, 20, 5. For the third row, the nearest complete one is the first
  // (by b: 10 and 3), of the fourth the last (by a).
  void write_tables() const {
    write("holes.csv", "a,b,c\n1,10,2\n2,23,9\n,13,NA\n5,nan,4\n4,34,5\n");
    write("mean.csv", "a,b,c\n1,10,2\n2,23,9\n3,13,5\n5,20,4\n4,34,5\n");
    write("nearest.csv", "a,b,c\n1,10,2\n2,23,9\n1,13,2\n5,34,4\n4,34,5\n");
    const float nan = std::numeric_limits<float>::quiet_NaN();
    write("holes.npy",
          encode_npy(Matrix<float>(5, 3, {1, 10, 2, 2, 23, 9, nan, 13, nan, 5, nan, 4, 4, 34, 5})));
  }

  Matrix<float> weights(const std::string& model) const {
    const Som som = load_som_model(path(model)).value().som;
    Matrix<float> matrix(som.neurons(), som.input_size());
    for (std::size_t n = 0; n < som.neurons(); ++n) {
      for (std::size_t d = 0; d < som.input_size(); ++d) matrix(n, d) = som.weight(n, d);
    }
    return matrix;
  }
};

const Words kWhole{};
const Words kPieces{"--memory", "8B"};

TEST_F(MissingValues, AreRefusedWithTheirPlaceByDefault) {
  write_tables();
  output_of(training({"mean.csv"}));
  for (const Words& memory : {kWhole, kPieces}) {
    for (const Words& command :
         {training({}), Words{"som", "map", "x.map"}, Words{"som", "quality", "x.map"},
          Words{"som", "plot", "x.map", "-o", "p.svg"}}) {
      expect_refused(1, with_words(with_words(command, {"holes.csv"}), memory),
                     {"holes.csv:4:1: the field is empty", "--missing mean or nearest"});
      expect_refused(1, with_words(with_words(command, {"holes.npy"}), memory),
                     {"holes.npy: ", "row 3, column 1", "--missing mean or nearest"});
    }
  }
}

// Column a has 1, 2, 5 and 4: squares of 46 around the weight 0, and of 10 around the mean.
TEST_F(MissingValues, AreNoPartOfWhatAMapExplains) {
  write_tables();
  write("zero.csv", "a,b,c\n1,10,2\n-1,-10,-2\n");
  output_of({"som", "train", "zero.csv", "--rows", "1", "--columns", "1", "--training", "batch",
             "--epochs", "1", "--missing", "mean", "-o", "zero.map"});
  for (const char* fill : {"mean", "nearest", "leave_out"}) {
    const std::string table =
        output_of({"som", "features", "zero.map", "holes.csv", "--missing", fill, "--quiet"});
    EXPECT_NE(table.find("a,-3.6,"), std::string::npos) << fill << "\n" << table;
  }
}

TEST_F(MissingValues, AreFilledWithTheMeanOfTheRowsThatKnowThem) {
  write_tables();
  for (const Words& more : {Words{}, {"--standardize"}}) {
    const std::string expected = output_of(training(with_words({"mean.csv"}, more), "mean.map"));
    for (const Words& memory : {kWhole, kPieces}) {
      for (const char* file : {"holes.csv", "holes.npy"}) {
        const Words words = with_words(with_words({file, "--missing", "mean"}, more), memory);
        const std::string said = output_of(training(words));
        EXPECT_NE(said.find("filled 3 values in 2 rows (mean)\n"), std::string::npos) << said;
        EXPECT_EQ(said.substr(said.find("quantization_error")),
                  expected.substr(expected.find("quantization_error")));
        EXPECT_EQ(weights("x.map"), weights("mean.map"));
        EXPECT_EQ(load_som_model(path("x.map"))->means, (std::vector<double>{3, 20, 5}));
      }
    }
  }
}

TEST_F(MissingValues, AreFilledFromTheNearestCompleteRow) {
  write_tables();
  output_of(training({"nearest.csv"}, "nearest.map"));
  const std::string said = output_of(training({"holes.csv", "--missing", "nearest"}));
  EXPECT_NE(said.find("filled 3 values in 2 rows (nearest)\n"), std::string::npos) << said;
  EXPECT_TRUE(read("x.map") == read("nearest.map"));
  expect_refused(1, with_words(training({"holes.csv", "--missing", "nearest"}), kPieces),
                 {"holes.csv: ", "needs all rows in memory", "--missing mean", "--memory"});
}

// By a, in metres, the last row is nearer to the first; in standard deviations, to the second.
TEST_F(MissingValues, AreNearestInStandardDeviationsWhereColumnsAreStandardized) {
  write("holes.csv", "a,b,c\n0,0,1\n9,0.5,2\n4,0.45,\n");
  write("plain.csv", "a,b,c\n0,0,1\n9,0.5,2\n4,0.45,1\n");
  write("scaled.csv", "a,b,c\n0,0,1\n9,0.5,2\n4,0.45,2\n");
  output_of(training({"plain.csv"}, "plain.map"));
  output_of(training({"holes.csv", "--missing", "nearest"}));
  EXPECT_TRUE(read("x.map") == read("plain.map"));
  output_of(training({"scaled.csv", "--standardize"}, "scaled.map"));
  output_of(training({"holes.csv", "--missing", "nearest", "--standardize"}));
  EXPECT_TRUE(read("x.map") == read("scaled.map"));
}

TEST_F(MissingValues, OfAWholeRowOrColumnAreRefused) {
  write("row.csv", "a,b\n1,2\n,\n3,4\n");
  write("column.csv", "a,b\n1,\n2,NA\n3,?\n");
  write("incomplete.csv", "a,b\n1,\n,2\n3,\n,5\n");
  for (const Words& memory : {kWhole, kPieces}) {
    for (const char* way : {"mean", "nearest"}) {
      expect_refused(1, with_words(training({"row.csv", "--missing", way}), memory),
                     {"row.csv: row 2 has no known value"});
      expect_refused(1, with_words(training({"column.csv", "--missing", way}), memory),
                     {"column.csv: column 2 ('b') has no known value", "--skip"});
    }
  }
  expect_refused(1, training({"incomplete.csv", "--missing", "nearest"}),
                 {"incomplete.csv: no row is complete", "--missing mean"});
  output_of(training({"incomplete.csv", "--missing", "mean"}));
}

// Lines of `som map` for rows as the map has them filled in.
TEST_F(MissingValues, OfNewRowsAreFilledWithTheMeansOfTheTraining) {
  write_tables();
  write("new.csv", "a,b,c\n1,,2\n,,9\n");
  write("filled.csv", "a,b,c\n1,20,2\n3,20,9\n");
  for (const Words& more :
       {Words{"holes.csv", "--missing", "mean"}, {"mean.csv", "--standardize"}}) {
    output_of(training(more));
    const std::string expected = output_of({"som", "map", "x.map", "filled.csv"});
    for (const Words& memory : {kWhole, kPieces}) {
      const ProgramRun done =
          run(with_words({"som", "map", "x.map", "new.csv", "--missing", "mean"}, memory));
      EXPECT_EQ(done.out, expected);
      EXPECT_EQ(done.err, "somato: new.csv: filled 3 values in 2 rows (mean)\n");
    }
  }
  output_of(training({"mean.csv"}));
  expect_refused(2, {"som", "map", "x.map", "new.csv", "--missing", "mean"},
                 {"x.map: the map does not contain the means", "--missing nearest"});
}

// The winner is the neuron that is nearest by what is known, and the distance is what is known.
TEST_F(MissingValues, OfNewRowsDoNotCountWhereTheWinnerIsTheNearest) {
  write_tables();
  write("new.csv", "a,b,c\n1,,2\n,,9\n2,24,\n");
  output_of(training({"mean.csv"}));
  const Matrix<float> neurons = weights("x.map");
  const double nan = std::nan("");
  const double rows[3][3] = {{1, nan, 2}, {nan, nan, 9}, {2, 24, nan}};
  std::string expected = "sample,winner,row,column,distance\n";
  for (int i = 0; i < 3; ++i) {
    double least = std::numeric_limits<double>::infinity();
    std::size_t winner = 0;
    for (std::size_t n = 0; n < neurons.rows(); ++n) {
      double sum = 0.0;
      for (std::size_t d = 0; d < 3; ++d) {
        if (!std::isnan(rows[i][d])) sum += std::pow(rows[i][d] - double{neurons(n, d)}, 2);
      }
      if (sum < least) winner = n;
      least = std::min(least, sum);
    }
    char line[100];
    std::snprintf(line, sizeof line, "%d,%zu,%zu,%zu,%.9g\n", i + 1, winner, winner / 3, winner % 3,
                  std::sqrt(least));
    expected += line;
  }
  for (const Words& memory : {kWhole, kPieces}) {
    const ProgramRun done =
        run(with_words({"som", "map", "x.map", "new.csv", "--missing", "nearest"}, memory));
    EXPECT_EQ(done.out, expected);
    EXPECT_EQ(done.err, "somato: new.csv: filled 4 values in 3 rows (nearest)\n");
    const ProgramRun quality =
        run(with_words({"som", "quality", "x.map", "new.csv", "--missing", "nearest"}, memory));
    EXPECT_EQ(quality.exit_code, 0) << quality.err;
    EXPECT_NE(quality.err.find("filled 4 values"), std::string::npos);
  }
  write("row.csv", "a,b,c\n1,2,3\n,,\n");
  expect_refused(1, {"som", "map", "x.map", "row.csv", "--missing", "nearest"},
                 {"row.csv: row 2 has no known value"});
}

TEST_F(MissingValues, NeedDistancesToBeFilledFromTheWinner) {
  write_tables();
  for (const Words& more : {Words{"--similarity", "dot_product"}, {"--normalize-input", "true"}}) {
    output_of(training(with_words({"mean.csv", "--missing", "mean"}, more)));
    expect_refused(2, {"som", "map", "x.map", "holes.csv", "--missing", "nearest"},
                   {"x.map: ", "missing values leave unknown", "--missing mean"});
    EXPECT_EQ(run({"som", "map", "x.map", "holes.csv", "--missing", "mean"}).exit_code, 0);
  }
}

TEST_F(MissingValues, ThatAreNotThereChangeNothing) {
  write_tables();
  output_of(training({"mean.csv"}));
  const std::string map = read("x.map");
  const std::string said = output_of(training({"mean.csv", "--missing", "nearest"}));
  EXPECT_TRUE(read("x.map") == map);
  EXPECT_EQ(said.find("filled"), std::string::npos);
  EXPECT_EQ(output_of({"som", "map", "x.map", "mean.csv", "--missing", "nearest"}),
            output_of({"som", "map", "x.map", "mean.csv"}));
}

// With a single neuron that all samples win, each weight is the mean of what is known of its
// column: here in standard deviations of the known values, 0.
TEST_F(MissingValues, AreLeftOutOfTheMeansOfWeights) {
  write_tables();
  const Words one{"som",        "train", "--rows",    "1",         "--columns", "1",
                  "--training", "batch", "--missing", "leave_out", "-o",        "x.map"};
  for (const char* similarity : {"euclidean", "manhattan", "chebyshev"}) {
    const std::string said = output_of(with_words(one, {"--similarity", similarity, "holes.csv"}));
    EXPECT_NE(said.find("missing 3 values in 2 rows (leave_out)\n"), std::string::npos) << said;
    EXPECT_EQ(weights("x.map"), Matrix<float>(1, 3, {3, 20, 5}));
    output_of(with_words(one, {"--similarity", similarity, "--standardize", "holes.npy"}));
    const Matrix<float> standardized = weights("x.map");
    for (const float weight : standardized.values()) EXPECT_NEAR(weight, 0.0, 1e-6);
    EXPECT_EQ(run({"som", "map", "x.map", "holes.csv", "--missing", "leave_out"}).exit_code, 0);
  }
  const auto model = load_som_model(path("x.map")).value();
  EXPECT_NEAR(model.standardization->deviations[0], std::sqrt(2.5), 1e-12);
  EXPECT_NEAR(model.standardization->means[1], 20.0, 1e-12);
}

TEST_F(MissingValues, AreNotLeftOutByDirectionsCheckpointsOrParts) {
  write_tables();
  const Words leaving = training({"holes.csv", "--missing", "leave_out"});
  expect_refused(2, with_words(leaving, {"--similarity", "cosine"}), {"missing values"});
  expect_refused(2, with_words(leaving, {"--checkpoint", "c"}), {"--checkpoint"});
  expect_refused(1, with_words(leaving, kPieces), {"--missing leave_out needs all rows in memory"});
}

}  // namespace
}  // namespace somato
