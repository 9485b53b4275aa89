#include <limits>

#include "base/support/sanitized.h"
#include "program/support/program_test.h"
#include "somato/core/matrix.h"
#include "somato/files/npy.h"

namespace somato {
namespace {

// Memory for one row or two at a time: any file is large then.
const std::string kLittle = "--memory=200B";

class LargeFiles : public ProgramTest {
 protected:
  static Words with(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  static Matrix<float> numbers() {
    Matrix<float> matrix(40, 3);
    float value = 0.0F;
    for (float& number : matrix.values()) {
      value = value * 3.7F + 0.4F;
      value -= static_cast<float>(static_cast<int>(value));
      number = value;
    }
    return matrix;
  }

  // The same forty rows as NPY, CSV, and CSV with names and labels.
  void write_numbers() const {
    const Matrix<float> matrix = numbers();
    write("rows.npy", encode_npy(matrix));
    std::string csv;
    std::string labels;
    std::string labelled = "a,kind,b,c\n";
    for (std::size_t i = 0; i < matrix.rows(); ++i) {
      const std::string row[] = {std::to_string(matrix(i, 0)), std::to_string(matrix(i, 1)),
                                 std::to_string(matrix(i, 2))};
      const std::string kind = i % 3 == 0 ? "cup" : "ball";
      csv += row[0] + "," + row[1] + "," + row[2] + "\n";
      labelled += row[0] + "," + kind + "," + row[1] + "," + row[2] + "\n";
      labels += kind + "\n";
    }
    write("rows.csv", csv);
    write("labelled.csv", labelled);
    write("labels", labels);
  }

  static Words training(const Words& more, const std::string& epochs = "4") {
    return with({"som", "train", "--training", "batch", "--rows", "3", "--columns", "4", "--epochs",
                 epochs},
                more);
  }
};

const std::vector<Words> kWays{{"rows.npy"},
                               {"rows.npy", "--standardize"},
                               {"rows.npy", "--similarity", "dot_product"},
                               {"rows.npy", "--initial-weights", "samples", "--labels", "labels"},
                               {"rows.csv", "--normalize-input", "true"},
                               {"rows.csv", "--initial-weights", "uniform"},
                               {"labelled.csv", "--label-column", "kind", "--standardize"}};

class LargeFilesThread : public LargeFiles {};

TEST_F(LargeFilesThread, GiveTheSameMapAsInMemory) {
  write_numbers();
  for (const Words& way : kWays) {
    SCOPED_TRACE(::testing::PrintToString(way));
    const std::string figures = output_of(with(training(way), {"-o", "x.map"}));
    const std::string expected = read("x.map");
    for (const char* threads : {"1", "2", "4"}) {
      EXPECT_EQ(output_of(with(training(way), {"-o", "x.map", kLittle, "--threads", threads})),
                figures);
      EXPECT_TRUE(read("x.map") == expected) << threads;
    }
  }
}

TEST_F(LargeFiles, AreMeasuredMappedAndDrawnAsInMemory) {
  write_numbers();
  for (const Words& way : kWays) {
    SCOPED_TRACE(::testing::PrintToString(way));
    output_of(with(training(way), {"-o", "x.map"}));
    const bool column = way[0] == "labelled.csv";
    const Words data = column ? Words{way[0], "--label-column", "kind"} : Words{way[0]};
    const Words labels = column ? Words{} : Words{"--labels", "labels"};
    const Words quality = with(with({"som", "quality", "x.map"}, data), labels);
    EXPECT_EQ(output_of(with(quality, {kLittle})), output_of(quality));
    const Words map = with({"som", "map", "x.map"}, data);
    const std::string csv = output_of(map);
    EXPECT_EQ(output_of(with(map, {kLittle})), csv);
    output_of(with(map, {"-o", "y", "--activity", "z"}));
    const std::string activity = read("z");
    output_of(with(map, {"-o", "y", "--activity", "z", kLittle}));
    EXPECT_EQ(read("y"), csv);
    EXPECT_TRUE(read("z") == activity);
    const Words plot = with(with({"som", "plot", "x.map", "-o", "p"}, data), labels);
    output_of(plot);
    const std::string picture = read("p");
    output_of(with(plot, {kLittle}));
    EXPECT_TRUE(read("p") == picture);
  }
}

TEST_F(LargeFiles, AreNotForOnlineTraining) {
  write_numbers();
  expect_refused(1, {"som", "train", "rows.npy", "-o", "x", kLittle},
                 {"rows.npy: online training", "40 x 3", "--training batch", "--memory"});
}

TEST_F(LargeFiles, AFaultInTheLastRowIsReportedBeforeAnythingIsWritten) {
  write_numbers();
  output_of(with(training({"rows.npy"}), {"-o", "good.map"}));
  Matrix<float> matrix = numbers();
  matrix(39, 1) = std::numeric_limits<float>::quiet_NaN();
  write("bad.npy", encode_npy(matrix));
  const std::string good = encode_npy(numbers());
  write("cut.npy", good.substr(0, good.size() - 1));
  write("bad.csv", read("rows.csv") + "1,inf,2\n");
  write("short.csv", read("rows.csv") + "1,2\n");
  write("none.csv", "\n# nothing but a remark that is longer than the memory\n\n\n\n\n\n\n\n\n");
  const std::vector<std::pair<std::string, Words>> files{
      {"bad.npy", {"bad.npy: ", "row 40, column 2", "not a finite"}},
      {"cut.npy", {"cut.npy: ", "truncated"}},
      {"bad.csv", {"bad.csv:41:3: ", "'inf'"}},
      {"short.csv", {"short.csv:41: ", "expected 3 fields, found 2"}},
      {"none.csv", {"none.csv: ", "no rows of numbers"}}};
  for (const auto& [file, says] : files) {
    expect_refused(1,
                   {{with(training({file}), {"-o", "x", kLittle}), says},
                    {{"som", "quality", "good.map", file, kLittle}, says},
                    {{"som", "map", "good.map", file, kLittle}, says},
                    {{"som", "map", "good.map", file, "-o", "x", "--activity", "y", kLittle}, says},
                    {{"som", "plot", "good.map", file, "-o", "x", kLittle}, says}});
  }
}

TEST_F(LargeFiles, AreRefusedForTheSameReasonsAsInMemory) {
  write_numbers();
  write("few", "a\nb\n");
  write("one.csv", "1,2,3" + std::string(200, ' ') + "\n");
  write("constant.csv", "a,b\n1,2\n1,3\n1,4\n1,5\n1,6\n1,7\n1,8\n1,9\n1,10\n1,11\n1,12\n");
  const Words end{"-o", "x", kLittle};
  expect_refused(
      1, {{with(training({"rows.npy", "--labels", "few"}), end), {"few", "2 labels for 40 rows"}},
          {with(training({"one.csv"}), end), {"one.csv", "only one sample"}},
          {with(training({"constant.csv"}), end), {"column 1 ('a')", "same value"}}});
  expect_refused(
      2, {{with(training({"rows.npy", "--label-column", "1"}), end), {"no label column"}},
          {with(training({"rows.csv", "--label-column", "x"}), end), {"no column 'x'"}},
          {with(training({"labelled.csv", "--label-column", "kind", "--labels", "few"}), end),
           {"given twice"}}});
}

TEST_F(LargeFiles, MemoryIsANumberWithAUnit) {
  write_numbers();
  for (const char* wrong : {"much", "-1MiB", "0", "1.5X", "MiB", "1 2", "nan", "inf", "1e99GiB"}) {
    expect_refused(2, with(training({"rows.npy"}), {"-o", "x", std::string("--memory=") + wrong}),
                   {"--memory", "500MiB"});
  }
  for (const char* right : {"0.5GiB", "100 MB", "200", "3kB", "1GB", "9KiB"}) {
    output_of(with(training({"rows.npy"}), {"-o", "x", std::string("--memory=") + right}));
  }
}

// 48 MiB of numbers, which would take twice to three times as much, by default.
TEST_F(LargeFiles, AreTrainedOnInLessMemoryThanTheyTake) {
#ifdef SOMATO_TESTS_SANITIZED
  GTEST_SKIP() << "sanitizers need all the address space";
#endif
  constexpr std::size_t kRows = 393216;
  std::string bytes = npy_start(kRows, 32);
  const std::string values = npy_numbers(numbers().values().first(96));
  bytes.reserve(bytes.size() + kRows * 128);
  for (std::size_t i = 0; i < kRows / 3; ++i) bytes += values;
  write("rows.npy", bytes);
  ProgramWorld world;
  world.memory = std::size_t{160} << 20;
  const ProgramRun done =
      run(with(training({"rows.npy"}, "1"), {"-o", "x", "--threads", "2"}), world);
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(done.err, "");
  EXPECT_NE(done.out.find("trained on 393216 samples of 32 features"), std::string::npos);
}

TEST_F(LargeFiles, TellAPersonWhatIsDoneAndStopAtCtrlC) {
  write_numbers();
  ProgramWorld world;
  world.terminal = true;
  const Words words = with(training({"rows.npy"}), {"-o", "x", kLittle});
  const ProgramRun done = run(words, world);
  EXPECT_EQ(done.exit_code, 0);
  for (const char* said : {"reading: 100 %", "training:   1 %, ", " left", "training: 100 %, took",
                           "measuring: 100 %, took"}) {
    EXPECT_NE(done.err.find(said), std::string::npos) << said << " in " << done.err;
  }
  // So long that the signal comes before the end.
  constexpr std::size_t kLong = testing::fewer_if_sanitized(8) == 8 ? 8000000 : 2000000;
  std::string csv = read("rows.csv");
  while (csv.size() < kLong) csv += csv;
  write("long.csv", csv);
  for (const char* moment : {"reading: ", "training: ", "measuring: "}) {
    world.interrupt_at = moment;
    const std::string epochs = moment == std::string("training: ") ? "100000" : "1";
    const auto before = contents();
    const ProgramRun stopped =
        run(with(training({"long.csv"}, epochs), {"-o", "x", "--memory", "4MB"}), world);
    EXPECT_EQ(stopped.exit_code, 130) << moment << stopped.err;
    EXPECT_EQ(stopped.out, "");
    EXPECT_NE(stopped.err.find("was stopped before its end"), std::string::npos) << stopped.err;
    EXPECT_TRUE(contents() == before);
  }
}

}  // namespace
}  // namespace somato
