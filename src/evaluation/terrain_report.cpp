#include "evaluation/terrain_report.hpp"

#include <fmt/format.h>

#include <cmath>

namespace groundgrid::evaluation {
namespace {

using Json = nlohmann::ordered_json;

std::string metres(double value, const char* format) {
  return std::isnan(value) ? std::string("-") : fmt::format(fmt::runtime(format), value);
}

std::string row(const std::string& name, const TerrainErrors& errors) {
  const double percent = 100.0 * errors.coverage();
  return fmt::format("{:<28} {:>10} {:>10} {:>10} {:>8} {:>8} {:>8} {:>8}\n", name, errors.cells,
                     errors.covered,
                     std::isnan(percent) ? std::string("-") : fmt::format("{:.2f}", percent),
                     metres(errors.rmse_m, "{:.3f}"), metres(errors.mae_m, "{:.3f}"),
                     metres(errors.bias_m, "{:+.3f}"), metres(errors.p95_m, "{:.3f}"));
}

std::string heading(const char* name) {
  return fmt::format("{:<28} {:>10} {:>10} {:>10} {:>8} {:>8} {:>8} {:>8}\n", name, "cells",
                     "covered", "% covered", "RMSE", "MAE", "bias", "95 %");
}

std::string bin_name(const TerrainBin& bin) {
  return std::isinf(bin.to) ? fmt::format("{:g} and more", bin.from)
                            : fmt::format("{:g}-{:g}", bin.from, bin.to);
}

std::string bin_table(const char* name, const std::vector<TerrainBin>& bins) {
  std::string text = heading(name);
  for (const TerrainBin& bin : bins) text += row(bin_name(bin), bin.errors);
  return text;
}

std::string in_words(const std::string& group) {
  if (group == "unseen_near") return fmt::format("unseen, seen within {:g} m", kGap_m);
  return group == "unseen_far" ? std::string("unseen, farther") : group;
}

std::string density_table(const TerrainFigures& figures) {
  std::string text = heading("all cells");
  if (figures.by_density) {
    const ErrorsByDensity& groups = *figures.by_density;
    text += row("dense", groups.dense);
    text += row("sparse", groups.sparse);
    text += row(in_words("unseen_near"), groups.unseen_near);
    text += row(in_words("unseen_far"), groups.unseen_far);
  }
  text += row("all", figures.all);
  if (figures.paper) text += row("the paper's selection", *figures.paper);
  return text;
}

std::string percent(double share) {
  return std::isnan(share) ? std::string("-") : fmt::format("{:.1f}", 100.0 * share);
}

std::string calibration_table(const std::vector<GroupCalibration>& groups) {
  std::string text = fmt::format("{:<28} {:>10} {:>10} {:>10} {:>10}\n", "standard deviation",
                                 "cells", "median", "% in one", "% in two");
  for (const GroupCalibration& group : groups)
    text += fmt::format("{:<28} {:>10} {:>10} {:>10} {:>10}\n", in_words(group.group),
                        group.figures.cells, metres(group.figures.median_m, "{:.3f}"),
                        percent(group.figures.within_one), percent(group.figures.within_two));
  return text;
}

std::string mask_table(const std::vector<MaskErrors>& masks) {
  std::string text = heading("mask");
  for (const MaskErrors& mask : masks) text += row(mask.name, mask.errors);
  return text;
}

std::string offset_words(const VerticalOffset& offset) {
  if (offset.cells == 0) return "No cell has both an estimated and a reference height.";
  return fmt::format("Vertical offset {:+.3f} m, the median of {} {}cells; {}.", offset.median_m,
                     offset.cells, offset.of_dense ? "dense " : "",
                     offset.taken_out ? "taken out of all figures" : "left in all figures");
}

std::string introduction(const TerrainReport& report) {
  std::string text = fmt::format("{}\nagainst {}\n", report.map, report.reference);
  for (const std::string& remark : report.remarks) text += fmt::format("! {}\n", remark);
  text += fmt::format("{} x {} cells of {:g} m x {:g} m; {} have a height but no reference.\n",
                      report.lattice.columns, report.lattice.rows, report.lattice.cell_width_m,
                      report.lattice.cell_height_m, report.figures.without_reference);
  text += offset_words(report.figures.offset);
  return text +
         "\nErrors are estimate less reference, in metres, over the cells that are covered.\n";
}

Json errors_json(const TerrainErrors& errors) {
  return {{"cells", errors.cells},   {"covered", errors.covered}, {"coverage", errors.coverage()},
          {"rmse_m", errors.rmse_m}, {"mae_m", errors.mae_m},     {"bias_m", errors.bias_m},
          {"p95_m", errors.p95_m}};
}

Json density_json(const ErrorsByDensity& groups) {
  return {{"dense", errors_json(groups.dense)},
          {"sparse", errors_json(groups.sparse)},
          {"unseen_near", errors_json(groups.unseen_near)},
          {"unseen_far", errors_json(groups.unseen_far)}};
}

Json calibration_json(const std::vector<GroupCalibration>& groups) {
  Json json;
  for (const GroupCalibration& group : groups)
    json[group.group] = {{"cells", group.figures.cells},
                         {"median_m", group.figures.median_m},
                         {"within_one", group.figures.within_one},
                         {"within_two", group.figures.within_two}};
  return json;
}

Json bins_json(const std::vector<TerrainBin>& bins, const char* from, const char* to) {
  Json rows = Json::array();
  for (const TerrainBin& bin : bins) {
    Json json{{from, bin.from}, {to, std::isinf(bin.to) ? Json(nullptr) : Json(bin.to)}};
    json.update(errors_json(bin.errors));
    rows.push_back(json);
  }
  return rows;
}

Json masks_json(const std::vector<MaskErrors>& masks) {
  Json rows = Json::array();
  for (const MaskErrors& mask : masks) {
    Json json{{"mask", mask.name}};
    json.update(errors_json(mask.errors));
    rows.push_back(json);
  }
  return rows;
}

}  // namespace

std::string to_table(const TerrainReport& report) {
  const TerrainFigures& figures = report.figures;
  std::string text = fmt::format("{}\n{}", introduction(report), density_table(figures));
  if (!figures.calibration.empty())
    text += fmt::format("\n{}", calibration_table(figures.calibration));
  if (!figures.by_path_distance.empty())
    text += fmt::format("\n{}", bin_table("distance from the path, m", figures.by_path_distance));
  text += fmt::format("\n{}", bin_table("slope of the reference, %", figures.by_slope));
  if (!figures.by_mask.empty()) text += fmt::format("\n{}", mask_table(figures.by_mask));
  return text;
}

Json to_json(const TerrainReport& report) {
  const TerrainFigures& figures = report.figures;
  const VerticalOffset& offset = figures.offset;
  Json json;
  json["map"] = report.map;
  json["reference"] = report.reference;
  json["columns"] = report.lattice.columns;
  json["rows"] = report.lattice.rows;
  json["cell_width_m"] = report.lattice.cell_width_m;
  json["cell_height_m"] = report.lattice.cell_height_m;
  json["cells_without_reference"] = figures.without_reference;
  json["offset"] = {{"median_m", offset.median_m},
                    {"cells", offset.cells},
                    {"of", offset.of_dense ? "dense" : "all"},
                    {"taken_out", offset.taken_out}};
  json["all"] = errors_json(figures.all);
  json["density"] = figures.by_density ? density_json(*figures.by_density) : Json(nullptr);
  json["paper_selection"] = figures.paper ? errors_json(*figures.paper) : Json(nullptr);
  json["standard_deviation"] =
      figures.calibration.empty() ? Json(nullptr) : calibration_json(figures.calibration);
  json["path_distance"] = figures.by_path_distance.empty()
                              ? Json(nullptr)
                              : bins_json(figures.by_path_distance, "from_m", "to_m");
  json["slope"] = bins_json(figures.by_slope, "from_percent", "to_percent");
  json["masks"] = masks_json(figures.by_mask);
  json["remarks"] = report.remarks;
  return json;
}

}  // namespace groundgrid::evaluation
