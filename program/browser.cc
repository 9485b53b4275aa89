#include "browser.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <utility>

#include "files/whole_file.h"

namespace somato::program {
namespace {

std::string page_to(const std::string& address) {
  return fmt::format(
      "<!doctype html><meta charset=\"utf-8\"><meta name=\"referrer\" content=\"no-referrer\">"
      "<meta http-equiv=\"refresh\" content=\"0; url={0}\"><title>Somato</title>"
      "<a href=\"{0}\">Open the view</a>\n",
      address);
}

// It may run as long as the browser; Ctrl-C ends this program only.
Result<void> start_browser(std::string file) {
  posix_spawn_file_actions_t files{};
  posix_spawn_file_actions_init(&files);
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&files, number, "/dev/null", O_RDWR, 0);
  }
  posix_spawnattr_t attributes{};
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  std::string name = "xdg-open";
  const std::array<char*, 3> arguments{name.data(), file.data(), nullptr};
  pid_t process = 0;
  const int error =
      ::posix_spawnp(&process, "xdg-open", &files, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  if (error == 0) return {};
  return fail(ErrorKind::kSystem,
              fmt::format("no browser can be started: {}", std::strerror(error)), "xdg-open",
              "open the address in a browser, or install the package xdg-utils");
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
