#include "program/support/program_test.h"
#include "views/support/http_client.h"

#include <cstdint>
#include <string>

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

// The text between two others.
std::string part_between(const std::string& text, const std::string& before,
                         const std::string& after) {
  const std::size_t start = text.find(before) + before.size();
  return text.substr(start, text.find(after, start) - start);
}

// The state that the view at the printed address serves.
std::string state_of(const std::string& out) {
  const auto port =
      static_cast<std::uint16_t>(std::stoi(part_between(out, "http://127.0.0.1:", "/")));
  const std::string token = part_between(out, "?token=", "\n");
  return testing::ask(port, testing::get_request(port, "/api/state?token=" + token));
}

// Built-in systems hear sounds and joints; none hears a channel of another name.
TEST_F(Topics, TheViewOffersSystemsThatHearTheirChannels) {
  const auto state_with = [&](const std::string& channels) {
    std::string state;
    ProgramWorld world;
    world.before_interrupt = [&](const std::string& out) { state = state_of(out); };
    world.interrupt_at = "Press Ctrl-C to close the view.";
    const ProgramRun done =
        run({"view", "--topics", "ws://127.0.0.1:9", "--channels", channels}, world);
    EXPECT_EQ(done.exit_code, 0) << done.err;
    return state;
  };
  const std::string skin = state_with("skin:N=/skin:forces");
  EXPECT_NE(skin.find(R"("systems":[])"), std::string::npos) << skin;
  const std::string sound = state_with("sound=/sound:samples,joints:deg=/joints:position");
  EXPECT_EQ(sound.find(R"("systems":[])"), std::string::npos) << sound;
}

}  // namespace
}  // namespace somato
