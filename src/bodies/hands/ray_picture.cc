#include "bodies/hands/ray_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "bodies/hands/ray.h"
#include "somato/core/check.h"

namespace somato::detail {
namespace {

constexpr float kAmbient = 0.5F;
constexpr int kHiddenGroup = 3;

// A pinhole: it looks along its -z, x points right and y up.
struct Camera {
  Vector3 position{};
  Vector3 right{};
  Vector3 up{};
  Vector3 back{};
  mjtNum half_height = 0;  // of the picture at distance 1
  mjtNum half_width = 0;
};

Camera make_camera(const mjModel& model, const mjData& data, int camera, mjtNum aspect) {
  const mjtNum* position = entry(data.cam_xpos, 3, camera);
  const mjtNum* axes = entry(data.cam_xmat, 9, camera);
  const mjtNum height = std::tan(model.cam_fovy[camera] * std::numbers::pi / 360);
  return {.position = {position[0], position[1], position[2]},
          .right = {axes[0], axes[3], axes[6]},
          .up = {axes[1], axes[4], axes[7]},
          .back = {axes[2], axes[5], axes[8]},
          .half_height = height,
          .half_width = height * aspect};
}

// From the first number to before the last.
struct Range {
  std::size_t first = 0;
  std::size_t last = 0;
};

// The range of `count` positions between -half and half (at distance 1) that a ball may cover: its
// centre is `aside` of the axis and `ahead`.
Range covered(mjtNum aside, mjtNum ahead, mjtNum radius, mjtNum half, std::size_t count) {
  const mjtNum away = std::hypot(aside, ahead);
  if (away <= radius) return {0, count};
  const mjtNum centre = std::atan2(aside, ahead);
  const mjtNum spread = std::asin(radius / away);
  constexpr mjtNum kSide = std::numbers::pi / 2 - 1e-6;
  if (centre - spread > kSide || centre + spread < -kSide) return {};
  const auto place = [&](mjtNum angle) {
    const mjtNum at = std::tan(std::clamp(angle, -kSide, kSide)) / half;
    return std::clamp((at + 1) / 2, mjtNum{0}, mjtNum{1}) * static_cast<mjtNum>(count);
  };
  return {static_cast<std::size_t>(std::floor(place(centre - spread))),
          static_cast<std::size_t>(std::ceil(place(centre + spread)))};
}

bool is_shown(const mjModel& model, int geom) {
  const int material = model.geom_matid[geom];
  return model.geom_group[geom] < kHiddenGroup && model.geom_rgba[4 * geom + 3] > 0 &&
         (material < 0 || model.mat_rgba[4 * material + 3] > 0);
}

// As in the engine's viewer: a colour of the geom has precedence over that of its material.
Colour colour_of(const mjModel& model, int geom) {
  const float* own = entry(model.geom_rgba, 4, geom);
  const int material = model.geom_matid[geom];
  const bool is_default = std::all_of(own, own + 3, [](float part) { return part == 0.5F; });
  const float* chosen = material >= 0 && is_default ? entry(model.mat_rgba, 4, material) : own;
  return {chosen[0], chosen[1], chosen[2]};
}

class RayScene {
 public:
  RayScene(const mjModel& model, const mjData& data, std::span<const Tint> tints,
           const Camera& camera)
      : model_(model), data_(data) {
    colours_.reserve(static_cast<std::size_t>(model.ngeom));
    shown_.reserve(static_cast<std::size_t>(model.ngeom));
    for (int geom = 0; geom < model.ngeom; ++geom) {
      colours_.push_back(colour_of(model, geom));
      if (is_shown(model, geom)) shown_.push_back(geom);
    }
    for (const Tint& tint : tints) {
      require(tint.geom >= 0 && tint.geom < model.ngeom, "a tinted geom must belong to the model");
      colours_[static_cast<std::size_t>(tint.geom)] = tint.colour;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      light_[k] = 0.35 * camera.back[k] - 0.4 * camera.right[k] + (k == 2 ? 0.85 : 0);
    }
    light_ = normalized(light_);
  }

  const std::vector<int>& shown() const { return shown_; }
  mjtNum distance(int geom, const Ray& ray) const {
    return distance_to_geom(model_, data_, geom, ray);
  }
  // The position of the geom's bounding ball; none (radius 0) for planes.
  Vector3 centre(int geom) const {
    const mjtNum* at = entry(data_.geom_xpos, 3, geom);
    return {at[0], at[1], at[2]};
  }
  mjtNum radius(int geom) const { return model_.geom_rbound[geom]; }

  Colour seen(int geom, const Ray& ray, mjtNum distance) const {
    const Vector3 normal = normal_of_geom(model_, data_, geom, ray, distance);
    const mjtNum facing = std::max(mjtNum{0}, dot(normal, light_));
    constexpr mjtNum kOff =
        1e-5;  // Metres: an offset that prevents surfaces from shading themselves.
    const Ray to_light{point_on({point_on(ray, distance), normal}, kOff), light_};
    const bool lit = facing > 0 && !is_shaded(to_light);
    const float bright = kAmbient + (lit ? (1 - kAmbient) * static_cast<float>(facing) : 0.0F);
    Colour colour = colours_[static_cast<std::size_t>(geom)];
    for (float& part : colour) part *= bright;
    return colour;
  }

 private:
  // Whether the ray passes the ball round the geom, cheaply.
  bool may_meet(int geom, const Ray& ray) const {
    const mjtNum reach = radius(geom);
    if (reach <= 0) return true;
    const Vector3 at = centre(geom);
    const Vector3 to{at[0] - ray.from[0], at[1] - ray.from[1], at[2] - ray.from[2]};
    const mjtNum along = dot(to, ray.direction);
    return along > -reach && dot(to, to) - along * along < reach * reach;
  }
  bool is_shaded(const Ray& ray) const {
    return std::any_of(shown_.begin(), shown_.end(),
                       [&](int geom) { return may_meet(geom, ray) && distance(geom, ray) >= 0; });
  }

  const mjModel& model_;
  const mjData& data_;
  std::vector<int> shown_;
  std::vector<Colour> colours_;
  Vector3 light_{};
};

// The nearest geom at each point of a raster.
class Raster {
 public:
  Raster(std::size_t columns, std::size_t rows, const Camera& camera)
      : columns_(columns),
        rows_(rows),
        camera_(camera),
        geoms_(columns * rows, -1),
        distances_(columns * rows, std::numeric_limits<mjtNum>::infinity()) {}

  void add(const RayScene& scene, int geom) {
    const auto [across, down] = place_of(scene, geom);
    for (std::size_t row = down.first; row < down.last; ++row) {
      for (std::size_t column = across.first; column < across.last; ++column) {
        const mjtNum distance = scene.distance(geom, ray(column, row));
        const std::size_t at = row * columns_ + column;
        if (distance < 0 || distance >= distances_[at]) continue;
        distances_[at] = distance;
        geoms_[at] = geom;
      }
    }
  }

  Colour colour(const RayScene& scene, std::size_t column, std::size_t row) const {
    const std::size_t at = row * columns_ + column;
    if (geoms_[at] < 0) return {1, 1, 1};
    return scene.seen(geoms_[at], ray(column, row), distances_[at]);
  }

 private:
  struct Place {
    Range across;
    Range down;
  };

  Place place_of(const RayScene& scene, int geom) const {
    const mjtNum radius = scene.radius(geom);
    if (radius <= 0) return {{0, columns_}, {0, rows_}};
    Vector3 to = scene.centre(geom);
    for (std::size_t k = 0; k < 3; ++k) to[k] -= camera_.position[k];
    const mjtNum ahead = -dot(to, camera_.back);
    return {covered(dot(to, camera_.right), ahead, radius, camera_.half_width, columns_),
            covered(-dot(to, camera_.up), ahead, radius, camera_.half_height, rows_)};
  }

  Ray ray(std::size_t column, std::size_t row) const {
    const auto middle = [](std::size_t place, std::size_t count) {
      return (2 * static_cast<mjtNum>(place) + 1) / static_cast<mjtNum>(count) - 1;
    };
    const mjtNum x = camera_.half_width * middle(column, columns_);
    const mjtNum y = -camera_.half_height * middle(row, rows_);
    Vector3 direction{};
    for (std::size_t k = 0; k < 3; ++k) {
      direction[k] = x * camera_.right[k] + y * camera_.up[k] - camera_.back[k];
    }
    return {camera_.position, normalized(direction)};
  }

  std::size_t columns_;
  std::size_t rows_;
  Camera camera_;
  std::vector<int> geoms_;
  std::vector<mjtNum> distances_;
};

// The mean colour of the rays x rays points of a pixel.
Colour pixel(const Raster& raster, const RayScene& scene, std::size_t rays, std::size_t x,
             std::size_t y) {
  Colour sum{};
  for (std::size_t point = 0; point < rays * rays; ++point) {
    const Colour one = raster.colour(scene, x * rays + point % rays, y * rays + point / rays);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += one[k];
  }
  for (float& part : sum) part /= static_cast<float>(rays * rays);
  return sum;
}

std::uint8_t to_byte(float part) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(part, 0.0F, 1.0F) * 255.0F));
}

}  // namespace

Result<Image> ray_picture(const mjModel& model, const mjData& data,
                          const RayPictureSettings& settings, std::span<const Tint> tints) {
  const auto [width, height, rays, name] = settings;
  require_picture_size(width, height);
  require(rays > 0 && rays <= 8, "a picture needs 1 to 8 rays per pixel along each axis");
  const int index = mj_name2id(&model, mjOBJ_CAMERA, name.c_str());
  if (index < 0) {
    return fail(ErrorKind::kData, fmt::format("the model has no camera '{}'", name), {},
                fmt::format("add a line <camera name=\"{}\" .../> to the model", name));
  }
  const Camera camera =
      make_camera(model, data, index, static_cast<mjtNum>(width) / static_cast<mjtNum>(height));
  const RayScene scene(model, data, tints, camera);
  Raster raster(width * rays, height * rays, camera);
  for (const int geom : scene.shown()) raster.add(scene, geom);

  Image image{.width = width, .height = height, .rgb = {}};
  image.rgb.reserve(3 * width * height);
  for (std::size_t at = 0; at < width * height; ++at) {
    for (const float part : pixel(raster, scene, rays, at % width, at / width)) {
      image.rgb.push_back(to_byte(part));
    }
  }
  return image;
}

}  // namespace somato::detail
