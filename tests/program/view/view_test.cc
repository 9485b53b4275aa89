#include "program/support/program_test.h"
#include "somato/recording/recording_file.h"
#include "views/support/http_client.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/support/eventually.h"

namespace somato {
namespace {

class View : public ProgramTest {
 protected:
  void record() const {
    output_of({"explore", "--body", "hardness", "--explorations", "1", "-o", "pressed.mcap"});
  }
};

TEST_F(View, RefusesWhatItCannotShow) {
  write("nothing.mcap", "nothing");
  expect_refused(
      2, {{{"view"}, {"a recording or a body"}},
          {{"view", "a.mcap", "--body", "lucs9"}, {"lucs9"}},
          {{"view", "--body", "lucs4"}, {"lucs4", "did you mean", "lucs"}},
          {{"view", "--body", "probes"}, {"only one body"}},
          {{"view", "--demo", "--body", "probes"}, {"only one body"}},
          {{"view", "a.mcap", "--demo"}, {"a.mcap", "demonstration"}},
          {{"view", "--demo", "--object", "boule"}, {"--object", "demonstration"}},
          {{"view", "--body", "lucs2", "--object", "boul"}, {"boul", "did you mean 'boule'"}},
          {{"view", "a.mcap", "--object", "boule"}, {"--object", "objects of a recording"}},
          {{"view", "a.mcap", "-o", "b.mcap"}, {"--output", "recorded again"}},
          {{"view", "nothing.mcap", "--body", "lucs2", "-o", "nothing.mcap"}, {"nothing.mcap"}},
          {{"view", "--body", "hardness", "--names", "cup,,ball"}, {"--names", "'' is no name"}},
          {{"view", "--body", "hardness", "--names", "cup,cup"}, {"--names", "there twice"}},
          {{"view", "--body", "hardness", "--names", "unknown"}, {"--names", "is no name"}},
          {{"view", "--body", "hardness", "--each", "1001"}, {"--each", "at most 1000"}},
          {{"view", "--body", "hardness", "--each", "0"}, {"--each"}},
          {{"view", "a.mcap", "--port", "65536"}, {"--port", "65535"}},
          {{"view", "a.mcap", "--address", "0.0.0.0"}, {"--address", "a single address"}},
          {{"view", "a.mcap", "--address", "192.168.7.7"}, {"--address", "--allow-others"}}});
  expect_refused(1, {{{"view", "missing.mcap"}, {"missing.mcap"}},
                     {{"view", "nothing.mcap"}, {"nothing.mcap"}}});
}

TEST_F(View, RefusesALayoutOfAnotherSkin) {
  record();
  write("pad.toml", "[layout.touch]\nplaces = [[0, 0]]\n");
  expect_refused(2,
                 {{{"view", "pressed.mcap", "--layout", "pad.toml"}, {"pad.toml:1", "'touch'"}}});
}

// The port of the address that is printed, such as http://127.0.0.1:8080/?token=...
std::uint16_t port_in(const std::string& out) {
  const std::string host = "http://127.0.0.1:";
  return static_cast<std::uint16_t>(std::stoi(out.substr(out.find(host) + host.size())));
}

void expect_pages(const std::string& out) {
  const std::uint16_t port = port_in(out);
  for (const auto& [path, type, part] :
       std::vector<std::array<std::string, 3>>{{"/", "text/html", "<!doctype html>"},
                                               {"/view.js", "text/javascript", "EventSource"},
                                               {"/view.css", "text/css", "{"}}) {
    SCOPED_TRACE(path);
    const std::string page = testing::ask(port, testing::get_request(port, path));
    EXPECT_EQ(testing::status_of(page), 200);
    EXPECT_NE(page.find("Content-Type: " + type + "; charset=utf-8\r\n"), std::string::npos);
    EXPECT_NE(testing::body_of(page).find(part), std::string::npos);
  }
  const std::string other = testing::ask(port, testing::get_request(port, "/report.html"));
  EXPECT_NE(testing::status_of(other), 200);
}

TEST_F(View, PrintsWhereItIsServesItsPagesAndEndsPolitely) {
  record();
  ProgramWorld world;
  world.before_interrupt = expect_pages;
  world.interrupt_at = "Press Ctrl-C to close the view.";
  for (const Words& words : {Words{"view", "pressed.mcap"}, Words{"view", "--body", "texture"}}) {
    const ProgramRun done = run(words, world);
    if (done.exit_code == 2 && has_no_pages(done)) {
      GTEST_SKIP() << "the program was built without npm";
    }
    EXPECT_EQ(done.exit_code, 0) << done.err;
    EXPECT_EQ(done.signal, 0);
    EXPECT_TRUE(done.out.starts_with("Open http://127.0.0.1:")) << done.out;
    EXPECT_NE(done.out.find("/?token="), std::string::npos);
    EXPECT_TRUE(done.out.ends_with("The view is closed.\n")) << done.out;
  }
}

// The token of the same address.
std::string token_in(const std::string& out) {
  const std::string before = "?token=";
  const std::size_t begin = out.find(before) + before.size();
  return out.substr(begin, out.find('\n', begin) - begin);
}

void expect_done(const std::string& out, const std::string& command) {
  const std::uint16_t port = port_in(out);
  const std::string answer = testing::ask(
      port, testing::post_request(port, "/api/command?token=" + token_in(out), command));
  EXPECT_EQ(testing::status_of(answer), 200) << answer;
}

// Has the body explore, fast, and waits until it has.
void explore_while_viewed(const std::string& out) {
  const std::uint16_t port = port_in(out);
  expect_done(out, R"({"command":"speed","speed":100})");
  expect_done(out, R"({"command":"explore"})");
  const std::string state = testing::get_request(port, "/api/state?token=" + token_in(out));
  EXPECT_TRUE(testing::eventually([&] {
    return testing::ask(port, state).find(R"({"index":0)") != std::string::npos;
  })) << "the body does not explore";
}

// The same writer as that of `somato explore`, and the same exploration.
TEST_F(View, SavesWhatABodyExplores) {
  record();
  ProgramWorld world;
  world.interrupt_at = "Press Ctrl-C to close the view.";
  const Words words{"view", "--body", "hardness", "-o", "live.mcap"};
  const ProgramRun nothing = run(words, world);
  if (has_no_pages(nothing)) {
    GTEST_SKIP() << "the program was built without npm";
  }
  EXPECT_NE(nothing.out.find("live.mcap: not written"), std::string::npos) << nothing.out;
  EXPECT_FALSE(read_recording(path("live.mcap")));
  world.before_interrupt = explore_while_viewed;
  const ProgramRun done = run(words, world);
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_NE(done.out.find("1 exploration saved in live.mcap\n"), std::string::npos) << done.out;
  const auto live = read_recording(path("live.mcap"));
  ASSERT_TRUE(live);
  ASSERT_EQ(live->explorations.size(), 1U);
  EXPECT_EQ(live->explorations[0], read_recording(path("pressed.mcap"))->explorations[0]);
}

TEST_F(View, RefusesPicturesThatItCannotDraw) {
  record();
  expect_refused(
      2, {{{"view", "pressed.mcap", "--render", "out.gif"}, {"out.gif", ".webm"}},
          {{"view", "pressed.mcap", "--exploration", "2"}, {"--exploration"}},
          {{"view", "--body", "lucs2", "--render", "out.png"}, {"--body", "--render"}},
          {{"view", "--demo", "--render", "out.png", "-o", "out.mcap"}, {"--output", "--render"}},
          {{"view", "--demo", "--body", "hardness", "--exploration", "99", "--render", "out.png"},
           {"--exploration", "the demonstration has 8 explorations"}},
          {{"view", "pressed.mcap", "--exploration", "9", "--render", "out.png"},
           {"--exploration", "8 explorations"}}});
}

TEST_F(View, SaysWhichProgramsPicturesRequire) {
  record();
  ProgramWorld world;
  world.environment = {{"PATH", path("")}};
  expect_refused(1, {"view", "pressed.mcap", "--render", "out.png"},
                 {"chromium", "apt-get install chromium"}, world);
  expect_refused(1, {"view", "--demo", "--body", "hardness", "--render", "out.png"},
                 {"chromium", "apt-get install chromium"}, world);
}

// A page that leads to the address: other users can read the arguments of xdg-open.
TEST_F(View, OpensABrowserWithoutTheTokenInItsArguments) {
  write("xdg-open", "#!/bin/sh\ncat \"$1\" > opened.part\nmv opened.part opened.html\n");
  std::filesystem::permissions(path("xdg-open"), std::filesystem::perms::owner_all);
  ProgramWorld world;
  world.environment = {{"PATH", path("") + ":/usr/bin:/bin"}};
  world.interrupt_at = "Press Ctrl-C to close the view.";
  std::string address;
  world.before_interrupt = [&](const std::string& said) {
    address = said.substr(5, said.find('\n') - 5);
    EXPECT_TRUE(testing::eventually([&] { return std::filesystem::exists(path("opened.html")); }));
  };
  const ProgramRun done = run({"view", "--demo", "--body", "hardness", "--open"}, world);
  if (has_no_pages(done)) {
    GTEST_SKIP() << "the program was built without npm";
  }
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_NE(read("opened.html").find("url=" + address + "\""), std::string::npos) << address;
}

TEST_F(View, SaysThatNoBrowserCanBeStarted) {
  ProgramWorld world;
  world.environment = {{"PATH", path("")}};
  world.interrupt_at = "Press Ctrl-C to close the view.";
  const ProgramRun done = run({"view", "--body", "hardness", "--open"}, world);
  if (has_no_pages(done)) {
    GTEST_SKIP() << "the program was built without npm";
  }
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_NE(done.err.find("xdg-open: no browser can be started"), std::string::npos) << done.err;
  EXPECT_NE(done.err.find("open the address in a browser"), std::string::npos) << done.err;
}

TEST_F(View, RefusesObjectsThatItCannotRead) {
  record();
  write("objects.toml", "[object]\ncup = { shape = \"cup\" }\n");
  expect_refused(1, {{{"view", "pressed.mcap", "--objects", "missing.toml"}, {"missing.toml"}}});
  expect_refused(2, {{{"view", "pressed.mcap", "--objects", "objects.toml"}, {"objects.toml"}}});
}

TEST_F(View, TakesASystemThatDoesNotFit) {
  write_data();
  expect_refused(1, {{{"view", "--body", "texture", "--model", "data.csv"}, {"data.csv"}}});
}

}  // namespace
}  // namespace somato
