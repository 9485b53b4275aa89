// Each way into the program, with a device: nothing is sent to its servos before a person's
// command.

#include "base/support/places.h"
#include "program/support/emulation_test.h"
#include "program/support/program_test.h"
#include "views/support/http_client.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <memory>
#include <regex>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/support/eventually.h"

namespace somato {
namespace {

// A serial port that counts what is sent to it, and never answers.
class CountingPort {
 public:
  CountingPort() {
    std::array<char, 64> name{};
    int device = -1;
    if (openpty(&host_, &device, name.data(), nullptr, nullptr) != 0) std::abort();
    termios raw{};
    tcgetattr(device, &raw);
    cfmakeraw(&raw);
    tcsetattr(device, TCSANOW, &raw);
    ::close(device);
    path_ = name.data();
    thread_ = std::thread([this] { count(); });
  }
  CountingPort(const CountingPort&) = delete;
  CountingPort(CountingPort&&) = delete;
  CountingPort& operator=(const CountingPort&) = delete;
  CountingPort& operator=(CountingPort&&) = delete;
  ~CountingPort() {
    ends_ = true;
    thread_.join();
    ::close(host_);
  }

  const std::string& path() const { return path_; }

  // All bytes so far, once the program that might have sent them has ended.
  std::size_t bytes() const { return bytes_; }

 private:
  void count() {
    std::array<char, 256> received{};
    while (!ends_) {
      pollfd input{host_, POLLIN, 0};
      poll(&input, 1, 5);
      if ((input.revents & POLLIN) == 0) continue;  // it is not open, or nothing has come
      const ssize_t count = ::read(host_, received.data(), received.size());
      if (count > 0) bytes_ += static_cast<std::size_t>(count);
    }
  }

  int host_ = -1;
  std::string path_;
  std::atomic<std::size_t> bytes_ = 0;
  std::atomic<bool> ends_ = false;
  std::thread thread_;
};

// The address that a view prints, such as http://127.0.0.1:8080/?token=...
struct Address {
  explicit Address(const std::string& said) {
    std::smatch found;
    const std::regex address("http://127\\.0\\.0\\.1:([0-9]+)/\\?token=([^\\s]+)");
    if (!std::regex_search(said, found, address)) return;
    port = static_cast<std::uint16_t>(std::stoi(found[1]));
    token = found[2];
  }

  std::string with_token(const std::string& path) const { return path + "?token=" + token; }

  std::string command(const std::string& json) const {
    return testing::ask(port, testing::post_request(port, with_token("/api/command"), json));
  }

  std::string state() const {
    return testing::body_of(
        testing::ask(port, testing::get_request(port, with_token("/api/state"))));
  }

  // A page that is opened.
  std::unique_ptr<testing::HttpClient> page() const {
    auto page = std::make_unique<testing::HttpClient>(port);
    page->send(testing::get_request(port, with_token("/api/events")));
    page->receive_until("event: state");
    return page;
  }

  std::uint16_t port = 0;
  std::string token;
};

class Motion : public EmulationTest {
 protected:
  Motion() {
    write("hand.toml",
          "name = \"one finger\"\nexplore = \"holding\"\nduration = 0.2\n"
          "[servos]\nbus = \"sts\"\nport = \"" +
              port_.path() +
              "\"\n[servo.finger]\nchannel = 1\nzero = 2048\nscale = 11.4\nleast = 0\nmost = 90\n"
              "[sensor.joints]\nunit = \"deg\"\nfrom = \"servos\"\nservos = [\"finger\"]\n");
    write(
        "balls.toml",
        "[object]\nball = { shape = \"sphere\", diameter = 72, material = \"plastic\" }\n"
        "cube = { shape = \"block\", width = 50, depth = 50, height = 50, material = \"wood\" }\n");
  }

  static Words with_hand(Words words) {
    words.insert(words.end(), {"--device", "hand.toml", "--objects", "balls.toml"});
    return words;
  }

  void train_model() const {
    output_of({"explore", "--body", "hardness", "--explorations", "1", "-o", "felt.mcap"});
    write("study.toml",
          "[study]\nname = 'hardness'\nlabel = 'material'\nseeds = 1\n"
          "[module.stick]\ntype = 'channel'\nchannel = 'potentiometer'\n"
          "[module.end]\ntype = 'last'\ninput = 'stick'\n"
          "[module.map]\ntype = 'som'\ninput = 'end'\nrows = 1\ncolumns = 4\n"
          "iterations = 200\n");
    output_of({"run", "study.toml", "--data", "felt.mcap", "--out", "out"});
  }

  // A person has placed everything already.
  ProgramWorld placed() const {
    ProgramWorld world;
    write("enter", std::string(20, '\n'));
    world.input_from = path("enter");
    return world;
  }

  ProgramWorld viewing(const std::string& at, std::function<void(const Address&)> work) const {
    ProgramWorld world = placed();
    world.interrupt_at = at;
    world.before_interrupt = [work = std::move(work)](const std::string& said) {
      work(Address(said));
    };
    return world;
  }

  // Pages that are opened, reloaded and closed, and all that they can send but Start.
  void use_without_start(const Address& address) const {
    const auto first = address.page();
    for (int i = 0; i < 3; ++i) {
      const auto second = address.page();
      EXPECT_NE(address.state().find("\"awaits_start\":true"), std::string::npos);
    }
    start_from_elsewhere(address);
    for (const std::string command :
         {R"({"command":"play"})", R"({"command":"step","frames":1})", R"({"command":"pause"})",
          R"({"command":"thing","name":"cube"})", R"({"command":"speed","speed":100})",
          R"({"command":"placement","x":1,"y":1,"turn":1})", R"({"command":"train"})",
          R"({"command":"dismiss"})", R"({"command":"plan","each":2})"}) {
      address.command(command);
      address.state();
    }
    const auto last = address.page();
    EXPECT_NE(address.state().find("\"awaits_start\":true"), std::string::npos);
    EXPECT_EQ(port_.bytes(), 0U);
  }

  // Start without the token of the page, and from a page of another origin.
  static void start_from_elsewhere(const Address& address) {
    const std::string start = R"({"command":"explore"})";
    const auto status = [&](const std::string& target, const std::vector<std::string>& headers) {
      return testing::status_of(
          testing::ask(address.port, testing::post_request(address.port, target, start, headers)));
    };
    EXPECT_EQ(status("/api/command", {}), 403);
    EXPECT_EQ(status("/api/command?token=0123456789abcdef", {}), 403);
    // A foreign origin beside that of the page.
    EXPECT_EQ(status(address.with_token("/api/command"), {"Origin: http://example.org"}), 403);
  }

  // Then one press moves it.
  void start(const Address& address) const {
    EXPECT_EQ(testing::status_of(address.command(R"({"command":"explore"})")), 200);
    EXPECT_TRUE(moved());
  }

  bool moved() const {
    return testing::eventually([&] { return port_.bytes() > 0; });
  }

  CountingPort port_;
};

constexpr const char* kViewIsOpen = "Press Ctrl-C to close the view.";
constexpr const char* kLiveIsOpen = "Press Ctrl-C to end.";

TEST_F(Motion, AViewWithoutAPageMovesNothing) {
  const auto done = run(with_hand({"view"}), viewing(kViewIsOpen, [](const Address&) {}));
  if (has_no_pages(done)) GTEST_SKIP() << "the program was built without npm";
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(port_.bytes(), 0U);
}

TEST_F(Motion, AViewThatIsOpenedMovesNothing) {
  const auto use = [&](const Address& address) { use_without_start(address); };
  const auto done = run(with_hand({"view"}), viewing(kViewIsOpen, use));
  if (has_no_pages(done)) GTEST_SKIP() << "the program was built without npm";
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(port_.bytes(), 0U);
}

// For a simulated body of that name the view trains a system, on explorations of its own.
TEST_F(Motion, ADeviceOfAKnownBodyTrainsNothingInTheBackground) {
  const CountingPort frames;
  std::string text = bytes_of(source_path("devices/hardness.toml"));
  text.replace(text.find("/dev/ttyUSB0"), 12, port_.path());
  text.replace(text.find("/dev/ttyACM0"), 12, frames.path());
  write("probe.toml", text);
  const auto done =
      run({"view", "--device", "probe.toml"}, viewing(kViewIsOpen, [&](auto& address) {
            use_without_start(address);
            EXPECT_NE(address.state().find("\"training\":false"), std::string::npos);
          }));
  if (has_no_pages(done)) GTEST_SKIP() << "the program was built without npm";
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(port_.bytes(), 0U);
}

TEST_F(Motion, APressOfStartMovesIt) {
  const auto done = run(with_hand({"view"}), viewing(kViewIsOpen, [&](const Address& address) {
                          const auto page = address.page();
                          EXPECT_EQ(port_.bytes(), 0U);
                          start(address);
                        }));
  if (has_no_pages(done)) GTEST_SKIP() << "the program was built without npm";
}

TEST_F(Motion, ReadingsInAViewBeginWithAPressOfStart) {
  train_model();
  const auto done = run(with_hand({"live", "--model", "out/system.somato", "--view"}),
                        viewing(kLiveIsOpen, [&](const Address& address) {
                          use_without_start(address);
                          start(address);
                        }));
  if (has_no_pages(done)) GTEST_SKIP() << "the program was built without npm";
}

// These say that the hand explores, or calibrates.
TEST_F(Motion, CommandsThatSaySoMoveIt) {
  train_model();
  for (const Words& words :
       {with_hand({"explore", "--explorations", "1", "-o", "touched.mcap"}),
        with_hand({"live", "--model", "out/system.somato", "--explorations", "1"}),
        Words{"device", "calibrate", "hand.toml", "--servo", "finger"}}) {
    const std::size_t before = port_.bytes();
    EXPECT_NE(run(words, placed()).exit_code, 0) << "no servo answers";
    EXPECT_GT(port_.bytes(), before) << words.front();
  }
}

// They talk to the servos: each is afterwards where it was, or still off.
TEST_F(Motion, CheckAndMonitorMoveNothing) {
  const std::regex place("servo \"stick\": channel [0-9]+, (at [^,\n]*|off)");
  for (const std::string& bus : names_of_buses()) {
    SCOPED_TRACE(bus);
    with_emulation({"--body", "hardness", "--bus", bus}, [&] {
      std::string first;
      for (int i = 0; i < 2; ++i) {
        const std::string checked = output_of({"device", "check", "d.toml"});
        std::smatch found;
        ASSERT_TRUE(std::regex_search(checked, found, place)) << checked;
        if (i == 0) first = found[0];
        EXPECT_EQ(found[0], first);
        if (i == 0) output_of({"device", "monitor", "d.toml", "--seconds", "1"});
      }
    });
  }
}

// A command that takes a device is to be tried above.
TEST_F(Motion, NoOtherCommandTakesADevice) {
  const std::string reference = output_of({"reference"});
  std::set<std::string> commands;
  std::string command;
  for (std::size_t begin = 0; begin < reference.size();) {
    const std::size_t end = std::min(reference.find('\n', begin), reference.size());
    const std::string line = reference.substr(begin, end - begin);
    if (line.starts_with("### `somato ")) command = line.substr(12, line.find(' ', 12) - 12);
    if (line.starts_with("## ")) command.clear();
    const bool takes = line.starts_with("| `--device`") || command == "device";
    if (takes && !command.empty()) commands.insert(command);
    begin = end + 1;
  }
  // An emulation has no device, but is one.
  EXPECT_EQ(commands, (std::set<std::string>{"device", "emulate", "explore", "live", "view"}));
  expect_refused(2, {{{"reproduce", "--device", "hand.toml", "--out", "out"}, {"--device"}},
                     {{"view", "--demo", "--device", "hand.toml"}, {"--device", "demonstration"}},
                     {{"view", "a.mcap", "--render", "a.png", "--device", "hand.toml"},
                      {"--device", "--render"}}});
  EXPECT_EQ(port_.bytes(), 0U);
}

}  // namespace
}  // namespace somato
