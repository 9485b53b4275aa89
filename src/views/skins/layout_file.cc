#include "views/skins/layout_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <utility>
#include <variant>

#include "base/files/toml_file.h"
#include "base/files/whole_file.h"
#include "base/text/base64.h"

namespace somato {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostPlaces = 4096;
constexpr double kGreatest = 1e6;   // mm
constexpr double kWidest = 1000.0;  // times the distance between neighbours
constexpr std::size_t kLargestPicture = std::size_t{512} << 10;  // it is in every state of a view

tl::unexpected<Error> refuse(std::string what, const std::string& where, std::string advice) {
  return fail(ErrorKind::kUsage, std::move(what), where, std::move(advice));
}

Result<Point> point_of(const std::vector<double>& numbers, const std::string& what,
                       const std::string& where) {
  if (numbers.size() == 2) return Point{numbers[0], numbers[1]};
  return refuse(fmt::format("{} has {} numbers instead of 2", what, numbers.size()), where,
                "give x and y in mm, without z");
}

Result<std::vector<Point>> points_of(const LayoutKeys& keys, const std::string& where) {
  const std::size_t count = keys.places.size();
  if (count == 0 || count > kMostPlaces) {
    return refuse(fmt::format("{} places", count), where,
                  fmt::format("give 1 to {} as places = [[x, y], ...], in mm", kMostPlaces));
  }
  std::vector<Point> points;
  points.reserve(count);
  for (const auto& numbers : keys.places) {
    SOMATO_TRY(const auto point,
               point_of(numbers, fmt::format("place {}", points.size() + 1), where));
    points.push_back(point);
  }
  return points;
}

Result<void> check_different(const std::vector<Point>& points, const std::string& where) {
  std::set<std::pair<double, double>> known;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (known.emplace(points[i].x, points[i].y).second) continue;
    return refuse(fmt::format("place {} is also that of another element", i + 1), where,
                  "give each element its own place");
  }
  return {};
}

Result<void> check_elements(const ChannelPlaces& channel) {
  const auto& elements = channel.elements;
  if (elements.empty()) return {};
  if (elements.size() != channel.places.size()) {
    return refuse(fmt::format("{} elements and {} places", elements.size(), channel.places.size()),
                  channel.where, "name one element for each place, or omit 'elements'");
  }
  std::set<std::string> known;
  for (const std::string& name : elements) {
    if (known.insert(name).second) continue;
    return refuse(fmt::format("the element '{}' occurs twice", name), channel.where,
                  "name each element once");
  }
  return {};
}

Result<void> check_extent(const ChannelPlaces& channel) {
  const auto [least, greatest] = bounds_of(channel.places, channel.background);
  const double extent = std::max(greatest.x - least.x, greatest.y - least.y);
  const double spacing = spacing_of(channel.places);
  if (extent <= kWidest * spacing) return {};
  return refuse(fmt::format("the places extend over {:.4g} mm, but neighbours are only {:.4g} mm "
                            "apart",
                            extent, spacing),
                channel.where, "give all places in mm");
}

Result<std::string> media_type(const std::string& picture, const std::string& where) {
  std::string ending = fs::path(picture).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  if (ending == ".png") return std::string("image/png");
  if (ending == ".jpg" || ending == ".jpeg") return std::string("image/jpeg");
  if (ending == ".svg") return std::string("image/svg+xml");
  return refuse(fmt::format("'{}' is not a PNG, JPEG or SVG file", picture), where,
                "use a file with the extension .png, .jpg or .svg");
}

// The marks of the begin and the end of a file of that type.
bool is_image(std::string_view bytes, std::string_view type) {
  if (type == "image/png") {
    return bytes.starts_with("\x89PNG\r\n\x1a\n") && bytes.find("IEND") != std::string_view::npos;
  }
  if (type == "image/jpeg") {
    return bytes.starts_with("\xff\xd8\xff") && bytes.rfind("\xff\xd9") != std::string_view::npos;
  }
  const std::size_t root = bytes.find("<svg");
  return root != std::string_view::npos && bytes.find('>', root) != std::string_view::npos;
}

Result<std::string> image_of(const LayoutKeys& keys, const fs::path& folder,
                             const std::string& where) {
  SOMATO_TRY(const auto type, media_type(keys.picture, where));
  SOMATO_TRY(const auto bytes, read_whole((folder / keys.picture).string(), kLargestPicture));
  if (!is_image(bytes, type)) {
    return refuse(fmt::format("the content of '{}' is not a complete {} image", keys.picture, type),
                  where, "use a PNG, JPEG or SVG file whose extension says what it is");
  }
  return fmt::format("data:{};base64,{}", type, base64(bytes));
}

Result<std::optional<SkinBackground>> background_of(const LayoutKeys& keys, const fs::path& folder,
                                                    const std::string& where) {
  const auto& corners = keys.picture_corners;
  if (keys.picture.empty() && corners.empty()) return std::optional<SkinBackground>();
  if (keys.picture.empty() || corners.size() != 2) {
    return refuse("a picture needs its file and two corners", where,
                  "use picture = \"FILE\" together with picture_corners = [[x, y], [x, y]], the "
                  "upper left and the lower right one in mm");
  }
  SOMATO_TRY(const auto upper, point_of(corners[0], "the first corner", where));
  SOMATO_TRY(const auto lower, point_of(corners[1], "the second corner", where));
  if (lower.x <= upper.x || lower.y <= upper.y) {
    return refuse("the second corner of the picture is not below and right of the first", where,
                  "x grows to the right and y downwards");
  }
  SOMATO_TRY(auto image, image_of(keys, folder, where));
  return SkinBackground{std::move(image), upper, lower.x - upper.x, lower.y - upper.y};
}

// An element without a name is called by its number.
Result<std::vector<std::string>> elements_of(const Value& value, const std::string& where) {
  std::vector<std::string> elements;
  const auto* list = std::get_if<Value::List>(&value.content);
  for (const Value& item : list != nullptr ? *list : Value::List{value}) {
    if (const auto* number = std::get_if<std::int64_t>(&item.content)) {
      elements.push_back(fmt::format("{}", *number));
    } else if (const auto* text = std::get_if<std::string>(&item.content)) {
      elements.push_back(*text);
    } else {
      return refuse(fmt::format("{} is not an element", to_toml(item)), where,
                    "use names, numbers or ranges such as \"t00..t03\"");
    }
  }
  if (!elements.empty()) return elements;
  return refuse("the group is empty", where, "name its elements, or omit it");
}

Result<std::vector<ChannelPlaces::Group>> groups_of(const Table::Entry& entry) {
  const auto* table = std::get_if<Table>(&entry.content);
  if (table == nullptr) {
    return refuse("groups must be a table", entry.where, "use groups.NAME = [ELEMENT, ...]");
  }
  std::vector<ChannelPlaces::Group> groups;
  for (const Table::Entry& group : table->entries) {
    const auto* value = std::get_if<Value>(&group.content);
    if (value == nullptr) return fail(not_a_value(group.name, group.where));
    SOMATO_TRY(auto elements, elements_of(*value, group.where));
    groups.push_back({group.name, group.where, std::move(elements)});
  }
  return groups;
}

Result<ChannelPlaces> channel_of(const std::string& name, Table table, const fs::path& folder) {
  ChannelPlaces channel{name, table.where, {}, {}, {}, {}};
  const auto groups = std::find_if(table.entries.begin(), table.entries.end(),
                                   [](const auto& entry) { return entry.name == "groups"; });
  if (groups != table.entries.end()) {
    SOMATO_TRY(channel.groups, groups_of(*groups));
    table.entries.erase(groups);
  }
  SOMATO_TRY(auto keys, read_parameters<LayoutKeys>(table));
  SOMATO_TRY(channel.places, points_of(keys, table.where));
  SOMATO_TRY_VOID(check_different(channel.places, table.where));
  channel.elements = std::move(keys.elements);
  SOMATO_TRY_VOID(check_elements(channel));
  SOMATO_TRY(channel.background, background_of(keys, folder, table.where));
  SOMATO_TRY_VOID(check_extent(channel));
  return channel;
}

}  // namespace

const Declarations<LayoutKeys>& LayoutKeys::declarations() {
  using P = LayoutKeys;
  const Range millimetres = Range::between(-kGreatest, kGreatest);
  static const auto declared =
      Declarations<P>()
          .add("places", &P::places, "mm", millimetres,
               "Place of each element as [x, y]; x grows to the right and y downwards. Required.")
          .add("elements", &P::elements, "", Range::any(),
               "Names of the elements in the order of the places; empty: the order of the channel, "
               "or of the columns of a map.")
          .add("picture", &P::picture, "", Range::any(),
               "PNG, JPEG or SVG file that is drawn behind the elements, from the folder of the "
               "layout file; empty: none.")
          .add("picture_corners", &P::picture_corners, "mm", millimetres,
               "Upper left and lower right corner of the picture, as [[x, y], [x, y]].");
  return declared;
}

Result<std::vector<ChannelPlaces>> read_layout(const std::string& path) {
  SOMATO_TRY(const auto file, read_toml(path));
  std::vector<ChannelPlaces> layout;
  for (const Table::Entry& entry : file.entries) {
    if (entry.name != "layout") {
      return fail(unknown_name("table", entry.name, entry.where, {"layout"}));
    }
    const auto* channels = std::get_if<Table>(&entry.content);
    for (const Table::Entry& one : channels ? channels->entries : std::vector<Table::Entry>()) {
      const auto* table = std::get_if<Table>(&one.content);
      if (table == nullptr) {
        return refuse(fmt::format("'{}' is not in a table of a channel", one.name), one.where,
                      "begin with [layout.CHANNEL], such as [layout.touch]");
      }
      SOMATO_TRY(auto places, channel_of(one.name, *table, fs::path(path).parent_path()));
      layout.push_back(std::move(places));
    }
  }
  if (!layout.empty()) return layout;
  return refuse("there is no table [layout.CHANNEL]", path,
                "begin with [layout.touch], if 'touch' is the channel");
}

}  // namespace somato
