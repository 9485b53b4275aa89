#include "program/program_test.h"

namespace somato {
namespace {

Words explore_topics(const Words& flags) {
  Words words{"explore", "--topics", "ws://robot:8765", "-o", "x.mcap"};
  words.insert(words.end(), flags.begin(), flags.end());
  return words;
}

class Topics : public ProgramTest {};

TEST_F(Topics, RefusesFlagsWithoutEffectAndWrongValues) {
  const Words channels{"--channels", "touch:N=/skin:forces"};
  const auto with = [&](Words flags) {
    flags.insert(flags.end(), channels.begin(), channels.end());
    return explore_topics(flags);
  };
  expect_refused(
      2, {{explore_topics({}), {"--channels", "required", "NAME:UNIT=/TOPIC:PATH"}},
          {explore_topics({"--channels", "touch"}), {"--channels", "'touch' is not a channel"}},
          {explore_topics({"--channels", "a=/x:y,a=/z:y"}), {"two channels are named 'a'"}},
          {with({"--taxels", "2"}), {"--taxels", "no effect with --topics"}},
          {with({"--seed", "2"}), {"--seed", "no effect with topics"}},
          {with({"--things", "cup,,ball"}), {"--things", "has no name"}},
          {with({"--duration", "0"}), {"--duration"}},
          {{"explore", "--body", "lucs2", "--things", "cup", "-o", "x.mcap"},
           {"--things", "no effect without topics"}}});
  Words wrong = with({});
  wrong[2] = "http://robot";
  expect_refused(2, {{wrong, {"http://robot", "ws://robot:8765"}}});
}

}  // namespace
}  // namespace somato
