#include "simulation/urban_street.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "simulation/objects.hpp"
#include "simulation/random.hpp"

namespace groundgrid::simulation::urban {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kCrown = 0.02;
constexpr double kPavementFall = 0.02;
constexpr double kBankSlope = 0.3;      // From its foot to its head.
constexpr double kBetweenLots_m = 0.8;  // Where one garden's height becomes that of the next.

std::uint64_t number(double value) {
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(value)));
}

std::vector<Wave> waves(std::uint64_t seed) {
  Random random(hash({seed, 100}));
  return {{1.2, {kTurn / 170.0, 0.004}, random.uniform(0.0, kTurn)},
          {0.4, {0.03, kTurn / 120.0}, random.uniform(0.0, kTurn)}};
}

double crown(double d) { return -kCrown * std::min(std::abs(d), kKerb_m); }

/// How far a place is beside the drive of its lot, negative on it.
double beside_drive(double s) {
  return std::abs(s - std::floor(s / kLot_m) * kLot_m - kDrive_m) - 1.5;
}

double profile(const Garden& garden, double into_m, double beside_drive_m) {
  const double ramp = garden.rise_m * std::clamp(into_m / 5.0, 0.0, 1.0);
  switch (garden.kind) {
    case Garden::Kind::bank:
      return garden.rise_m * smooth_step(0.4, 0.4 + garden.rise_m / kBankSlope, into_m);
    case Garden::Kind::terrace:
      return std::lerp(ramp, garden.rise_m * smooth_step(0.0, 0.1, into_m),
                       smooth_step(0.0, 0.1, beside_drive_m));
    case Garden::Kind::sunken:
      return ramp;
    case Garden::Kind::paved:
    case Garden::Kind::level:
      break;
  }
  return garden.rise_m * std::clamp(into_m / 12.0, 0.0, 1.0);
}

}  // namespace

Junction junction_near(double s) {
  const double index = std::round((s - kFirstJunction_m) / kBetweenJunctions_m);
  return {kFirstJunction_m + index * kBetweenJunctions_m,
          std::fmod(std::abs(index), 2.0) < 0.5 ? 1.0 : -1.0};
}

bool is_near_junction(double s, double reach_m) {
  return std::abs(s - junction_near(s).s) < reach_m;
}

Street::Street(std::shared_ptr<const Path> path, std::uint64_t seed)
    : path_(std::move(path)), seed_(seed), relief_(waves(seed)) {}

Ground Street::operator()(const Eigen::Vector2d& place) const {
  Ground ground = across(path_->project(place));
  ground.height_m += relief_.height(place) + 0.004 * bumps(place, 0.8, seed_);
  if (ground.label == label::kTerrain)
    ground.height_m += 0.03 * bumps(place, 1.7, seed_) + 0.02 * bumps(place, 0.5, seed_);
  return ground;
}

bool Street::has_parking(double s, double d) const {
  return !is_near_junction(s, 20.0) && draw(1, s / 40.0, d) < 0.7;
}

Garden Street::garden(double s, double d) const {
  const double kind = draw(3, s / kLot_m, d);
  const double size = draw(4, s / kLot_m, d);
  Garden garden{.draw = draw(5, s / kLot_m, d)};
  if (is_near_junction(s, kLot_m)) return {Garden::Kind::level, 0.2, garden.draw};
  if (kind < 0.12) return {Garden::Kind::paved, 0.25 * size, garden.draw};
  if (kind < 0.32) return {Garden::Kind::level, 0.4 * size, garden.draw};
  if (kind < 0.66) return {Garden::Kind::bank, 0.5 + 1.1 * size, garden.draw};
  if (kind < 0.9) return {Garden::Kind::terrace, 0.3 + 0.8 * size, garden.draw};
  return {Garden::Kind::sunken, -0.4 - 0.6 * size, garden.draw};
}

/// One number for each stretch of each side.
double Street::draw(std::uint64_t what, double stretch, double d) const {
  return Random(hash({seed_, 200 + what, number(stretch), d < 0.0 ? 0U : 1U})).uniform();
}

Ground Street::across(Station at) const {
  const Junction junction = junction_near(at.s);
  const bool beside = at.d * junction.side > 0.0;
  const double from_street = std::abs(at.s - junction.s) - kSideStreet_m;
  const double beyond_kerb = std::abs(at.d) - kKerb_m;
  const double outside = beside ? std::min(beyond_kerb, from_street) : beyond_kerb;
  if (outside < 0.0) return road(at, junction, std::max(beyond_kerb, 0.0));
  return beside_road(at, junction, outside, beyond_kerb);
}

Ground Street::median(Station at, double before_junction_m) {
  const double inside =
      std::min({before_junction_m - 8.0, 27.0 - before_junction_m, 0.45 - std::abs(at.d)});
  return {crown(at.d) + 0.13 * smooth_step(0.0, 0.08, inside), label::kTerrain, 0.05};
}

Ground Street::road(Station at, const Junction& junction, double into_street) const {
  const double before = junction.s - at.s;
  if (before > 8.0 && before < 27.0 && std::abs(at.d) < 0.45) return median(at, before);
  const double own_crown = -0.015 * std::abs(at.s - junction.s);
  const double height =
      crown(at.d) + smooth_step(0.0, 4.0, into_street) * own_crown + 0.01 * into_street;
  return {height, road_label(at, into_street), 0.0};
}

std::uint16_t Street::road_label(Station at, double into_street) const {
  if (into_street > 0.0) return label::kRoad;
  if (std::abs(at.d) < 0.06 && std::fmod(at.s + 1200.0, 9.0) < 4.0) return label::kLaneMarking;
  if (std::abs(at.d) > kLanesEdge_m && has_parking(at.s, at.d)) return label::kParking;
  return label::kRoad;
}

double Street::kerb(Station at, const Junction& junction) const {
  const double full = 0.08 + 0.07 * draw(2, at.s / 60.0, at.d);
  const double drive = std::floor(at.s / kLot_m) * kLot_m + kDrive_m;
  const double at_drive = 1.0 - smooth_step(1.6, 2.6, std::abs(at.s - drive));
  const double at_crossing = 1.0 - smooth_step(5.0, 6.5, std::abs(at.s - junction.s));
  return full - (full - 0.025) * std::max(at_drive, at_crossing);
}

Ground Street::beside_road(Station at, const Junction& junction, double outside,
                           double beyond_kerb) const {
  const double edge = crown(at.d) + 0.01 * std::max(beyond_kerb, 0.0);
  const double height = edge + kerb(at, junction) * smooth_step(0.0, 0.08, outside) +
                        kPavementFall * std::min(outside, kPavement_m);
  if (outside < kPavement_m) return {height, label::kSidewalk, 0.0};
  const Garden here = garden(at.s, at.d);
  const double top = height + garden_height(at, outside - kPavement_m);
  if (here.kind == Garden::Kind::paved || here.kind == Garden::Kind::sunken ||
      beside_drive(at.s) < 0.0)
    return {top, here.draw < 0.5 ? label::kOtherGround : label::kSidewalk, 0.0};
  return {top, label::kTerrain, 0.04 + 0.1 * here.draw};
}

double Street::garden_height(Station at, double into_m) const {
  const double lot = std::floor(at.s / kLot_m) * kLot_m;
  const double in_lot = at.s - lot;
  const double own = profile(garden(at.s, at.d), into_m, beside_drive(at.s));
  if (in_lot < kBetweenLots_m) {
    const double before = profile(garden(lot - 1.0, at.d), into_m, kDrive_m);
    return std::lerp(before, own, smooth_step(-kBetweenLots_m, kBetweenLots_m, in_lot));
  }
  if (in_lot > kLot_m - kBetweenLots_m) {
    const double after = profile(garden(lot + kLot_m + 1.0, at.d), into_m, kDrive_m);
    return std::lerp(own, after, smooth_step(-kBetweenLots_m, kBetweenLots_m, in_lot - kLot_m));
  }
  return own;
}

}  // namespace groundgrid::simulation::urban
