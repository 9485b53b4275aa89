#include <sstream>

#include <algorithm>

#include "base/support/places.h"
#include "program/support/program_test.h"

namespace somato {
namespace {

class Usage : public ProgramTest {};

TEST_F(Usage, UnknownCommandsAndFlagsNameTheNearest) {
  write_data();
  expect_refused(
      2, {{{"som"}, {"som: a command is missing", "train, map, quality, plot"}},
          {{"sim"}, {"unknown command 'sim'", "did you mean 'som'?"}},
          {{"som", "trian", "data.csv", "-o", "x"},
           {"som: unknown command 'trian'", "did you mean 'train'?"}},
          {{"--hlep"}, {"unknown flag '--hlep'", "'--help'"}},
          {{"som", "train", "data.csv", "-o", "x", "--rwos", "3"},
           {"som train: unknown flag '--rwos'", "did you mean '--rows'?"}},
          {{"som", "train", "data.csv", "--rwos=3"}, {"unknown flag '--rwos'", "'--rows'"}},
          {{"som", "train", "data.csv", "-o", "x", "-z"},
           {"unknown flag '-z'", "see 'somato som train --help'"}},
          {{"som", "map", "m", "data.csv", "--labls", "x"}, {"som map: unknown flag '--labls'"}},
          {{"reference", "more"}, {"reference: unexpected argument 'more'"}},
          {{"run", "a", "b", "--data", "c", "--out", "d"}, {"unexpected argument 'b'"}}});
}

TEST_F(Usage, MissingArgumentsAreNamed) {
  write_data();
  expect_refused(
      2, {{{"som", "train"}, {"som train: DATA is required", "som train --help"}},
          {{"som", "train", "data.csv"}, {"--output is required"}},
          {{"som", "map"}, {"MAP is required"}},
          {{"som", "map", "m"}, {"DATA is required"}},
          {{"som", "quality", "m"}, {"DATA is required"}},
          {{"som", "plot", "m"}, {"--output is required"}},
          {{"run"}, {"is required"}},
          {{"run", "s", "--out", "o"}, {"--data is required"}},
          {{"run", "s", "--data", "o"}, {"--out is required"}},
          {{"som", "train", "data.csv", "-o", "x", "--rows"}, {"--rows: a value is missing"}},
          {{"som", "train", "data.csv", "-o"}, {"--output: a value is missing"}},
          {{"som", "train", "data.csv", "-o", ""}, {"--output: the value is empty"}},
          {{"som", "train", "", "-o", "x"}, {"DATA: the value is empty"}},
          {{"run", "", "--data", "c", "--out", "d"}, {"STUDY: the value is empty"}}});
}

TEST_F(Usage, FlagsAreGivenOnce) {
  write_data();
  const Words train{"som", "train", "data.csv", "-o", "x"};
  const auto with = [&](Words more) {
    more.insert(more.begin(), train.begin(), train.end());
    return more;
  };
  expect_refused(2, {{with({"--seed", "1", "--seed", "2"}), {"--seed: given 2 times"}},
                     {with({"--output", "y"}), {"--output: given 2 times"}},
                     {with({"--standardize", "--standardize"}), {"--standardize: given 2 times"}},
                     {with({"--standardize=no"}), {"--standardize: takes no value"}}});
}

TEST_F(Usage, ValuesOfTheWrongTypeOrOutOfRangeAreRefused) {
  write_data();
  const std::vector<std::pair<Words, Words>> cases{
      {{"--rows", "0"}, {"--rows: ", "a whole number, 1 to 16777216, not 0"}},
      {{"--rows", "-1"}, {"--rows: ", "not -1"}},
      {{"--rows", "1e9"}, {"--rows: ", "1e9"}},
      {{"--rows", "1000000000"}, {"--rows: ", "not 1000000000"}},
      {{"--rows", "99999999999999999999999"}, {"--rows: ", "99999999999999999999999"}},
      {{"--rows", "3.5"}, {"--rows: ", "3.5"}},
      {{"--rows", "many"}, {"--rows: ", "many"}},
      {{"--rows", ""}, {"--rows: ", "empty"}},
      {{"--rows", "4097", "--columns", "4096"}, {"4097 x 4096", "16777216", "fewer"}},
      {{"--lattice", "hexagonal", "--topology", "torus", "--rows", "3"}, {"even number of rows"}},
      {{"--learning-rate-start", "2"}, {"--learning-rate-start: ", "0 to 1, not 2"}},
      {{"--learning-rate-end", "-0.5"}, {"--learning-rate-end: ", "-0.5"}},
      {{"--radius-start", "nan"}, {"--radius-start: ", "nan", "automatic"}},
      {{"--radius-end", "inf"}, {"--radius-end: ", "inf"}},
      {{"--seed", "-1"}, {"--seed: ", "not -1"}},
      {{"--iterations", "lots"}, {"--iterations: ", "lots", "automatic"}},
      {{"--lattice", "hexagon"}, {"--lattice: ", "did you mean 'hexagonal'?"}},
      {{"--training", "bach"}, {"--training: ", "online, batch", "did you mean 'batch'?"}},
      {{"--normalize-input", "maybe"}, {"--normalize-input: ", "true or false"}},
      {{"--softmax-exponent", "0"}, {"--softmax-exponent: ", "above 0"}},
      {{"--threads", "0"}, {"--threads: ", "at least 1"}},
      {{"--threads", "two"}, {"--threads: ", "two"}},
      {{"--labels", "l", "--label-column", "1"}, {"--label-column: ", "either --labels or"}}};
  for (const auto& [flags, says] : cases) {
    Words arguments{"som", "train", "data.csv", "-o", "x"};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    expect_refused(2, arguments, says);
  }
}

TEST_F(Usage, OtherCommandsCheckTheirFlagsToo) {
  train();
  expect_refused(
      2, {{{"som", "quality", "good.map", "data.csv", "--threads", "-2"}, {"--threads: ", "-2"}},
          {{"som", "plot", "good.map", "-o", "x", "--components", "x"}, {"--components: "}},
          {{"som", "plot", "good.map", "-o", "x", "--components", "-1"}, {"--components: ", "-1"}},
          {{"som", "plot", "good.map", "-o", "x", "--panels", "hit"},
           {"--panels: ", "did you mean 'hits'?"}},
          {{"som", "plot", "good.map", "-o", "x", "--panels", "hits"},
           {"--panels: hits cannot be drawn without data", "provide DATA"}},
          {{"som", "plot", "good.map", "data.csv", "-o", "x", "--panels", "u_matrix,labels"},
           {"--panels: labels cannot be drawn", "--label-column"}},
          {{"som", "plot", "good.map", "-o", "x", "--panels", "components", "--components", "0"},
           {"no panel can be drawn"}},
          {{"run", "missing", "--data", "d", "--out", "o", "--seeds", "0"},
           {"--seeds: ", "at least 1, not 0"}},
          {{"run", "missing", "--data", "d", "--out", "o", "--threads", "0"}, {"--threads: "}},
          {{"run", "missing", "--explain=yes"}, {"--explain: takes no value"}}});
}

TEST_F(Usage, VersionAndHelpGoToStandardOutput) {
  EXPECT_TRUE(output_of({"--version"}).starts_with("somato "));
  EXPECT_EQ(output_of({"-V"}), output_of({"--version"}));
  for (const Words& words : {Words{"--help"}, {"-h"}, {"som", "--help"}, {"run", "--help"}}) {
    EXPECT_NE(output_of(words).find("Usage: somato"), std::string::npos);
  }
}

TEST_F(Usage, HelpDescribesEachGroupByItsCommands) {
  const auto first_line = [&](const std::string& group) {
    const std::string help = output_of({group, "--help"});
    return help.substr(0, help.find('\n'));
  };
  EXPECT_NE(first_line("som").find("maps"), std::string::npos);
  EXPECT_NE(first_line("device").find("hands and probes"), std::string::npos);
}

TEST_F(Usage, HelpComesWithoutDashesToo) {
  EXPECT_EQ(output_of({}), output_of({"--help"}));
  EXPECT_EQ(output_of({"help"}), output_of({"--help"}));
  EXPECT_EQ(output_of({"help", "som", "train"}), output_of({"som", "train", "--help"}));
}

TEST_F(Usage, HelpIsWrapped) {
  std::istringstream help(output_of({"som", "train", "--help"}));
  for (std::string line; std::getline(help, line);) EXPECT_LE(line.size(), 100U) << line;
}

TEST_F(Usage, ADashIsAStandardStream) {
  train();
  EXPECT_EQ(output_of({"som", "map", "good.map", "data.csv", "-o", "-"}),
            output_of({"som", "map", "good.map", "data.csv"}));
  EXPECT_NE(output_of({"som", "plot", "good.map", "-o", "-"}).find("<svg"), std::string::npos);
  ProgramWorld world;
  world.input_from = path("data.csv");
  EXPECT_EQ(run({"som", "map", "good.map", "-"}, world).out,
            output_of({"som", "map", "good.map", "data.csv"}));
}

TEST_F(Usage, SystemsAreListedAndRunByName) {
  const std::string systems = output_of({"systems"});
  for (const char* name : {"shape_and_size ", "texture ", "hardness_acoustic", "t_mpsom_ratio"}) {
    EXPECT_NE(systems.find(name), std::string::npos) << name;
  }
  EXPECT_EQ(output_of({"run", "shape_and_size", "--explain"}),
            output_of({"run", source_path("systems/shape_and_size.toml"), "--explain"}));
}

// Words such as --rows of a help text.
std::vector<std::string> flags_in(const std::string& help) {
  std::vector<std::string> flags;
  for (std::size_t at = help.find(" --"); at != std::string::npos; at = help.find(" --", at + 1)) {
    const std::size_t end = help.find_first_not_of("abcdefghijklmnopqrstuvwxyz-", at + 1);
    flags.push_back(help.substr(at + 1, end - at - 1));
  }
  return flags;
}

// `--radius-start` is the key `radius_start`.
std::string key_of(std::string flag) {
  flag.erase(0, 2);
  std::replace(flag.begin(), flag.end(), '-', '_');
  return flag;
}

TEST_F(Usage, TheReferenceNamesEveryFlagInItsCommandsSection) {
  const std::string page = output_of({"reference"});
  for (const Words& command : {Words{"run"},
                               {"apply"},
                               {"modules"},
                               {"recover"},
                               {"som", "train"},
                               {"som", "map"},
                               {"som", "quality"},
                               {"som", "plot"}}) {
    std::string title = "### `somato";
    for (const std::string& word : command) title += " " + word;
    const std::size_t begin = page.find(title);
    ASSERT_NE(begin, std::string::npos) << title;
    const std::string section = page.substr(begin, page.find("\n##", begin + 1) - begin);
    Words arguments = command;
    arguments.push_back("--help");
    const auto flags = flags_in(output_of(arguments));
    EXPECT_GE(flags.size(), 1u);
    // A section may point at a table of keys instead of repeating it.
    std::string keys;
    for (const std::string table : {"map", "size", "measures", "refinement"}) {
      if (section.find("(#" + table + ")") == std::string::npos) continue;
      const std::size_t start = page.find("### " + table);
      keys += page.substr(start, page.find("\n##", start + 1) - start);
    }
    for (const std::string& flag : flags) {
      if (flag == "--help" || flag == "--output") continue;
      const bool is_flag = section.find("`" + flag + "`") != std::string::npos;
      const bool is_key = keys.find("| `" + key_of(flag) + "` |") != std::string::npos;
      EXPECT_TRUE(is_flag || is_key) << title << " lacks " << flag;
    }
  }
}

TEST_F(Usage, TheReferenceNamesTheTablesOfAStudy) {
  const std::string page = output_of({"reference"});
  for (const char* part :
       {"[study]", "[recording]", "[module.NAME]", "[[phase]]", "`folds`", "`seeds`"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
}

}  // namespace
}  // namespace somato
