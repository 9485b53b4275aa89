#include "terminal/headless_browser.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cctype>
#include <chrono>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "terminal/base64.h"

namespace somato::program {
namespace {

using SortedJson = nlohmann::json;

constexpr auto kAnswerTime = std::chrono::minutes(1);

// Chromium reads commands from descriptor 3 and answers to descriptor 4. The body in three
// dimensions is drawn in software, as a machine without a display has no other way; Chromium paints
// the page itself, which is faster than with the same program. For the superuser it has no sandbox.
Result<ChildProcess> start(const ScratchFolder& profile) {
  std::vector<std::string> words{"",
                                 "--headless=new",
                                 "--remote-debugging-pipe",
                                 "--user-data-dir=" + profile.path(),
                                 "--no-first-run",
                                 "--disable-extensions",
                                 "--disable-background-networking",
                                 "--hide-scrollbars",
                                 "--enable-unsafe-swiftshader"};
  if (::geteuid() == 0) words.emplace_back("--no-sandbox");
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
    words.front() = name;
    if (auto process = ChildProcess::start(words, {3, 4})) return process;
  }
  return fail(ErrorKind::kSystem, "pictures without a window require the browser Chromium",
              "chromium", "install it, on Debian with: sudo apt-get install chromium");
}

}  // namespace

// Other characters than these have a meaning in addresses.
std::string file_address(const std::string& path) {
  std::string address = "file://";
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain =
        std::isalnum(byte) != 0 || std::string_view("/-._~").find(c) != std::string_view::npos;
    address += is_plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return address;
}

Result<HeadlessBrowser> HeadlessBrowser::open(const std::string& address, std::size_t width,
                                              std::size_t height) {
  SOMATO_TRY(auto profile, ScratchFolder::create());
  SOMATO_TRY(auto process, start(profile));
  HeadlessBrowser browser(std::move(profile), std::move(process));
  SOMATO_TRY_VOID(browser.attach());
  SOMATO_TRY_VOID(browser.call(
      "Emulation.setDeviceMetricsOverride",
      {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", false}}));
  // Nothing moves between the moments.
  const SortedJson still{{"name", "prefers-reduced-motion"}, {"value", "reduce"}};
  SOMATO_TRY_VOID(browser.call("Emulation.setEmulatedMedia", {{"features", {still}}}));
  SOMATO_TRY_VOID(browser.go_to(address));
  return browser;
}

Result<void> HeadlessBrowser::go_to(const std::string& address) {
  SOMATO_TRY_VOID(call("Page.navigate", {{"url", address}}));
  return {};
}

Result<void> HeadlessBrowser::attach() {
  SOMATO_TRY(const auto target, call("Target.createTarget", {{"url", "about:blank"}}));
  SOMATO_TRY(const auto attached,
             call("Target.attachToTarget", {{"targetId", target["targetId"]}, {"flatten", true}}));
  session_ = attached["sessionId"].get<std::string>();
  return {};
}

Result<void> HeadlessBrowser::wait_until(const std::string& condition) {
  const std::string expression = fmt::format(
      "new Promise((done) => {{ const drawn = (n) => n === 0 ? done(true) : "
      "requestAnimationFrame(() => drawn(n - 1)); const look = () => ({}) ? drawn(4) : "
      "setTimeout(look, 5); look(); }})",
      condition);
  SOMATO_TRY_VOID(value_of(expression));
  return {};
}

Result<SortedJson> HeadlessBrowser::value_of(const std::string& expression) {
  return call("Runtime.evaluate",
              {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}})
      .and_then([](const SortedJson& answer) -> Result<SortedJson> {
        if (!answer.contains("exceptionDetails")) {
          return answer["result"].value("value", SortedJson());
        }
        return fail(ErrorKind::kSystem, "the page failed: " + answer["exceptionDetails"].dump(),
                    "chromium");
      });
}

Result<std::string> HeadlessBrowser::printed(double width, double height) {
  constexpr double kInch = 25.4;  // mm
  return call("Page.printToPDF", {{"paperWidth", width / kInch},
                                  {"paperHeight", height / kInch},
                                  {"marginTop", 0},
                                  {"marginBottom", 0},
                                  {"marginLeft", 0},
                                  {"marginRight", 0},
                                  {"printBackground", true}})
      .map([](const SortedJson& answer) {
        return from_base64(answer["data"].get_ref<const std::string&>());
      });
}

// The drawing of a large change lags behind the page.
Result<std::string> HeadlessBrowser::settled_picture() {
  Result<std::string> before = picture();
  while (before) {
    Result<std::string> now = picture();
    if (!now || now->compare(*before) == 0) return now;
    before = std::move(now);
  }
  return before;
}

Result<std::string> HeadlessBrowser::picture() {
  return call("Page.captureScreenshot", {{"format", "png"}, {"optimizeForSpeed", true}})
      .map([](const SortedJson& answer) {
        return from_base64(answer["data"].get_ref<const std::string&>());
      });
}

Result<SortedJson> HeadlessBrowser::call(const std::string& method, const SortedJson& parameters) {
  const int id = ++calls_;
  SortedJson message{{"id", id}, {"method", method}, {"params", parameters}};
  if (!session_.empty()) message["sessionId"] = session_;
  SOMATO_TRY_VOID(process_.send(message.dump() + '\0'));
  for (;;) {
    SOMATO_TRY(auto answer, next_message());
    if (answer.value("id", 0) != id) continue;
    if (answer.contains("result")) return std::move(answer["result"]);
    return fail(ErrorKind::kSystem, fmt::format("{} failed: {}", method, answer["error"].dump()),
                "chromium");
  }
}

// Messages end in a zero.
Result<SortedJson> HeadlessBrowser::next_message() {
  std::size_t searched = 0;
  for (;;) {
    const std::size_t end = received_.find('\0', searched);
    if (end != std::string::npos) {
      SortedJson message = SortedJson::parse(received_.substr(0, end), nullptr, false);
      received_.erase(0, end + 1);
      if (message.is_object()) return message;
      return fail(ErrorKind::kSystem, "it sent a message that is not JSON", "chromium");
    }
    searched = received_.size();
    SOMATO_TRY(const auto bytes, process_.receive(kAnswerTime));
    if (bytes.empty()) {
      return fail(ErrorKind::kSystem, "the browser has ended before its time", "chromium",
                  "start it by hand to see its message");
    }
    received_ += bytes;
  }
}

}  // namespace somato::program
