#include <limits>
#include "support/sanitized.h"

#include "program/program_test.h"
#include "somato/core/matrix.h"
#include "somato/files/npy.h"
#include "support/sanitized.h"

#include "support/sanitized.h"
namespace somato {
#include "support/sanitized.h"
namespace {
#include "support/sanitized.h"

#include "support/sanitized.h"
// Memory for one row or two at a time: any file is large then.
#include "support/sanitized.h"
const std::string kLittle = "--memory=200B";
#include "support/sanitized.h"

#include "support/sanitized.h"
class LargeFiles : public ProgramTest {
#include "support/sanitized.h"
 protected:
#include "support/sanitized.h"
  static Words with(Words words, const Words& more) {
#include "support/sanitized.h"
    words.insert(words.end(), more.begin(), more.end());
#include "support/sanitized.h"
    return words;
#include "support/sanitized.h"
  }
#include "support/sanitized.h"

#include "support/sanitized.h"
  static Matrix<float> numbers() {
#include "support/sanitized.h"
    Matrix<float> matrix(40, 3);
#include "support/sanitized.h"
    float value = 0.0F;
#include "support/sanitized.h"
    for (float& number : matrix.values()) {
#include "support/sanitized.h"
      value = value * 3.7F + 0.4F;
#include "support/sanitized.h"
      value -= static_cast<float>(static_cast<int>(value));
#include "support/sanitized.h"
      number = value;
#include "support/sanitized.h"
    }
#include "support/sanitized.h"
    return matrix;
#include "support/sanitized.h"
  }
#include "support/sanitized.h"

#include "support/sanitized.h"
  // The same forty rows as NPY, CSV, and CSV with names and labels.
#include "support/sanitized.h"
  void write_numbers() const {
#include "support/sanitized.h"
    const Matrix<float> matrix = numbers();
#include "support/sanitized.h"
    write("rows.npy", encode_npy(matrix));
#include "support/sanitized.h"
    std::string csv;
#include "support/sanitized.h"
    std::string labels;
#include "support/sanitized.h"
    std::string labelled = "a,kind,b,c\n";
#include "support/sanitized.h"
    for (std::size_t i = 0; i < matrix.rows(); ++i) {
#include "support/sanitized.h"
      const std::string row[] = {std::to_string(matrix(i, 0)), std::to_string(matrix(i, 1)),
#include "support/sanitized.h"
                                 std::to_string(matrix(i, 2))};
#include "support/sanitized.h"
      const std::string kind = i % 3 == 0 ? "cup" : "ball";
#include "support/sanitized.h"
      csv += row[0] + "," + row[1] + "," + row[2] + "\n";
#include "support/sanitized.h"
      labelled += row[0] + "," + kind + "," + row[1] + "," + row[2] + "\n";
#include "support/sanitized.h"
      labels += kind + "\n";
#include "support/sanitized.h"
    }
#include "support/sanitized.h"
    write("rows.csv", csv);
#include "support/sanitized.h"
    write("labelled.csv", labelled);
#include "support/sanitized.h"
    write("labels", labels);
#include "support/sanitized.h"
  }
#include "support/sanitized.h"

#include "support/sanitized.h"
  static Words training(const Words& more, const std::string& epochs = "4") {
#include "support/sanitized.h"
    return with({"som", "train", "--training", "batch", "--rows", "3", "--columns", "4", "--epochs",
#include "support/sanitized.h"
                 epochs},
#include "support/sanitized.h"
                more);
#include "support/sanitized.h"
  }
#include "support/sanitized.h"
};
#include "support/sanitized.h"

#include "support/sanitized.h"
const std::vector<Words> kWays{{"rows.npy"},
#include "support/sanitized.h"
                               {"rows.npy", "--standardize"},
#include "support/sanitized.h"
                               {"rows.npy", "--similarity", "dot_product"},
#include "support/sanitized.h"
                               {"rows.npy", "--initial-weights", "samples", "--labels", "labels"},
#include "support/sanitized.h"
                               {"rows.csv", "--normalize-input", "true"},
#include "support/sanitized.h"
                               {"rows.csv", "--initial-weights", "uniform"},
#include "support/sanitized.h"
                               {"labelled.csv", "--label-column", "kind", "--standardize"}};
#include "support/sanitized.h"

#include "support/sanitized.h"
class LargeFilesThread : public LargeFiles {};
#include "support/sanitized.h"

#include "support/sanitized.h"
TEST_F(LargeFilesThread, GiveTheSameMapAsInMemory) {
#include "support/sanitized.h"
  write_numbers();
#include "support/sanitized.h"
  for (const Words& way : kWays) {
#include "support/sanitized.h"
    SCOPED_TRACE(::testing::PrintToString(way));
#include "support/sanitized.h"
    const std::string figures = output_of(with(training(way), {"-o", "x.map"}));
#include "support/sanitized.h"
    const std::string expected = read("x.map");
#include "support/sanitized.h"
    for (const char* threads : {"1", "2", "4"}) {
#include "support/sanitized.h"
      EXPECT_EQ(output_of(with(training(way), {"-o", "x.map", kLittle, "--threads", threads})),
#include "support/sanitized.h"
                figures);
#include "support/sanitized.h"
      EXPECT_TRUE(read("x.map") == expected) << threads;
#include "support/sanitized.h"
    }
#include "support/sanitized.h"
  }
#include "support/sanitized.h"
}
#include "support/sanitized.h"

#include "support/sanitized.h"
TEST_F(LargeFiles, AreMeasuredMappedAndDrawnAsInMemory) {
#include "support/sanitized.h"
  write_numbers();
#include "support/sanitized.h"
  for (const Words& way : kWays) {
#include "support/sanitized.h"
    SCOPED_TRACE(::testing::PrintToString(way));
#include "support/sanitized.h"
    output_of(with(training(way), {"-o", "x.map"}));
#include "support/sanitized.h"
    const bool column = way[0] == "labelled.csv";
#include "support/sanitized.h"
    const Words data = column ? Words{way[0], "--label-column", "kind"} : Words{way[0]};
#include "support/sanitized.h"
    const Words labels = column ? Words{} : Words{"--labels", "labels"};
#include "support/sanitized.h"
    const Words quality = with(with({"som", "quality", "x.map"}, data), labels);
#include "support/sanitized.h"
    EXPECT_EQ(output_of(with(quality, {kLittle})), output_of(quality));
#include "support/sanitized.h"
    const Words map = with({"som", "map", "x.map"}, data);
#include "support/sanitized.h"
    const std::string csv = output_of(map);
#include "support/sanitized.h"
    EXPECT_EQ(output_of(with(map, {kLittle})), csv);
#include "support/sanitized.h"
    output_of(with(map, {"-o", "y", "--activity", "z"}));
#include "support/sanitized.h"
    const std::string activity = read("z");
#include "support/sanitized.h"
    output_of(with(map, {"-o", "y", "--activity", "z", kLittle}));
#include "support/sanitized.h"
    EXPECT_EQ(read("y"), csv);
#include "support/sanitized.h"
    EXPECT_TRUE(read("z") == activity);
#include "support/sanitized.h"
    const Words plot = with(with({"som", "plot", "x.map", "-o", "p"}, data), labels);
#include "support/sanitized.h"
    output_of(plot);
#include "support/sanitized.h"
    const std::string picture = read("p");
#include "support/sanitized.h"
    output_of(with(plot, {kLittle}));
#include "support/sanitized.h"
    EXPECT_TRUE(read("p") == picture);
#include "support/sanitized.h"
  }
#include "support/sanitized.h"
}
#include "support/sanitized.h"

#include "support/sanitized.h"
TEST_F(LargeFiles, AreNotForOnlineTraining) {
#include "support/sanitized.h"
  write_numbers();
#include "support/sanitized.h"
  expect_refused(1, {"som", "train", "rows.npy", "-o", "x", kLittle},
#include "support/sanitized.h"
                 {"rows.npy: online training", "40 x 3", "--training batch", "--memory"});
#include "support/sanitized.h"
}
#include "support/sanitized.h"

#include "support/sanitized.h"
TEST_F(LargeFiles, AFaultInTheLastRowIsToldBeforeAnythingIsWritten) {
#include "support/sanitized.h"
  write_numbers();
#include "support/sanitized.h"
  output_of(with(training({"rows.npy"}), {"-o", "good.map"}));
#include "support/sanitized.h"
  Matrix<float> matrix = numbers();
#include "support/sanitized.h"
  matrix(39, 1) = std::numeric_limits<float>::quiet_NaN();
#include "support/sanitized.h"
  write("bad.npy", encode_npy(matrix));
#include "support/sanitized.h"
  const std::string good = encode_npy(numbers());
#include "support/sanitized.h"
  write("cut.npy", good.substr(0, good.size() - 1));
#include "support/sanitized.h"
  write("bad.csv", read("rows.csv") + "1,inf,2\n");
#include "support/sanitized.h"
  write("short.csv", read("rows.csv") + "1,2\n");
#include "support/sanitized.h"
  write("none.csv", "\n# nothing but a remark that is longer than the memory\n\n\n\n\n\n\n\n\n");
#include "support/sanitized.h"
  const std::vector<std::pair<std::string, Words>> files{
#include "support/sanitized.h"
      {"bad.npy", {"bad.npy: ", "row 40, column 2", "no finite"}},
#include "support/sanitized.h"
      {"cut.npy", {"cut.npy: ", "cut short"}},
#include "support/sanitized.h"
      {"bad.csv", {"bad.csv:41:3: ", "'inf'"}},
#include "support/sanitized.h"
      {"short.csv", {"short.csv:41: ", "expected 3 fields, found 2"}},
#include "support/sanitized.h"
      {"none.csv", {"none.csv: ", "no rows of numbers"}}};
#include "support/sanitized.h"
  for (const auto& [file, says] : files) {
#include "support/sanitized.h"
    expect_refused(1,
#include "support/sanitized.h"
                   {{with(training({file}), {"-o", "x", kLittle}), says},
#include "support/sanitized.h"
                    {{"som", "quality", "good.map", file, kLittle}, says},
#include "support/sanitized.h"
                    {{"som", "map", "good.map", file, kLittle}, says},
#include "support/sanitized.h"
                    {{"som", "map", "good.map", file, "-o", "x", "--activity", "y", kLittle}, says},
#include "support/sanitized.h"
                    {{"som", "plot", "good.map", file, "-o", "x", kLittle}, says}});
#include "support/sanitized.h"
  }
#include "support/sanitized.h"
}
#include "support/sanitized.h"

#include "support/sanitized.h"
TEST_F(LargeFiles, AreRefusedForTheSameReasonsAsInMemory) {
#include "support/sanitized.h"
  write_numbers();
#include "support/sanitized.h"
  write("few", "a\nb\n");
#include "support/sanitized.h"
  write("one.csv", "1,2,3" + std::string(200, ' ') + "\n");
#include "support/sanitized.h"
  write("constant.csv", "a,b\n1,2\n1,3\n1,4\n1,5\n1,6\n1,7\n1,8\n1,9\n1,10\n1,11\n1,12\n");
#include "support/sanitized.h"
  const Words end{"-o", "x", kLittle};
#include "support/sanitized.h"
  expect_refused(
#include "support/sanitized.h"
      1, {{with(training({"rows.npy", "--labels", "few"}), end), {"few", "2 labels for 40 rows"}},
#include "support/sanitized.h"
          {with(training({"one.csv"}), end), {"one.csv", "only one sample"}},
#include "support/sanitized.h"
          {with(training({"constant.csv"}), end), {"column 1 ('a')", "same value"}}});
#include "support/sanitized.h"
  expect_refused(
#include "support/sanitized.h"
      2, {{with(training({"rows.npy", "--label-column", "1"}), end), {"no label column"}},
#include "support/sanitized.h"
          {with(training({"rows.csv", "--label-column", "x"}), end), {"no column 'x'"}},
#include "support/sanitized.h"
          {with(training({"labelled.csv", "--label-column", "kind", "--labels", "few"}), end),
#include "support/sanitized.h"
           {"given twice"}}});
#include "support/sanitized.h"
}
#include "support/sanitized.h"

#include "support/sanitized.h"
TEST_F(LargeFiles, MemoryIsANumberWithAUnit) {
#include "support/sanitized.h"
  write_numbers();
#include "support/sanitized.h"
  for (const char* wrong : {"much", "-1MiB", "0", "1.5X", "MiB", "1 2", "nan", "inf", "1e99GiB"}) {
#include "support/sanitized.h"
    expect_refused(2, with(training({"rows.npy"}), {"-o", "x", std::string("--memory=") + wrong}),
#include "support/sanitized.h"
                   {"--memory", "500MiB"});
#include "support/sanitized.h"
  }
#include "support/sanitized.h"
  for (const char* right : {"0.5GiB", "100 MB", "200", "3kB", "1GB", "9KiB"}) {
#include "support/sanitized.h"
    output_of(with(training({"rows.npy"}), {"-o", "x", std::string("--memory=") + right}));
#include "support/sanitized.h"
  }
#include "support/sanitized.h"
}
#include "support/sanitized.h"

#include "support/sanitized.h"
// 48 MiB of numbers, which would take twice to three times as much, by default.
#include "support/sanitized.h"
TEST_F(LargeFiles, AreTrainedOnInLessMemoryThanTheyTake) {
#include "support/sanitized.h"
#ifdef SOMATO_TESTS_SANITIZED
#include "support/sanitized.h"
  GTEST_SKIP() << "sanitizers need all the address space";
#include "support/sanitized.h"
#endif
#include "support/sanitized.h"
  constexpr std::size_t kRows = 393216;
#include "support/sanitized.h"
  std::string bytes = npy_start(kRows, 32);
#include "support/sanitized.h"
  const std::string values = npy_numbers(numbers().values().first(96));
#include "support/sanitized.h"
  bytes.reserve(bytes.size() + kRows * 128);
#include "support/sanitized.h"
  for (std::size_t i = 0; i < kRows / 3; ++i) bytes += values;
#include "support/sanitized.h"
  write("rows.npy", bytes);
#include "support/sanitized.h"
  ProgramWorld world;
#include "support/sanitized.h"
  world.memory = std::size_t{160} << 20;
#include "support/sanitized.h"
  const ProgramRun done =
#include "support/sanitized.h"
      run(with(training({"rows.npy"}, "1"), {"-o", "x", "--threads", "2"}), world);
#include "support/sanitized.h"
  EXPECT_EQ(done.exit_code, 0) << done.err;
#include "support/sanitized.h"
  EXPECT_EQ(done.err, "");
#include "support/sanitized.h"
  EXPECT_NE(done.out.find("trained on 393216 samples of 32 features"), std::string::npos);
#include "support/sanitized.h"
}
#include "support/sanitized.h"

#include "support/sanitized.h"
TEST_F(LargeFiles, TellAPersonWhatIsDoneAndStopAtCtrlC) {
#include "support/sanitized.h"
  write_numbers();
#include "support/sanitized.h"
  ProgramWorld world;
#include "support/sanitized.h"
  world.terminal = true;
#include "support/sanitized.h"
  const Words words = with(training({"rows.npy"}), {"-o", "x", kLittle});
#include "support/sanitized.h"
  const ProgramRun done = run(words, world);
#include "support/sanitized.h"
  EXPECT_EQ(done.exit_code, 0);
#include "support/sanitized.h"
  for (const char* said : {"reading: 100 %", "training:   1 %, ", " left", "training: 100 %, took",
#include "support/sanitized.h"
                           "measuring: 100 %, took"}) {
#include "support/sanitized.h"
    EXPECT_NE(done.err.find(said), std::string::npos) << said << " in " << done.err;
#include "support/sanitized.h"
  }
#include "support/sanitized.h"
  std::string csv = read("rows.csv");
#include "support/sanitized.h"
  while (csv.size() < 8000000) csv += csv;
#include "support/sanitized.h"
  write("long.csv", csv);
#include "support/sanitized.h"
  for (const char* moment : {"reading: ", "training: ", "measuring: "}) {
#include "support/sanitized.h"
    world.interrupt_at = moment;
#include "support/sanitized.h"
    const std::string epochs = moment == std::string("training: ") ? "100000" : "1";
#include "support/sanitized.h"
    const auto before = contents();
#include "support/sanitized.h"
    const ProgramRun stopped =
#include "support/sanitized.h"
        run(with(training({"long.csv"}, epochs), {"-o", "x", "--memory", "4MB"}), world);
#include "support/sanitized.h"
    EXPECT_EQ(stopped.exit_code, 130) << moment << stopped.err;
#include "support/sanitized.h"
    EXPECT_EQ(stopped.out, "");
#include "support/sanitized.h"
    EXPECT_NE(stopped.err.find("was stopped before its end"), std::string::npos) << stopped.err;
#include "support/sanitized.h"
    EXPECT_TRUE(contents() == before);
#include "support/sanitized.h"
  }
#include "support/sanitized.h"
}
#include "support/sanitized.h"

#include "support/sanitized.h"
}  // namespace
#include "support/sanitized.h"
}  // namespace somato
#include "support/sanitized.h"
