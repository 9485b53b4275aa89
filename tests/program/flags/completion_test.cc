#include <sstream>

#include "program/support/program_test.h"

namespace somato {
namespace {

Words lines_of(const std::string& text) {
  Words lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

class Completion : public ProgramTest {
 protected:
  // The words without their texts.
  Words completed(const Words& words) const {
    Words arguments{"completions", "words"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    Words found;
    for (const std::string& line : lines_of(output_of(arguments))) {
      EXPECT_NE(line.find('\t'), std::string::npos) << line;
      found.push_back(line.substr(0, line.find('\t')));
    }
    return found;
  }

  // The words that a shell makes of its script, which it finds in the file "script".
  Words in_shell(const std::string& shell, const std::string& code) const {
    write("script", output_of({"completions", shell}));
    const ProgramRun done = run_other({shell, "-c", code});
    EXPECT_EQ(done.exit_code, 0) << done.err;
    EXPECT_EQ(done.err, "");
    return lines_of(done.out);
  }
};

TEST_F(Completion, KnowsCommandsAndTheirWords) {
  EXPECT_EQ(completed({"re"}), (Words{"reproduce", "report", "recover", "reference"}));
  EXPECT_EQ(completed({"so"}), (Words{"som"}));
  EXPECT_EQ(completed({"som", ""}), (Words{"train", "map", "quality", "plot", "cluster", "features",
                                           "export", "import", "predict"}));
  EXPECT_EQ(completed({"nothing", ""}), Words{});
}

TEST_F(Completion, KnowsFlagsAndTheirValues) {
  EXPECT_EQ(completed({"som", "train", "a.csv", "--tr"}), (Words{"--training"}));
  EXPECT_EQ(completed({"som", "train", "--training", ""}), (Words{"online", "batch"}));
  EXPECT_EQ(completed({"explore", "--free", "f"}), (Words{"false"}));
  EXPECT_EQ(completed({"run", "--qu"}), (Words{"--quiet"}));
  EXPECT_EQ(completed({"run", "--data", ""}), Words{}) << "the shell completes files";
}

TEST_F(Completion, KnowsNames) {
  EXPECT_EQ(completed({"run", "t_mpsom_a"}), (Words{"t_mpsom_added", "t_mpsom_added_icub"}));
  EXPECT_EQ(completed({"run", "--seeds", "3", "fabrics"}), (Words{"fabricslide"}));
  EXPECT_EQ(completed({"reproduce", "texture", "hardn"}),
            (Words{"hardness", "hardness_acoustic", "hardness_from_texture", "hardness_hkust"}));
  EXPECT_EQ(completed({"modules", "one"}), (Words{"one_hot"}));
  EXPECT_EQ(completed({"modules", "som", ""}), Words{}) << "one type only";
  EXPECT_EQ(completed({"completions", ""}), (Words{"bash", "zsh", "fish"}));
}

TEST_F(Completion, WorksInBash) {
  EXPECT_EQ(in_shell("bash", "source ./script; complete -p somato; COMP_WORDS=('" + program() +
                                 "' som qu); COMP_CWORD=2; _somato '" + program() +
                                 "'; echo ${COMPREPLY[@]}"),
            (Words{"complete -o default -F _somato somato", "quality"}));
}

TEST_F(Completion, WorksInZsh) {
  EXPECT_EQ(in_shell("zsh",
                     "compdef() { echo $@ }; _describe() { print -l \"${(@P)2}\" }; "
                     "_files() { echo files }; source ./script; words=('" +
                         program() +
                         "' som m); CURRENT=3; _somato; words[4]=x; CURRENT=4; "
                         "_somato"),
            (Words{"_somato somato",
                   "map:Find the winner of each row on a map, and its label if the map has labels",
                   "files"}));
}

TEST_F(Completion, WorksInFish) {
  EXPECT_EQ(in_shell("fish", "function somato; '" + program() +
                                 "' $argv; end; source script; complete -C 'somato som pl'"),
            (Words{"plot\tDraw a map: U-matrix, hits, classes, component planes, clusters, "
                   "trajectories and more, or its weights on a skin"}));
}

TEST_F(Completion, RefusesOtherShells) {
  expect_refused(2, {{{"completions"}, {"SHELL is required"}},
                     {{"completions", "zhs"}, {"unknown shell 'zhs'", "did you mean 'zsh'?"}}});
}

}  // namespace
}  // namespace somato
