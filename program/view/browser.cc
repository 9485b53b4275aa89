#include "view/browser.h"

#include <fmt/format.h>

#include <utility>

#include "base/files/whole_file.h"
#include "terminal/child_process.h"

namespace somato::program {
namespace {

std::string page_to(const std::string& address) {
  return fmt::format(
      "<!doctype html><meta charset=\"utf-8\"><meta name=\"referrer\" content=\"no-referrer\">"
      "<meta http-equiv=\"refresh\" content=\"0; url={0}\"><title>Somato</title>"
      "<a href=\"{0}\">Open the view</a>\n",
      address);
}

// It may run as long as the browser.
Result<void> start_browser(const std::string& file) {
  auto browser = ChildProcess::start({"xdg-open", file});
  if (!browser) {
    browser.error().what = "no browser can be started: the program " + browser.error().what;
    browser.error().advice = "open the address in a browser, or install the package xdg-utils";
    return fail(std::move(browser.error()));
  }
  browser->leave();
  return {};
}

}  // namespace

Result<BrowserStart> BrowserStart::open(const std::string& address) {
  SOMATO_TRY(auto folder, ScratchFolder::create());
  const std::string file = folder.path() + "/view.html";
  SOMATO_TRY_VOID(save_whole(file, page_to(address)));
  SOMATO_TRY_VOID(start_browser(file));
  return BrowserStart(std::move(folder));
}

}  // namespace somato::program
