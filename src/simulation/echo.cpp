#include "simulation/echo.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulation/objects.hpp"

namespace groundgrid::simulation {
namespace {

constexpr std::uint32_t kTerrainMesh = 0;
constexpr double kBeyondHit_m = 1e-3;
constexpr int kMostVolumes = 40;
constexpr double kReflectionChance = 0.011;
constexpr double kMoversReach_m = 95.0;
constexpr double kGrassShift_m = 2.0;
constexpr double kHighestLeaves_m = 60.0;

std::uint32_t full_label(const Surface& surface) {
  return std::uint32_t{surface.instance} << 16U | surface.label;
}

float reflectivity_of(std::uint16_t label) {
  switch (label) {
    case label::kRoad:
      return 0.22F;
    case label::kLaneMarking:
      return 0.6F;
    case label::kTerrain:
      return 0.35F;
    default:
      return 0.28F;
  }
}

// Grazing and far echoes get lost; glass lets most rays through, paint sends many elsewhere.
double loss(const Surface& surface, double cosine, double distance_m, double most_m) {
  const double share = most_m / distance_m;
  const double strength =
      static_cast<double>(surface.reflectivity) * std::sqrt(cosine) * share * share;
  const double weak = std::exp(-25.0 * strength);
  const double away = 1.0 - cosine;
  switch (surface.material) {
    case Material::glass:
      return std::max(weak, 0.6);
    case Material::paint:
      return std::max(weak, 0.04 + 0.4 * away * away);
    case Material::matt:
      break;
  }
  return std::max(weak, 0.01);
}

}  // namespace

World::World(const Scene& scene, const Terrain& terrain)
    : scene_(&scene),
      terrain_(&terrain),
      still_({&terrain.mesh(), &scene.solids}),
      leaves_({&scene.leaves}),
      moving_({&moving_mesh_}) {}

void World::move_to(double time_s, const Eigen::Vector2d& place) {
  moving_mesh_ = {};
  const Path& path = *scene_->path;
  for (const Mover& mover : scene_->movers) {
    const Station at{mover.start.s + mover.speed_mps * time_s, mover.start.d};
    if (at.s < path.first() || at.s > path.last()) continue;
    const Eigen::Vector2d point = path.point(at);
    if ((point - place).norm() > kMoversReach_m) continue;
    const double turn = path.heading(at.s) + (mover.speed_mps < 0.0 ? std::numbers::pi : 0.0);
    moving_mesh_.append(mover.mesh,
                        Eigen::Translation3d(point.x(), point.y(), terrain_->height(point)) *
                            Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()));
  }
  moving_ = RayCaster({&moving_mesh_});
}

std::optional<World::Touch> World::touch(const Ray& ray, double least_m, double most_m) const {
  const std::optional<Hit> still = still_.cast(ray, least_m, most_m);
  const double nearest = still ? still->distance_m : most_m;
  Touch result;
  if (const auto moving = moving_.cast(ray, least_m, nearest)) {
    result = {moving->distance_m, moving->normal, moving_mesh_.surface(moving->triangle)};
  } else if (!still) {
    return std::nullopt;
  } else if (still->mesh != kTerrainMesh) {
    result = {still->distance_m, still->normal, scene_->solids.surface(still->triangle)};
  } else {
    const Eigen::Vector3d place = ray.origin + still->distance_m * ray.direction;
    const Ground ground = scene_->ground(place.head<2>());
    const Surface soil{.label = ground.label, .reflectivity = reflectivity_of(ground.label)};
    result = {still->distance_m, still->normal, soil, ground.grass_m, true};
  }
  if (result.normal.dot(ray.direction) > 0.0) result.normal = -result.normal;
  return result;
}

// Along the ray, the chance of a return in a stretch of leaves grows with its length and their
// density; where volumes overlap the densities add up.
std::optional<World::Touch> World::touch_leaves(const Ray& ray, double most_m,
                                                Random& random) const {
  double left = random.exponential();
  double density = 0.0;
  double from = 0.0;
  Surface entered;
  for (int i = 0; i < kMostVolumes; ++i) {
    const std::optional<Hit> hit = leaves_.cast(ray, from, most_m);
    const double to = hit ? hit->distance_m : most_m;
    if (density * (to - from) > left) return Touch{from + left / density, -ray.direction, entered};
    if (!hit) return std::nullopt;
    left -= density * (to - from);
    const Surface& border = scene_->leaves.surface(hit->triangle);
    const double change = static_cast<double>(border.density);
    if (hit->normal.dot(ray.direction) < 0.0) {
      density += change;
      entered = border;
    } else {
      density = std::max(0.0, density - change);
    }
    from = to + kBeyondHit_m;
  }
  return std::nullopt;
}

bool World::is_under_leaves(const Eigen::Vector2d& place) const {
  const Ray up{{place.x(), place.y(), terrain_->height(place) - 1.0}, Eigen::Vector3d::UnitZ()};
  double from = 0.0;
  for (int i = 0; i < kMostVolumes; ++i) {
    const std::optional<Hit> hit = leaves_.cast(up, from, kHighestLeaves_m);
    if (!hit) return false;
    if (scene_->leaves.surface(hit->triangle).label == label::kVegetation) return true;
    from = hit->distance_m + kBeyondHit_m;
  }
  return false;
}

// A car's body sends the ray on to the ground; the sensor takes what comes back the same way for
// an echo from straight ahead, at the length of the whole way.
Echo World::reflection(const Ray& ray, const Touch& first, double most_m) const {
  const Eigen::Vector3d at = ray.origin + first.distance_m * ray.direction;
  const Eigen::Vector3d onward =
      ray.direction - 2.0 * ray.direction.dot(first.normal) * first.normal;
  const auto second = touch({at, onward}, kBeyondHit_m, most_m - first.distance_m);
  if (!second || !second->soil) return {};
  return {first.distance_m + second->distance_m, label::kOutlier,
          0.5F * second->surface.reflectivity};
}

Echo World::echo(const Ray& ray, double least_m, double most_m, Random random) const {
  std::optional<Touch> first = touch(ray, least_m, most_m);
  const double reach = first ? first->distance_m : most_m;
  if (auto leaves = touch_leaves(ray, reach, random)) first = leaves;
  if (!first || first->distance_m < least_m) return {};
  if (first->surface.material == Material::paint && random.chance(kReflectionChance))
    return reflection(ray, *first, most_m);
  const double cosine = std::max(-first->normal.dot(ray.direction), 1e-3);
  if (random.chance(loss(first->surface, cosine, first->distance_m, most_m))) return {};
  if (first->grass_m > 0.0) {
    // Blades stop the ray somewhere above the soil, which at a grazing angle is well before it.
    const double above = first->grass_m * random.uniform() * random.uniform();
    first->distance_m -= std::min(above / cosine, kGrassShift_m);
  }
  return {first->distance_m, full_label(first->surface),
          first->surface.reflectivity * static_cast<float>(std::sqrt(cosine)), first->soil};
}

}  // namespace groundgrid::simulation
