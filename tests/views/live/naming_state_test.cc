// The names of a session, as all of its pages see them.

#include "views/live/naming_state.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "base/support/failing_file_system.h"
#include "base/support/temporary_folder.h"
#include "somato/recording/recording_file.h"
#include "views/live/sessions.h"
#include "views/live/viewing.h"

namespace somato {
namespace {

using nlohmann::json;
using testing::command;
using testing::eventually;
using testing::state_of;

class NamingThread : public ::testing::Test {
 protected:
  static ViewSettings resting() { return {true, 1.0, 0.0}; }

  static json naming(ViewSession& session) { return state_of(session)["naming"]; }

  static std::string of(const std::string& what, const std::string& value, int id) {
    return json{{"command", what}, {"label", "object"}, {"value", value}, {"id", id}}.dump();
  }
  static void name(ViewSession& session, const std::string& value, int id) {
    command(session, of("name", value, id));
  }
  static void undo(ViewSession& session, const std::string& value, int id) {
    command(session, of("undo_name", value, id));
  }

  static bool is_refused(ViewSession& session, const std::string& text, const std::string& why) {
    const auto done = session.command(text);
    return !done && done.error().what.find(why) != std::string::npos;
  }
};

// The three explorations have the labels "object 0", "object 1", "object 0".
TEST_F(NamingThread, CountsNamesAndProposesTheNext) {
  ViewSource source = testing::hand_source();
  source.names = {"cup", "ball"};
  source.each = 1;
  ViewSession session(std::move(source), resting());
  session.start();
  EXPECT_EQ(naming(session), json::parse(R"({
    "names":[{"name":"cup","explorations":0},{"name":"ball","explorations":0},
             {"name":"object 0","explorations":2},{"name":"object 1","explorations":1}],
    "each":1,"next":{"name":"cup","number":1},"id":0,"given":null,"last":null})"));
  name(session, "cup", 0);
  EXPECT_EQ(naming(session)["names"][0], (json{{"name", "cup"}, {"explorations", 1}}));
  EXPECT_EQ(naming(session)["names"][2], (json{{"name", "object 0"}, {"explorations", 1}}));
  EXPECT_EQ(naming(session)["next"], (json{{"name", "ball"}, {"number", 1}}));
  EXPECT_EQ(naming(session)["given"], "cup");
  name(session, "ball", 2);
  EXPECT_EQ(naming(session)["next"], nullptr);
  EXPECT_EQ(naming(session)["last"],
            (json{{"exploration", 2}, {"id", 2}, {"label", "object"}, {"name", "ball"}}));
  command(session, R"({"command":"plan","each":2})");
  EXPECT_EQ(naming(session)["next"], (json{{"name", "cup"}, {"number", 2}}));
  command(session, R"({"command":"plan","each":0})");
  EXPECT_EQ(naming(session)["each"], nullptr);
}

TEST_F(NamingThread, UndoesTheLastNameOnly) {
  ViewSession session(testing::hand_source(), resting());
  session.start();
  const json before = state_of(session);
  name(session, "cup", 0);
  name(session, "mug", 0);
  name(session, "ball", 1);
  const std::string last = "last is now object = 'ball' of exploration 2";
  EXPECT_TRUE(is_refused(session, of("undo_name", "mug", 0), last));
  EXPECT_TRUE(is_refused(session, of("undo_name", "mug", 1), last)) << "another value";
  undo(session, "ball", 1);
  undo(session, "mug", 0);
  EXPECT_EQ(naming(session)["given"], "cup");
  EXPECT_TRUE(is_refused(session, of("undo_name", "mug", 0), "last is now object = 'cup'"))
      << "another page has taken it back";
  undo(session, "cup", 0);
  EXPECT_EQ(state_of(session)["explorations"], before["explorations"]);
  EXPECT_EQ(naming(session)["last"], nullptr);
  EXPECT_TRUE(is_refused(session, of("undo_name", "cup", 0), "no name"));
}

TEST_F(NamingThread, RefusesWhatIsNotThere) {
  ViewSession session(testing::hand_source(), resting());
  session.start();
  EXPECT_TRUE(is_refused(session, of("name", "cup", 3), "there is no such exploration"));
  EXPECT_TRUE(is_refused(session, of("name", "cup", 4), "there is no such exploration"));
  EXPECT_EQ(naming(session)["last"], nullptr);
}

// On a slow line the name of an exploration arrives after its end, when the next one takes place.
TEST_F(NamingThread, NamesTheExplorationThatWasMeant) {
  ViewSource source = testing::body_source(200);
  const TemporaryFolder folder;
  const auto file = GrowingRecording::begin(folder.file("session.mcap")).value();
  source.file = file.get();
  ViewSession session(std::move(source), {false, 100.0, 0.0});
  session.start();
  ASSERT_TRUE(eventually([&] { return state_of(session)["explorations"].size() == 1; }));
  command(session, R"({"command":"speed","speed":0.05})");
  command(session, R"({"command":"explore"})");
  ASSERT_TRUE(eventually([&] { return state_of(session)["live"] == true; }));
  name(session, "cup", 0);
  name(session, "ball", 1);
  EXPECT_EQ(naming(session)["given"], "ball");
  EXPECT_EQ(state_of(session)["explorations"][0]["labels"]["object"], "cup");
  undo(session, "ball", 1);
  EXPECT_EQ(naming(session)["given"], nullptr);
  session.stop();
  ASSERT_TRUE(file->finish());
  EXPECT_EQ(read_recording(folder.file("session.mcap")).value().explorations[0].labels[0].value,
            "cup");
}

// A slow page may name an exploration that was interrupted: the next one has its index.
TEST_F(NamingThread, ANameIsOfNoOtherExplorationThanThatOfThePress) {
  ViewSession session(testing::body_source(200), {false, 1.0, 0.0});
  session.start();
  const auto id_after = [&](const json& before) {
    json id;
    EXPECT_TRUE(eventually([&] {
      const json state = state_of(session);
      id = state["naming"]["id"];
      return state["live"] == true && id != before;
    }));
    return id.get<int>();
  };
  const int first = id_after(nullptr);
  name(session, "cup", first);
  command(session, R"({"command":"explore"})");
  const int second = id_after(first);
  EXPECT_EQ(state_of(session)["exploration"], 0) << "the index is used again";
  EXPECT_TRUE(is_refused(session, of("name", "mug", first), "was discarded"));
  EXPECT_TRUE(is_refused(session, of("undo_name", "cup", first), "no name"));
  EXPECT_EQ(naming(session)["given"], nullptr);
  name(session, "ball", second);
  EXPECT_EQ(naming(session)["given"], "ball");
  EXPECT_TRUE(is_refused(session, of("undo_name", "ball", first), "last is now"));
}

// A name is confirmed only where it is on the disk.
TEST_F(NamingThread, RefusesToConfirmWhatTheFileDoesNotHave) {
  const TemporaryFolder folder;
  testing::FailingFileSystem files(12, ENOSPC);
  const auto file = GrowingRecording::begin(files, folder.file("full.mcap")).value();
  ViewSource source = testing::body_source();
  source.file = file.get();
  ViewSession session(std::move(source), testing::at_once());
  session.start();
  ASSERT_TRUE(eventually([&] { return state_of(session)["explorations"].size() == 1; }));
  const std::string cup = R"({"command":"name","label":"object","value":"cup)";
  int names = 0;
  while (session.command(cup + std::to_string(names) + "\"}")) ASSERT_LT(++names, 20);
  EXPECT_TRUE(files.failed());
  EXPECT_TRUE(is_refused(session, cup + "\"}", "not on the disk"));
  EXPECT_EQ(session.command(cup + "\"}").error().kind, ErrorKind::kSystem) << "it is not refused";
  EXPECT_EQ(naming(session)["given"], "cup") << "the session continues with it";
}

}  // namespace
}  // namespace somato
