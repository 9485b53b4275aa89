#include <fmt/format.h>

#include "program/support/program_test.h"

namespace somato {
namespace {

using PictureFile = ProgramTest;

bool has_chromium() {
  return std::system("command -v chromium > /dev/null 2>&1") == 0;  // NOLINT(cert-env33-c)
}

// A number in four bytes, the highest first, as PNG files have the size of a picture.
std::size_t big_endian(const std::string& bytes, std::size_t at) {
  std::size_t number = 0;
  for (std::size_t i = 0; i < 4; ++i)
    number = 256 * number + static_cast<unsigned char>(bytes[at + i]);
  return number;
}

double length_in(const std::string& svg, const std::string& side) {
  return std::stod(svg.substr(svg.find(" " + side + "=\"") + side.size() + 3));
}

TEST_F(PictureFile, PngAndPdfHaveTheSizeOfTheSvg) {
  if (!has_chromium()) GTEST_SKIP() << "requires chromium";
  train();
  const auto drawn = [&](const std::string& file) {
    output_of({"som", "plot", "good.map", "--panels", "u_matrix", "-o", file});
    return read(file);
  };
  const std::string svg = drawn("p.svg");
  const std::string png = drawn("p.png");
  ASSERT_TRUE(png.starts_with("\x89PNG"));
  EXPECT_NEAR(static_cast<double>(big_endian(png, 16)), 2 * length_in(svg, "width"), 2);
  EXPECT_NEAR(static_cast<double>(big_endian(png, 20)), 2 * length_in(svg, "height"), 2);
  const std::string pdf = drawn("p.PDF");
  ASSERT_TRUE(pdf.starts_with("%PDF-"));
  const std::size_t box = pdf.find("/MediaBox [0 ");
  ASSERT_NE(box, std::string::npos);
  double bottom = 0;
  double right = 0;
  double top = 0;
  ASSERT_EQ(std::sscanf(pdf.c_str() + box, "/MediaBox [0 %lf %lf %lf]", &bottom, &right, &top), 3);
  EXPECT_NEAR(right, 0.75 * length_in(svg, "width"), 0.1);
  EXPECT_NEAR(top - bottom, 0.75 * length_in(svg, "height"), 0.1);
}

TEST_F(PictureFile, OtherFormatsAreRefused) {
  train();
  EXPECT_EQ(run({"som", "plot", "good.map", "-o", "p.svg"}).exit_code, 0);
  expect_refused(2, {"som", "plot", "good.map", "-o", "p.tiff"}, {"p.tiff", "use the extension"});
}

}  // namespace
}  // namespace somato
