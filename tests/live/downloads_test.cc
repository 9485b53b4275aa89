#include "live/downloads.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "live/sessions.h"
#include "live/view_systems.h"
#include "live/viewing.h"
#include "somato/recording/recording_file.h"
#include "support/http_client.h"
#include "support/temporary_folder.h"

namespace somato {
namespace {

using testing::command;
using testing::eventually;
using testing::state_of;

class DownloadsThread : public ::testing::Test {
 protected:
  // The file that a viewer has saved.
  std::string save(const std::string& bytes) const { return folder_.with("saved", bytes); }

 private:
  TemporaryFolder folder_;
};

TEST_F(DownloadsThread, AreTheFilesThatOtherCommandsRead) {
  const Recording recording = testing::hand_recording(2, 1);
  EXPECT_EQ(read_recording(save(live::recording_bytes(recording).value())).value(), recording);
  const auto model =
      testing::trained_model(testing::crossed_system(), testing::hand_recording(6, 2));
  const SystemModel loaded = load_system(save(live::system_bytes(*model).value())).value();
  EXPECT_EQ(loaded.answer->classes, model->answer->classes);
}

TEST_F(DownloadsThread, HoldTheNamesThatViewersGave) {
  testing::Viewing viewing(testing::hand_source(2));
  // Otherwise the next exploration may be shown before the state is read.
  EXPECT_NE(viewing.command(R"({"command":"pause"})").find("200"), std::string::npos);
  EXPECT_NE(viewing.command(R"({"command":"name","label":"object","value":"cup"})").find("200"),
            std::string::npos);
  const std::size_t shown = state_of(viewing.session())["exploration"];
  EXPECT_EQ(state_of(viewing.session())["labels"]["object"], "cup");
  const std::string answer = viewing.get("/api/recording");
  EXPECT_NE(answer.find("Content-Disposition: attachment; filename=\"session.mcap\"\r\n"),
            std::string::npos);
  const auto saved = read_recording(save(testing::body_of(answer)));
  ASSERT_TRUE(saved);
  Recording expected = testing::hand_source(2).recording;
  expected.explorations[shown].labels = {{"object", "cup"}};
  EXPECT_EQ(*saved, expected);
}

TEST_F(DownloadsThread, NeedATokenAndSomethingToSave) {
  testing::Viewing viewing(testing::body_source(), {true, 1.0, 0.0});
  for (const std::string path : {"/api/recording", "/api/system"}) {
    const std::string refused =
        testing::ask(viewing.port(), testing::get_request(viewing.port(), path));
    EXPECT_EQ(testing::status_of(refused), 403) << path;
    EXPECT_EQ(testing::status_of(viewing.get(path)), 400) << path;
  }
}

// A name that is given while a body explores is that of the exploration; it is saved with it.
TEST_F(DownloadsThread, NameWhatABodyExplores) {
  Recording saved;
  ViewSource source = testing::body_source(200);
  source.sink = [&](Exploration&& exploration) -> Result<void> {
    saved.explorations.push_back(std::move(exploration));
    return {};
  };
  ViewSession session(std::move(source), {false, 1.0, 0.0});
  session.start();
  ASSERT_TRUE(eventually([&] { return state_of(session)["live"] == true; }));
  EXPECT_EQ(state_of(session)["labels"]["object"], "ball");
  command(session, R"({"command":"name","label":"object","value":"apple"})");
  EXPECT_EQ(state_of(session)["labels"]["object"], "apple");
  command(session, R"({"command":"speed","speed":100})");
  ASSERT_TRUE(eventually([&] { return state_of(session)["explorations"].size() == 1; }));
  EXPECT_EQ(state_of(session)["explorations"][0]["labels"]["object"], "apple");
  command(session, R"({"command":"name","label":"object","value":"pear"})");
  session.stop();
  ASSERT_EQ(saved.explorations.size(), 1U);
  EXPECT_EQ(saved.explorations[0].labels, (std::vector<Label>{{"object", "pear"}}));
}

TEST_F(DownloadsThread, KeepTheNamesOfTheFileThatIsWrittenMeanwhile) {
  ViewSource source = testing::body_source();
  source.sink = [](Exploration&&) -> Result<void> { return {}; };
  ViewSession session(std::move(source), testing::at_once());
  session.start();
  ASSERT_TRUE(eventually([&] { return state_of(session)["explorations"].size() == 1; }));
  command(session, R"({"command":"explore"})");
  ASSERT_TRUE(eventually([&] { return state_of(session)["explorations"].size() == 2; }));
  command(session, R"({"command":"seek","exploration":0,"frame":0})");
  const auto refused = session.command(R"({"command":"name","label":"object","value":"pear"})");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().what.find("saved already"), std::string::npos);
}

}  // namespace
}  // namespace somato
