#include "views/http/downloads.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "base/support/temporary_folder.h"
#include "somato/recording/recording_file.h"
#include "somato/recording/recover_recording.h"
#include "views/live/sessions.h"
#include "views/live/view_systems.h"
#include "views/live/viewing.h"
#include "views/support/http_client.h"

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
  const TemporaryFolder folder;
  const auto file = GrowingRecording::begin(folder.file("session.mcap")).value();
  ViewSource source = testing::body_source(200);
  source.file = file.get();
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
  EXPECT_EQ(state_of(session)["saved"],
            nlohmann::json::parse(R"({"file":"session.mcap","explorations":1})"));
  session.stop();
  ASSERT_TRUE(file->finish());
  const Recording saved = read_recording(folder.file("session.mcap")).value();
  ASSERT_EQ(saved.explorations.size(), 1U);
  EXPECT_EQ(saved.explorations[0].labels, (std::vector<Label>{{"object", "pear"}}));
}

// A name that is given late is that of the file, too.
TEST_F(DownloadsThread, NameWhatIsSavedAlready) {
  const TemporaryFolder folder;
  const auto file = GrowingRecording::begin(folder.file("session.mcap")).value();
  ViewSource source = testing::body_source();
  source.file = file.get();
  ViewSession session(std::move(source), testing::at_once());
  session.start();
  ASSERT_TRUE(eventually([&] { return state_of(session)["explorations"].size() == 1; }));
  command(session, R"({"command":"explore"})");
  ASSERT_TRUE(eventually([&] { return state_of(session)["explorations"].size() == 2; }));
  command(session, R"({"command":"seek","exploration":0,"frame":0})");
  command(session, R"({"command":"name","label":"object","value":"pear"})");
  const std::string out = folder.file("recovered");
  ASSERT_TRUE(recover_recording(folder.file("session.mcap.partial"), out));
  const Recording recovered = read_recording(out).value();
  ASSERT_EQ(recovered.explorations.size(), 2U);
  EXPECT_EQ(recovered.explorations[0].labels[0].value, "pear");
  EXPECT_NE(recovered.explorations[1].labels[0].value, "pear");
}

}  // namespace
}  // namespace somato
