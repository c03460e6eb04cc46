#pragma once

#include <yaml-cpp/yaml.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <vector>

namespace groundgrid::test {

/// The `learning_map` of a configuration of semantic-kitti-api as it is applied there: by the lower
/// 16 bits of a label, numbers that are not listed become 0.
class LearningMap {
 public:
  explicit LearningMap(const YAML::Node& configuration) {
    for (const auto& entry : configuration["learning_map"])
      classes_[entry.first.as<std::uint32_t>()] = entry.second.as<std::uint32_t>();
  }

  [[nodiscard]] std::uint32_t operator()(std::uint32_t label) const {
    const auto found = classes_.find(label & 0xFFFFU);
    return found == classes_.end() ? 0 : found->second;
  }

  [[nodiscard]] const std::map<std::uint32_t, std::uint32_t>& classes() const { return classes_; }

 private:
  std::map<std::uint32_t, std::uint32_t> classes_;
};

/// What semantic-kitti-api's evaluate_semantics.py computes for three classes of which class 0 is
/// ignored, told in our words. Points are counted by predicted and true class. Points whose truth
/// is ignored are then taken out; those with an ignored prediction stay, as misses of their true
/// class. Accuracy is taken over the points that were predicted to be of a class that counts.
class SemanticKittiApi {
 public:
  static constexpr std::size_t kGround = 1;
  static constexpr std::size_t kNonGround = 2;

  explicit SemanticKittiApi(const std::filesystem::path& configuration)
      : map_(YAML::LoadFile(configuration.string())) {}

  void add(std::span<const std::uint32_t> predicted, std::span<const std::uint32_t> truth) {
    for (std::size_t i = 0; i < truth.size(); ++i)
      ++counts_.at(map_(predicted[i])).at(map_(truth[i]));
  }

  [[nodiscard]] std::uint64_t count(std::size_t predicted, std::size_t truth) const {
    return counts_.at(predicted).at(truth);
  }

  [[nodiscard]] double iou(std::size_t wanted) const {
    std::uint64_t either = 0;
    for (std::size_t predicted = 0; predicted < 3; ++predicted)
      for (const std::size_t truth : {kGround, kNonGround})
        if (predicted == wanted || truth == wanted) either += count(predicted, truth);
    return static_cast<double>(count(wanted, wanted)) / static_cast<double>(either);
  }

  [[nodiscard]] double accuracy() const {
    const auto right = count(kGround, kGround) + count(kNonGround, kNonGround);
    const auto wrong = count(kGround, kNonGround) + count(kNonGround, kGround);
    return static_cast<double>(right) / static_cast<double>(right + wrong);
  }

 private:
  LearningMap map_;
  std::array<std::array<std::uint64_t, 3>, 3> counts_{};  ///< By predicted, then true class.
};

}  // namespace groundgrid::test
