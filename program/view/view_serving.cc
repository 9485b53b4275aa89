#include "view/view_serving.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

#include "flags/memory_flag.h"
#include "report/pages.h"
#include "views/http/address.h"

namespace somato::program {
namespace {

std::string type_of(std::string_view name) {
  if (name.ends_with(".js")) return "text/javascript; charset=utf-8";
  if (name.ends_with(".css")) return "text/css; charset=utf-8";
  return "text/html; charset=utf-8";
}

}  // namespace

Result<std::vector<ViewPage>> view_pages() {
  std::vector<ViewPage> served;
  for (const Page& page : pages()) {
    if (!page.name.starts_with("view.")) continue;
    const std::string path = page.name == "view.html" ? "/" : fmt::format("/{}", page.name);
    served.push_back({path, type_of(page.name), std::string(page.text)});
  }
  if (!served.empty()) return served;
  return fail(ErrorKind::kUsage, "this program was built without its pages", "view",
              "build it where npm is installed");
}

std::vector<Flag> server_flags() {
  return {
      {"--port",
       "Port of the page, also the local one of a tunnel: ssh -L PORT:localhost:PORT HOST. "
       "Default: "
       "any free port"},
      {"--address", "Numeric IP address to listen on. Default: 127.0.0.1"},
      {"--allow-others",
       "Permit an --address that other machines can reach: anyone who has the start address can "
       "then see everything and move the body, and the address is transmitted without encryption",
       false, false}};
}

Flag page_memory_flag() {
  return {
      "--page-memory",
      "Maximum memory for what a body has explored, such as 500MiB: the oldest explorations are "
      "dropped. Default: 256MiB"};
}

Result<std::size_t> read_page_memory(const Arguments& arguments) {
  constexpr std::size_t kLeast = std::size_t{1} << 20;  // a second of the fastest microphones
  if (!arguments.has("page-memory")) return kPageMemory;
  SOMATO_TRY(const auto bytes, bytes_in(arguments.text("page-memory"), "--page-memory"));
  if (bytes >= kLeast) return bytes;
  return fail(ErrorKind::kUsage, "must be at least 1MiB", "--page-memory");
}

Result<ViewServerSettings> read_server_settings(const Arguments& arguments) {
  ViewServerSettings settings;
  SOMATO_TRY(auto port, arguments.number("port", 0));
  if (port.value_or(0) > 65535) {
    return fail(ErrorKind::kUsage, "a port must be at most 65535", "--port");
  }
  settings.port = static_cast<std::uint16_t>(port.value_or(0));
  if (!arguments.has("address")) return settings;
  auto address = parse_address(arguments.text("address"));
  if (!address) {
    address.error().where = "--address";
    return fail(std::move(address.error()));
  }
  settings.address = address->text;
  if (address->reach == Address::Reach::kAll) {
    return fail(ErrorKind::kUsage, "the view requires a single address", "--address",
                "use the address of the interface on which other machines connect");
  }
  const bool is_ours = address->reach == Address::Reach::kLoopback;
  if (is_ours || arguments.has("allow-others")) return settings;
  return fail(ErrorKind::kUsage, "other machines can reach this address", "--address",
              "anyone who obtains the start address, which is transmitted without encryption, can "
              "see the view and move the body; use --allow-others to permit it");
}

}  // namespace somato::program
