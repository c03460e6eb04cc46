#include "evaluation/semantic_kitti_classes.hpp"

#include <algorithm>
#include <array>

namespace groundgrid::evaluation {
namespace {

struct Class {
  std::uint16_t number;
  const char* name;
  Truth truth;
};

constexpr std::array kClasses{
    Class{0, "unlabeled", Truth::ignored},
    Class{1, "outlier", Truth::ignored},
    Class{10, "car", Truth::non_ground},
    Class{11, "bicycle", Truth::non_ground},
    Class{13, "bus", Truth::non_ground},
    Class{15, "motorcycle", Truth::non_ground},
    Class{16, "on-rails", Truth::non_ground},
    Class{18, "truck", Truth::non_ground},
    Class{20, "other-vehicle", Truth::non_ground},
    Class{30, "person", Truth::non_ground},
    Class{31, "bicyclist", Truth::non_ground},
    Class{32, "motorcyclist", Truth::non_ground},
    Class{40, "road", Truth::ground},
    Class{44, "parking", Truth::ground},
    Class{48, "sidewalk", Truth::ground},
    Class{49, "other-ground", Truth::ground},
    Class{50, "building", Truth::non_ground},
    Class{51, "fence", Truth::non_ground},
    Class{52, "other-structure", Truth::non_ground},
    Class{60, "lane-marking", Truth::ground},
    Class{70, "vegetation", Truth::ignored},
    Class{71, "trunk", Truth::non_ground},
    Class{72, "terrain", Truth::ground},
    Class{80, "pole", Truth::non_ground},
    Class{81, "traffic-sign", Truth::non_ground},
    Class{99, "other-object", Truth::non_ground},
    Class{252, "moving-car", Truth::non_ground},
    Class{253, "moving-bicyclist", Truth::non_ground},
    Class{254, "moving-person", Truth::non_ground},
    Class{255, "moving-motorcyclist", Truth::non_ground},
    Class{256, "moving-on-rails", Truth::non_ground},
    Class{257, "moving-bus", Truth::non_ground},
    Class{258, "moving-truck", Truth::non_ground},
    Class{259, "moving-other-vehicle", Truth::non_ground},
};

const Class* find_class(std::uint16_t number) {
  const auto* const found = std::lower_bound(
      kClasses.begin(), kClasses.end(), number,
      [](const Class& entry, std::uint16_t wanted) { return entry.number < wanted; });
  return found != kClasses.end() && found->number == number ? found : nullptr;
}

}  // namespace

Truth truth_of(std::uint16_t semantic_kitti_class) {
  const Class* const known = find_class(semantic_kitti_class);
  return known != nullptr ? known->truth : Truth::non_ground;
}

std::string class_name(std::uint16_t semantic_kitti_class) {
  const Class* const known = find_class(semantic_kitti_class);
  return known != nullptr ? known->name : std::to_string(semantic_kitti_class);
}

const char* truth_name(Truth truth) {
  switch (truth) {
    case Truth::ground:
      return "ground";
    case Truth::non_ground:
      return "non-ground";
    case Truth::ignored:
      break;
  }
  return "ignored";
}

}  // namespace groundgrid::evaluation
