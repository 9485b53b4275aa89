#include "report/picture_file.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <utility>

#include "base/files/scratch_folder.h"
#include "base/files/whole_file.h"
#include "report/pdf_box.h"
#include "terminal/headless_browser.h"

namespace somato::program {
namespace {

constexpr double kUnit = 25.4 / 96;  // mm
constexpr std::size_t kPixelsPerUnit = 2;

std::string ending_of_file(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return ending;
}

// The value of an attribute of the picture's first element, whose numbers have a point.
double length_of(std::string_view svg, std::string_view attribute) {
  const std::size_t at = svg.find(fmt::format(" {}=\"", attribute));
  if (at == std::string_view::npos) return 0.0;
  return std::strtod(svg.data() + at + attribute.size() + 3, nullptr);
}

struct Size {
  double width = 0.0;
  double height = 0.0;
};

// A page with nothing but the picture, `scale` times as large.
std::string page_of(const std::string& svg, const Size& size, std::size_t scale) {
  return fmt::format(
      "<!doctype html><meta charset=\"utf-8\"><style>body {{ margin: 0 }} svg {{ display: block; "
      "width: {}px; height: {}px }}</style>{}",
      size.width * static_cast<double>(scale), size.height * static_cast<double>(scale), svg);
}

Result<std::string> drawn(const std::string& svg, bool is_pdf) {
  const Size size{length_of(svg, "width"), length_of(svg, "height")};
  const std::size_t scale = is_pdf ? 1 : kPixelsPerUnit;
  const auto pixels = [&](double length) {
    return scale * static_cast<std::size_t>(std::ceil(length));
  };
  SOMATO_TRY(auto folder, ScratchFolder::create());
  const std::string path = folder.path() + "/picture.html";
  SOMATO_TRY_VOID(save_whole(path, page_of(svg, size, scale)));
  SOMATO_TRY(auto browser,
             HeadlessBrowser::open(file_address(path), pixels(size.width), pixels(size.height)));
  SOMATO_TRY_VOID(browser.wait_until(
      "location.protocol === \"file:\" && document.readyState === \"complete\""));
  if (!is_pdf) return browser.settled_picture();
  const double width = size.width * kUnit;
  const double height = size.height * kUnit;
  return browser.printed(width + kAroundPicture, height + kAroundPicture).map([&](std::string pdf) {
    return cut_page(std::move(pdf), width, height);
  });
}

}  // namespace

Result<void> check_picture_ending(const std::string& path) {
  const std::string ending = ending_of_file(path);
  for (const char* other : {".jpg", ".jpeg", ".eps", ".gif", ".tif", ".tiff", ".webp"}) {
    if (ending != other) continue;
    return fail(ErrorKind::kUsage,
                fmt::format("pictures are SVG, PNG or PDF, not {}", ending.substr(1)), path,
                "use the extension .svg, .png or .pdf");
  }
  return {};
}

Result<void> save_picture(const std::string& path, const std::string& svg) {
  const std::string ending = ending_of_file(path);
  if (ending != ".png" && ending != ".pdf") return save_whole(path, svg);
  auto bytes = drawn(svg, ending == ".pdf");
  if (!bytes) {
    if (bytes.error().advice.empty()) bytes.error().advice = "save the picture as .svg";
    return fail(std::move(bytes.error()));
  }
  return save_whole(path, *bytes);
}

}  // namespace somato::program
