#include "views/live/view_server.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cerrno>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/support/failing_file_system.h"
#include "base/support/json_schema.h"
#include "base/support/temporary_folder.h"
#include "views/http/hostile_requests.h"
#include "views/live/sessions.h"
#include "views/live/view_systems.h"
#include "views/live/viewing.h"

namespace somato {
namespace {

using nlohmann::json;
using testing::ask;
using testing::body_of;
using testing::get_request;
using testing::HttpClient;
using testing::post_request;
using testing::status_of;
using testing::text_fits_schema;
using testing::Viewing;

// Paused at its first frame, so that each seek brings one frame more.
class ServerThread : public ::testing::Test {
 protected:
  Viewing viewing_{testing::hand_source(), {true, 1.0, 0.0}};
};

// Listens to events for as long as it lives.
class Listener {
 public:
  explicit Listener(const Viewing& viewing) : client_(viewing.port()) {
    client_.send(get_request(viewing.port(), viewing.with_token("/api/events")));
  }
  std::string until(const std::string& text) const { return client_.receive_until(text); }

 private:
  HttpClient client_;
};

TEST_F(ServerThread, RefusesEachHostileRequestWhileAGoodOneGetsFrames) {
  const auto requests = testing::HostileRequests(viewing_.port(), viewing_.token()).all();
  EXPECT_GE(requests.size(), 100U);
  const Listener good(viewing_);
  EXPECT_NE(good.until("event: frame").find("event: state"), std::string::npos);
  ASSERT_TRUE(viewing_.session().command(R"({"command":"pause"})"));
  std::size_t frame = 0;
  for (const testing::HostileRequest& hostile : requests) {
    SCOPED_TRACE(hostile.name);
    const HttpClient client(viewing_.port());
    client.send(hostile.bytes);
    if (hostile.ends) client.finish();
    const std::string response = client.receive();
    EXPECT_EQ(status_of(response), hostile.status) << response.substr(0, 400);
    EXPECT_NE(response.find("Content-Security-Policy: default-src 'none'"), std::string::npos);
    EXPECT_FALSE(body_of(response).empty());
    frame = 1 - frame;
    ASSERT_TRUE(viewing_.session().command(
        fmt::format(R"({{"command":"seek","exploration":0,"frame":{}}})", frame)));
    const std::string event = fmt::format(R"({{"exploration":0,"frame":{},)", frame);
    EXPECT_NE(good.until(event).find(event), std::string::npos);
  }
}

TEST_F(ServerThread, ServesItsPageWithoutTokenAndAllElseWithOne) {
  const std::string page = ask(viewing_.port(), get_request(viewing_.port(), "/"));
  EXPECT_EQ(status_of(page), 200);
  EXPECT_EQ(body_of(page), "<p>page</p>");
  const std::string state = viewing_.get("/api/state");
  EXPECT_EQ(status_of(state), 200);
  EXPECT_EQ(json::parse(body_of(state))["name"], "hand.mcap");
  EXPECT_EQ(body_of(viewing_.get("/api/scene")), "null");
  const std::string strips = viewing_.get("/api/strips");
  EXPECT_EQ(status_of(strips), 200);
  EXPECT_EQ(json::parse(body_of(strips))["exploration"], 0);
  const std::string by_header =
      ask(viewing_.port(),
          get_request(viewing_.port(), "/api/state", {"X-Somato-Token: " + viewing_.token()}));
  EXPECT_EQ(status_of(by_header), 200);
}

TEST_F(ServerThread, AnswersToLocalhostToo) {
  const std::string request = fmt::format("GET {} HTTP/1.1\r\nHost: localhost:{}\r\n\r\n",
                                          viewing_.with_token("/api/state"), viewing_.port());
  EXPECT_EQ(status_of(ask(viewing_.port(), request)), 200);
}

TEST_F(ServerThread, AnswersHeadWithoutABody) {
  const std::string request =
      fmt::format("HEAD / HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n\r\n", viewing_.port());
  const std::string response = ask(viewing_.port(), request);
  EXPECT_EQ(status_of(response), 200);
  EXPECT_NE(response.find("Content-Length: 11"), std::string::npos);
  EXPECT_EQ(body_of(response), "");
}

TEST_F(ServerThread, RefusesEventsWithoutTheirBody) {
  const std::string request = fmt::format("HEAD {} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n\r\n",
                                          viewing_.with_token("/api/events"), viewing_.port());
  EXPECT_EQ(status_of(ask(viewing_.port(), request)), 405);
}

TEST_F(ServerThread, SendsHeadersThatForbidOtherOrigins) {
  const std::string response = ask(viewing_.port(), get_request(viewing_.port(), "/"));
  for (const char* header :
       {"Content-Security-Policy: default-src 'none'; script-src 'self'; style-src 'self'",
        "frame-ancestors 'none'", "X-Content-Type-Options: nosniff", "Referrer-Policy: no-referrer",
        "Cache-Control: no-store", "Cross-Origin-Opener-Policy: same-origin",
        "Cross-Origin-Resource-Policy: same-origin"}) {
    EXPECT_NE(response.find(header), std::string::npos) << header;
  }
  EXPECT_EQ(response.find("Access-Control"), std::string::npos);
}

TEST_F(ServerThread, DoesWhatACommandSays) {
  const std::string done = viewing_.command(R"({"command":"seek","exploration":1,"frame":1})");
  EXPECT_EQ(status_of(done), 200);
  EXPECT_EQ(json::parse(body_of(done))["ok"], true);
  EXPECT_EQ(json::parse(body_of(viewing_.get("/api/state")))["exploration"], 1);
  const std::string refused = viewing_.command(R"({"command":"seek","exploration":9,"frame":1})");
  EXPECT_EQ(json::parse(body_of(refused))["error"], "the recording has 3 explorations");
}

TEST_F(ServerThread, TakesNoMoreViewersThanItMay) {
  std::vector<std::unique_ptr<Listener>> listeners;
  for (int i = 0; i < 16; ++i) {
    listeners.push_back(std::make_unique<Listener>(viewing_));
    ASSERT_NE(listeners.back()->until("event: state"), "");
  }
  EXPECT_EQ(status_of(viewing_.get("/api/events")), 503);
  EXPECT_EQ(status_of(viewing_.get("/api/state")), 200);
}

// The server waits for the slow ones for longer than the test lasts: 63 of them, beside the good
// one.
TEST(ServerStartThread, SurvivesManyWhoAreSlow) {
  Viewing viewing(testing::hand_source(), {true, 1.0, 0.0}, 600'000);
  const Listener good(viewing);
  ASSERT_NE(good.until("event: frame"), "");
  ASSERT_TRUE(viewing.session().command(R"({"command":"pause"})"));
  std::vector<std::unique_ptr<HttpClient>> slow;
  for (int i = 0; i < 80; ++i) {
    slow.push_back(std::make_unique<HttpClient>(viewing.port()));
    slow.back()->send("GET / HTTP/1.1\r\nHost: ");
  }
  ASSERT_TRUE(viewing.session().command(R"({"command":"seek","exploration":0,"frame":1})"));
  const std::string event = R"({"exploration":0,"frame":1,)";
  EXPECT_NE(good.until(event).find(event), std::string::npos);
  // There is no room for the last ones; when the others leave, new ones come in again.
  for (std::size_t i = 63; i < slow.size(); ++i) {
    const std::string response = slow[i]->receive();
    EXPECT_EQ(status_of(response), 503) << i;
    EXPECT_NE(response.find("X-Frame-Options: DENY"), std::string::npos);
  }
  slow.clear();
  EXPECT_TRUE(testing::eventually([&] { return status_of(viewing.get("/api/state")) == 200; }));
}

// Checks all whole events of a stream by their schemas; returns their names.
std::set<std::string> checked_events(std::string_view stream) {
  constexpr std::string_view kEvent = "event: ";
  constexpr std::string_view kData = "\ndata: ";
  std::set<std::string> names;
  std::size_t end = 0;
  while (true) {
    const std::size_t event = stream.find(kEvent, end);
    const std::size_t data = stream.find(kData, event);
    end = stream.find("\n\n", data);
    if (end == std::string_view::npos) return names;
    const std::size_t begin = data + kData.size();
    const std::string name(stream.substr(event + kEvent.size(), data - event - kEvent.size()));
    EXPECT_TRUE(text_fits_schema(stream.substr(begin, end - begin),
                                 "view.json#/$defs/Events/properties/" + name))
        << name;
    names.insert(name);
  }
}

TEST_F(ServerThread, SaysThatItIsStillThere) {
  const Listener listener(viewing_);
  const std::string stream = listener.until("event: ping\ndata: {}\n\n");
  EXPECT_EQ(checked_events(stream), (std::set<std::string>{"frame", "ping", "scene", "state"}));
}

std::size_t count_of(const std::string& part, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

// A viewer behind any buffers: what it has not acknowledged is all that is under way.
TEST_F(ServerThread, SendsTheLatestFrameOnceTheOneBeforeIsAcknowledged) {
  const HttpClient viewer(viewing_.port());
  viewer.send(get_request(viewing_.port(), viewing_.with_token("/api/events?acknowledge=1")));
  const std::string question = R"("number":1,)";
  std::string stream = viewer.receive_until(question);
  ASSERT_TRUE(viewing_.session().command(R"({"command":"pause"})"));
  for (int frame = 0; frame < 50; ++frame) {
    ASSERT_TRUE(viewing_.session().command(
        fmt::format(R"({{"command":"seek","exploration":1,"frame":{}}})", frame % 2)));
  }
  while (count_of(question, stream) < 3) stream += viewer.receive_until(question);
  EXPECT_EQ(count_of("event: frame", stream), 1U);
  EXPECT_EQ(count_of("event: state", stream), 1U);
  const auto seen = [&](const std::string& query) {
    return ask(viewing_.port(),
               post_request(viewing_.port(), viewing_.with_token("/api/seen" + query), ""));
  };
  const std::string viewer_number = stream.substr(stream.find(R"("viewer":)") + 9, 1);
  EXPECT_EQ(status_of(seen("?viewer=" + viewer_number + "&number=1")), 200);
  const std::string latest = viewer.receive_until(R"("number":2,)");
  EXPECT_EQ(count_of("event: frame", latest), 1U);
  EXPECT_NE(latest.find(R"(event: frame)"
                        "\n"
                        R"(data: {"exploration":1,"frame":1,)"),
            std::string::npos);
  EXPECT_EQ(checked_events(stream + latest),
            (std::set<std::string>{"frame", "ping", "scene", "state"}));
  EXPECT_EQ(status_of(seen("?viewer=99&number=1")), 400);
  EXPECT_EQ(status_of(seen("?viewer=1")), 400);
  EXPECT_EQ(status_of(viewing_.get("/api/seen?viewer=1&number=1")), 405);
}

ViewSource source_that_has_learned() {
  ViewSource source = testing::hand_source(6);
  source.systems = {testing::view_system(testing::crossed_system())};
  source.systems[0].trained = testing::trained_model(testing::crossed_system(), source.recording);
  source.system = 0;
  return source;
}

TEST(ServerStartThread, AnswersAsItsSchemasSay) {
  const Viewing viewing(source_that_has_learned(), {true, 1.0, 0.0});
  for (const auto& [name, query] :
       std::vector<std::pair<std::string, std::string>>{{"state", ""},
                                                        {"scene", ""},
                                                        {"strips", ""},
                                                        {"neuron", "?map=map&neuron=5"},
                                                        {"taxel", "?element=2"}}) {
    const std::string answer = viewing.get("/api/" + name + query);
    EXPECT_EQ(status_of(answer), 200) << name;
    EXPECT_TRUE(text_fits_schema(body_of(answer), "view.json#/$defs/Answers/properties/" + name))
        << name;
  }
  EXPECT_TRUE(
      text_fits_schema(body_of(viewing.get("/api/taxel?element=99")), "view.json#/$defs/Refusal"));
  EXPECT_TRUE(text_fits_schema(body_of(viewing.command(R"({"command":"fly"})")),
                               "view.json#/$defs/Refusal"));
  EXPECT_TRUE(text_fits_schema(body_of(viewing.command(R"({"command":"pause"})")),
                               "view.json#/$defs/Done"));
}

// The file fails with one of the names, which the session has nevertheless.
TEST(ServerUnsavedThread, AChangeThatIsNotSavedIsNotRefused) {
  const TemporaryFolder folder;
  testing::FailingFileSystem files(12, ENOSPC);
  const auto file = GrowingRecording::begin(files, folder.file("full.mcap")).value();
  ViewSource source = testing::body_source();
  source.file = file.get();
  Viewing viewing(std::move(source));
  ASSERT_TRUE(testing::eventually(
      [&] { return testing::state_of(viewing.session())["explorations"].size() == 1; }));
  json answer;
  for (int i = 0; i < 20 && !answer.contains("error"); ++i) {
    const json name{
        {"command", "name"}, {"label", "object"}, {"value", std::to_string(i)}, {"id", 0}};
    answer = json::parse(body_of(viewing.command(name.dump())));
  }
  EXPECT_EQ(answer["unsaved"], true) << answer;
  EXPECT_TRUE(text_fits_schema(answer.dump(), "view.json#/$defs/Refusal"));
  const std::string refused = body_of(viewing.command(R"({"command":"fly"})"));
  EXPECT_FALSE(json::parse(refused).contains("unsaved"));
}

TEST(ServerStartThread, MakesATokenOfItsOwn) {
  const Viewing one(testing::hand_source());
  const Viewing other(testing::hand_source());
  EXPECT_EQ(one.token().size(), 32U);
  EXPECT_NE(one.token(), other.token());
  EXPECT_NE(one.port(), other.port());
}

TEST(ServerStartThread, RefusesAnAddressThatIsNone) {
  ViewSession session(testing::hand_source(), testing::at_once());
  ViewServerSettings settings;
  settings.address = "localhost";
  const auto server = ViewServer::start(session, {}, settings);
  ASSERT_FALSE(server);
  EXPECT_EQ(server.error().kind, ErrorKind::kUsage);
}

TEST(ServerStartThread, RefusesAPortThatIsTaken) {
  const Viewing first(testing::hand_source());
  ViewSession session(testing::hand_source(), testing::at_once());
  ViewServerSettings settings;
  settings.port = first.port();
  const auto server = ViewServer::start(session, {}, settings);
  ASSERT_FALSE(server);
  EXPECT_EQ(server.error().kind, ErrorKind::kSystem);
}

}  // namespace
}  // namespace somato
