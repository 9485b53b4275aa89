#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "program/support/program_test.h"
#include "somato/files/npy.h"
#include "somato/graph/som_model.h"

namespace somato {
namespace {

using Rows = std::vector<std::vector<double>>;

// Three groups of points in three dimensions, some 10 and some 0.1 wide, by plain arithmetic.
Rows points() {
  Rows rows;
  for (int i = 0; i < 30; ++i) {
    const int group = i % 3;
    rows.push_back({group * 10.0 + (i * 7 % 11) * 0.5, (i * 5 % 13) * 0.01 + group * 0.1,
                    group == 1 ? 4.0 + (i % 4) * 0.25 : (i % 7) * 0.125});
  }
  return rows;
}

const char* group_of(std::size_t row) {
  const char* const names[]{"ball", "the \"cube\", large", "rod"};
  return names[row % 3];
}

std::string text(const Rows& rows, const std::string& separator) {
  std::ostringstream out;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) out << (i > 0 ? separator : "") << row[i];
    out << "\n";
  }
  return out.str();
}

std::vector<std::string> lines(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> all;
  for (std::string line; std::getline(in, line);) all.push_back(line);
  return all;
}

// The number after `name` in lines such as "samples 30".
double measure(const std::string& output, const std::string& name) {
  for (const std::string& line : lines(output)) {
    if (line.starts_with(name + " ")) return std::stod(line.substr(name.size()));
  }
  ADD_FAILURE() << name << " is not in\n" << output;
  return std::nan("");
}

struct Found {
  std::size_t winner = 0;
  std::size_t second = 0;
  double distance = 0.0;
};

// A map as the definition has it: every neuron is looked at, in double precision.
class PlainMap {
 public:
  explicit PlainMap(const std::string& path) : model_(std::move(*load_som_model(path))) {}

  const SomModel& model() const { return model_; }

  std::vector<double> prepared(std::vector<double> row) const {
    for (std::size_t d = 0; model_.standardization && d < row.size(); ++d) {
      row[d] = (row[d] - model_.standardization->means[d]) / model_.standardization->deviations[d];
    }
    return row;
  }

  double distance(const std::vector<double>& row, std::size_t neuron) const {
    double sum = 0.0;
    for (std::size_t d = 0; d < row.size(); ++d) {
      const double difference = row[d] - double{model_.som.weights()(neuron, d)};
      sum += difference * difference;
    }
    return std::sqrt(sum);
  }

  Found find(const std::vector<double>& row) const {
    Found found{0, 0, 1e300};
    double second = 1e300;
    for (std::size_t neuron = 0; neuron < model_.som.neurons(); ++neuron) {
      const double its_distance = distance(row, neuron);
      if (its_distance < found.distance) {
        found.second = found.winner;
        second = found.distance;
        found.winner = neuron;
        found.distance = its_distance;
      } else if (its_distance < second) {
        found.second = neuron;
        second = its_distance;
      }
    }
    return found;
  }

  bool touch(std::size_t a, std::size_t b) const {
    const std::size_t columns = model_.som.grid().columns();
    const auto gap = [](std::size_t x, std::size_t y) { return x > y ? x - y : y - x; };
    return gap(a / columns, b / columns) + gap(a % columns, b % columns) == 1;
  }

 private:
  SomModel model_;
};

class Workflow : public ProgramTest {
 protected:
  static Words train_words(const std::string& data) {
    return {"som",       "train", data,           "-o",  "a.map",  "--rows", "5",
            "--columns", "6",     "--iterations", "600", "--seed", "7"};
  }

  // Batch training counts in epochs and refuses iterations.
  static Words with(Words words, const Words& more) {
    if (std::find(more.begin(), more.end(), "batch") != more.end()) {
      const auto iterations = std::find(words.begin(), words.end(), "--iterations");
      words.erase(iterations, iterations + 2);
    }
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  void expect_winners(const std::string& csv, const PlainMap& map) const {
    const auto found_lines = lines(csv);
    const Rows rows = points();
    ASSERT_EQ(found_lines.size(), rows.size() + 1);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Found found = map.find(map.prepared(rows[i]));
      std::istringstream line(found_lines[i + 1]);
      std::size_t sample = 0, winner = 0, row = 0, column = 0;
      double distance = 0.0;
      char comma = ',';
      line >> sample >> comma >> winner >> comma >> row >> comma >> column >> comma >> distance;
      EXPECT_EQ(sample, i + 1);
      EXPECT_EQ(winner, found.winner);
      EXPECT_EQ(row, found.winner / 6);
      EXPECT_EQ(column, found.winner % 6);
      EXPECT_NEAR(distance, found.distance, 1e-5 * (1.0 + found.distance));
    }
  }

  void expect_quality(const std::string& output, const PlainMap& map) const {
    const Rows rows = points();
    double distances = 0.0;
    double errors = 0.0;
    std::vector<bool> hit(30);
    for (const auto& row : rows) {
      const Found found = map.find(map.prepared(row));
      distances += found.distance;
      errors += map.touch(found.winner, found.second) ? 0.0 : 1.0;
      hit[found.winner] = true;
    }
    const auto count = static_cast<double>(rows.size());
    EXPECT_NEAR(measure(output, "quantization_error"), distances / count, 1e-4 * distances / count);
    EXPECT_NEAR(measure(output, "topographic_error"), errors / count, 1e-5);
    EXPECT_EQ(measure(output, "samples"), count);
    EXPECT_EQ(measure(output, "neurons"), 30);
    EXPECT_EQ(measure(output, "neurons_hit"), std::count(hit.begin(), hit.end(), true));
  }

  // Train, measure, map and draw the file `data`, with its labels left out.
  void expect_all_right(const std::string& data, const Words& train_flags,
                        const Words& data_flags) const {
    SCOPED_TRACE(data);
    output_of(with(with(train_words(data), train_flags), data_flags));
    const PlainMap map(path("a.map"));
    expect_quality(output_of(with({"som", "quality", "a.map", data}, data_flags)), map);
    expect_winners(output_of(with({"som", "map", "a.map", data}, data_flags)), map);
    EXPECT_EQ(output_of(with({"som", "plot", "a.map", data, "-o", "a.svg"}, data_flags)), "");
    EXPECT_TRUE(read("a.svg").starts_with("<svg") || read("a.svg").starts_with("<?xml"));
    EXPECT_TRUE(read("a.svg").ends_with("</svg>\n"));
  }
};

std::string labelled() {
  std::string csv = "height,group,width,depth\n";
  const auto rows = lines(text(points(), ","));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t comma = rows[i].find(',');
    const bool quote = i % 3 == 1;
    csv += rows[i].substr(0, comma) + "," + (quote ? "\"the \"\"cube\"\", large\"" : group_of(i)) +
           rows[i].substr(comma) + "\n";
  }
  return csv;
}

Matrix<float> as_matrix(const Rows& rows) {
  Matrix<float> matrix(rows.size(), rows[0].size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t d = 0; d < rows[i].size(); ++d) matrix(i, d) = static_cast<float>(rows[i][d]);
  }
  return matrix;
}

TEST_F(Workflow, EveryFormOfDataGivesWhatTheDefinitionsSay) {
  write("plain.csv", text(points(), ","));
  write("blanks.txt", text(points(), "  "));
  write("tabs.txt", text(points(), "\t"));
  write("labelled.csv", labelled());
  write("array.npy", encode_npy(as_matrix(points())));
  expect_all_right("plain.csv", {}, {});
  const std::string map = read("a.map");
  for (const char* same : {"blanks.txt", "tabs.txt", "array.npy"}) {
    expect_all_right(same, {}, {});
    EXPECT_EQ(read("a.map"), map) << same;
  }
  expect_all_right("labelled.csv", {}, {"--label-column", "group"});
  expect_all_right("labelled.csv", {}, {"--label-column", "2"});
  expect_all_right("plain.csv", {"--training", "batch"}, {});
}

TEST_F(Workflow, StandardizationIsKeptWithTheMapAndApplied) {
  write("plain.csv", text(points(), ","));
  expect_all_right("plain.csv", {"--standardize"}, {});
  const PlainMap map(path("a.map"));
  ASSERT_TRUE(map.model().standardization.has_value());
  const Rows rows = points();
  for (std::size_t d = 0; d < 3; ++d) {
    double mean = 0.0;
    double variance = 0.0;
    for (const auto& row : rows) mean += row[d] / 30.0;
    for (const auto& row : rows) variance += (row[d] - mean) * (row[d] - mean) / 30.0;
    EXPECT_NEAR(map.model().standardization->means[d], mean, 1e-5);
    EXPECT_NEAR(map.model().standardization->deviations[d], std::sqrt(variance), 1e-5);
  }
}

TEST_F(Workflow, LabelsComeBackFromTheMap) {
  write("labelled.csv", labelled());
  const Words labels{"--label-column", "group"};
  output_of(with(train_words("labelled.csv"), labels));
  const PlainMap map(path("a.map"));
  const auto csv = lines(output_of(with({"som", "map", "a.map", "labelled.csv"}, labels)));
  EXPECT_EQ(csv[0], "sample,winner,row,column,distance,label");
  const Rows rows = points();
  // The label of a neuron is the one most of its samples have; each of these samples has won one.
  std::map<std::size_t, std::map<std::string, int>> votes;
  for (std::size_t i = 0; i < rows.size(); ++i) ++votes[map.find(rows[i]).winner][group_of(i)];
  double right = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& its_votes = votes[map.find(rows[i]).winner];
    ASSERT_EQ(its_votes.size(), 1u) << "the groups lie apart";
    const std::string label = its_votes.begin()->first;
    right += label == group_of(i) ? 1.0 : 0.0;
    const std::string field = label[0] == 't' ? "\"the \"\"cube\"\", large\"" : label;
    EXPECT_TRUE(csv[i + 1].ends_with("," + field)) << csv[i + 1];
  }
  const std::string quality = output_of(with({"som", "quality", "a.map", "labelled.csv"}, labels));
  EXPECT_NEAR(measure(quality, "accuracy"), right / 30.0, 1e-5);
  EXPECT_NE(quality.find("individuals_apart true"), std::string::npos) << quality;
}

// Samples between the groups win neurons without a label, too; `som map` names each row by a search
// of its own.
TEST_F(Workflow, TheAccuracyOfOtherRowsIsThatOfTheirLabels) {
  write("labelled.csv", labelled());
  output_of(with(train_words("labelled.csv"), {"--label-column", "group"}));
  const PlainMap map(path("a.map"));
  std::set<std::size_t> named;
  for (const auto& row : points()) named.insert(map.find(row).winner);
  Rows between = points();
  std::string names;
  std::size_t unnamed = 0;
  for (std::size_t i = 0; i < between.size(); ++i) {
    between[i][0] += 4.5;
    between[i][2] += 1.0;
    names += std::string(group_of(i)) + "\n";
    unnamed += named.count(map.find(between[i]).winner) == 0 ? 1 : 0;
  }
  EXPECT_GT(unnamed, 0U);
  EXPECT_LT(unnamed, between.size());
  write("between.csv", text(between, ","));
  write("names", names);
  const auto mapped = lines(output_of({"som", "map", "a.map", "between.csv"}));
  double right = 0.0;
  for (std::size_t i = 0; i < between.size(); ++i) {
    const std::string label = group_of(i);
    const std::string field = label[0] == 't' ? "\"the \"\"cube\"\", large\"" : label;
    right += mapped[i + 1].ends_with("," + field) ? 1.0 : 0.0;
  }
  EXPECT_GT(right, 0.0);
  EXPECT_LT(right, 30.0);
  const std::string quality =
      output_of({"som", "quality", "a.map", "between.csv", "--labels", "names"});
  EXPECT_NEAR(measure(quality, "accuracy"), right / 30.0, 1e-5);
}

TEST_F(Workflow, WrongLabelsLowerTheAccuracyByTheirShare) {
  write("labelled.csv", labelled());
  output_of(with(train_words("labelled.csv"), {"--label-column", "group"}));
  write("plain.csv", text(points(), ","));
  std::string names;
  for (std::size_t i = 0; i < 30; ++i) names += std::string(i < 6 ? "other" : group_of(i)) + "\n";
  write("names", names);
  const std::string quality =
      output_of({"som", "quality", "a.map", "plain.csv", "--labels", "names"});
  EXPECT_NEAR(measure(quality, "accuracy"), 24.0 / 30.0, 1e-5);
  EXPECT_NE(quality.find("individuals_apart false"), std::string::npos) << quality;
}

TEST_F(Workflow, AFileHoldsWhatStandardOutputShows) {
  train();
  const std::string shown = output_of({"som", "map", "good.map", "data.csv"});
  EXPECT_EQ(output_of({"som", "map", "good.map", "data.csv", "-o", "out.csv"}), "");
  EXPECT_EQ(read("out.csv"), shown);
  EXPECT_EQ(lines(shown).size(), 13u);
  output_of({"som", "map", "good.map", "data.csv", "-o", "/dev/null"});
}

TEST_F(Workflow, ActivityIsARowASampleAndOneAtTheWinner) {
  write("plain.csv", text(points(), ","));
  output_of(train_words("plain.csv"));
  output_of({"som", "map", "a.map", "plain.csv", "-o", "x", "--activity", "activity.npy"});
  const auto activity = read_npy(path("activity.npy"));
  ASSERT_TRUE(activity.has_value());
  ASSERT_EQ(activity->rows(), 30u);
  ASSERT_EQ(activity->columns(), 30u);
  const PlainMap map(path("a.map"));
  for (std::size_t i = 0; i < 30; ++i) {
    const auto row = activity->row(i);
    const Found found = map.find(points()[i]);
    EXPECT_EQ(row[found.winner], 1.0f);
    // (s / s_winner)^10 with s = 1 / (1 + distance).
    for (std::size_t neuron = 0; neuron < 30; ++neuron) {
      const double ratio = (1.0 + found.distance) / (1.0 + map.distance(points()[i], neuron));
      EXPECT_NEAR(row[neuron], std::pow(ratio, 10.0), 1e-4);
    }
  }
}

TEST_F(Workflow, TheSameSeedIsTheSameFileForEveryNumberOfThreads) {
  write("plain.csv", text(points(), ","));
  for (const Words& flags : {Words{},
                             {"--arithmetic", "inner_products"},
                             {"--training", "batch"},
                             {"--standardize", "--lattice", "hexagonal"}}) {
    SCOPED_TRACE(::testing::PrintToString(flags));
    output_of(with(train_words("plain.csv"), flags));
    const std::string map = read("a.map");
    ASSERT_FALSE(map.empty());
    for (const char* threads : {"1", "2", "4", "7"}) {
      output_of(with(with(train_words("plain.csv"), flags), {"--threads", threads}));
      EXPECT_TRUE(read("a.map") == map) << threads << " threads";
    }
    Words other = with(train_words("plain.csv"), flags);
    *std::find(other.begin(), other.end(), "7") = "8";
    output_of(other);
    EXPECT_FALSE(read("a.map") == map) << "another seed";
  }
}

TEST_F(Workflow, ColumnsAreFoundByTheNamesThatTheMapLearned) {
  write("ab.csv", "a,b\n1,10\n2,20\n3,30\n");
  write("ba.csv", "b,a\n10,1\n20,2\n30,3\n");
  write("ac.csv", "a,c\n10,1\n20,2\n30,3\n");
  output_of(train_words("ab.csv"));
  for (const char* command : {"map", "quality"}) {
    EXPECT_EQ(output_of({"som", command, "a.map", "ba.csv"}),
              output_of({"som", command, "a.map", "ab.csv"}));
    expect_refused(1, {"som", command, "a.map", "ac.csv"},
                   {"ac.csv: ", "column 'b' is required, but is missing"});
  }
}

TEST_F(Workflow, AnOutputNeverWritesOverAnInput) {
  write("ab.csv", "a,b\n1,10\n2,20\n3,30\n");
  output_of(train_words("ab.csv"));
  const std::string model = read("a.map");
  const std::string data = read("ab.csv");
  for (const Words& words : {Words{"som", "train", "ab.csv", "-o", "./ab.csv"},
                             {"som", "plot", "a.map", "-o", "a.map"},
                             {"som", "map", "a.map", "ab.csv", "-o", "ab.csv"},
                             {"som", "map", "a.map", "ab.csv", "--activity", "new", "-o", "new"}}) {
    const ProgramRun done = run(words);
    EXPECT_EQ(done.exit_code, 2) << ::testing::PrintToString(words);
    EXPECT_NE(done.err.find("given twice"), std::string::npos) << done.err;
  }
  EXPECT_TRUE(read("a.map") == model);
  EXPECT_EQ(read("ab.csv"), data);
}

TEST_F(Workflow, AHeaderOfNumbersCanBeNamedAsOne) {
  write("years.csv", "2020,2021\n1,10\n2,20\n3,30\n");
  EXPECT_NE(output_of(train_words("years.csv")).find("4 samples"), std::string::npos);
  EXPECT_NE(output_of(with(train_words("years.csv"), {"--header", "yes"})).find("3 samples"),
            std::string::npos);
}

TEST_F(Workflow, PlotDrawsTheRequestedPanels) {
  train();
  const auto drawn = [&](const Words& flags) {
    output_of(with({"som", "plot", "good.map", "data.csv", "-o", "p.svg"}, flags));
    return read("p.svg");
  };
  const std::string all = drawn({});
  EXPECT_NE(all.find("U-matrix"), std::string::npos);
  EXPECT_NE(all.find("Component 3"), std::string::npos);
  const std::string one = drawn({"--panels", "u_matrix"});
  EXPECT_NE(one.find("U-matrix"), std::string::npos);
  EXPECT_EQ(one.find("Component"), std::string::npos);
  const std::string two = drawn({"--panels", "components", "--components", "2"});
  EXPECT_NE(two.find("Component 2"), std::string::npos);
  EXPECT_EQ(two.find("Component 3"), std::string::npos);
  EXPECT_EQ(two.find("U-matrix"), std::string::npos);
}

}  // namespace
}  // namespace somato
