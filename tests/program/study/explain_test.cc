#include "program/support/program_test.h"

namespace somato {
namespace {

class Explain : public ProgramTest {};

const std::string kSystem =
    "[study]\nname = 'n'\n"
    "[module.hand]\ntype = 'channel'\nchannel = 'joints'\nshape = [9]\n"
    "[module.code]\ntype = 'one_hot'\ninput = 'hand'\nelements = 4\n"
    "[module.memory]\ntype = 'accumulate'\ninput = 'code'\n"
    "[module.map]\ntype = 'som'\ninput = 'memory'\nrows = 8\ncolumns = 16\n";

// Columns are as wide as their widest cell, so a line is compared blank by blank.
std::string single_blanks(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c != ' ' || (!out.empty() && out.back() != ' ')) out += c;
  }
  return out;
}

// 8 x 16 neurons of 36 elements of 4 bytes are 18 KiB.
const Words kLines{"module type input from shape elements every memory\n",
                   "hand channel 9 9 frame\n",
                   "code one_hot hand 9 x 4 36 (sparse) frame\n",
                   "memory accumulate code 9 x 4 36 (sparse) exploration\n",
                   "map som memory 8 x 16 128 exploration 18.0 KiB\n",
                   "phase 1 code: all frames\n",
                   "phase 2 map: all explorations\n",
                   "learned memory 18.0 KiB\n"};

TEST_F(Explain, PrintsShapesSizesAndMemoryWithoutData) {
  write("study.toml", kSystem);
  const auto before = contents();
  const std::string shown = single_blanks(output_of({"run", "study.toml", "--explain"}));
  for (const std::string& line : kLines) {
    EXPECT_NE(shown.find(line), std::string::npos) << line << "is not in\n" << shown;
  }
  EXPECT_TRUE(contents() == before);
}

TEST_F(Explain, TakesShapesFromTheData) {
  std::string system = kSystem;
  system.erase(system.find("shape = [9]\n"), 12);
  write("study.toml", system);
  const std::string shown =
      single_blanks(output_of({"run", "study.toml", "--explain", "--data", kTrials}));
  for (const std::string& line : kLines) {
    EXPECT_NE(shown.find(line), std::string::npos) << line << "is not in\n" << shown;
  }
}

// 4 x 4 neurons of as many elements of 4 bytes.
TEST_F(Explain, PrintsMemoryInBytesBelowAKibibyte) {
  for (const auto& [elements, memory] :
       {std::pair{"9", "576 B"}, {"15", "960 B"}, {"16", "1.0 KiB"}}) {
    write("study.toml", std::string("[study]\nname = 'n'\n") +
                            "[module.hand]\ntype = 'channel'\nchannel = 'joints'\nshape = [" +
                            elements + "]\n[module.closed]\ntype = 'last'\ninput = 'hand'\n" +
                            "[module.map]\ntype = 'som'\ninput = 'closed'\nrows = 4\n" +
                            "columns = 4\n");
    const std::string shown = single_blanks(output_of({"run", "study.toml", "--explain"}));
    EXPECT_NE(shown.find(std::string("map som closed 4 x 4 16 exploration ") + memory + "\n"),
              std::string::npos)
        << shown;
    EXPECT_NE(shown.find(std::string("\nlearned memory ") + memory + "\n"), std::string::npos)
        << shown;
  }
}

TEST_F(Explain, NamesPhasesAsTheyAreDescribed) {
  write("study.toml", kSystem +
                          "[[phase]]\nlearn = ['code']\n[[phase]]\nlearn = ['map']\n"
                          "draws = 40\n");
  const std::string shown = output_of({"run", "study.toml", "--explain"});
  EXPECT_NE(shown.find("phase 1  code: all frames\n"), std::string::npos) << shown;
  EXPECT_NE(shown.find("phase 2  map: 40 explorations\n"), std::string::npos) << shown;
}

TEST_F(Explain, RefusesWhatItCannotKnow) {
  std::string unknown = kSystem;
  unknown.erase(unknown.find("shape = [9]\n"), 12);
  write("unknown.toml", unknown);
  write("study.toml", kSystem);
  std::string other = kSystem;
  other.replace(other.find("[9]"), 3, "[8]");
  write("other.toml", other);
  expect_refused(
      2, {{{"run", "unknown.toml", "--explain"},
           {"unknown.toml:3, module 'hand'", "its shape is unknown", "--data", "shape = [...]"}},
          {{"run", "other.toml", "--explain", "--data", kTrials},
           {"other.toml:3, module 'hand'", "has the shape 9 in the recording, not 8",
            "correct 'shape'"}}});
  expect_refused(1, {{{"run", "study.toml", "--explain", "--data", "missing"},
                      {"missing: ", "there is no such file"}},
                     {{"run", "missing.toml", "--explain"}, {"missing.toml: cannot open"}}});
}

}  // namespace
}  // namespace somato
