#include "geotiff/raster_warp.hpp"

#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_alg.h>
#include <gdal_frmts.h>
#include <gdalwarper.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <string>

#include "geotiff/gdal_errors.hpp"
#include "geotiff/raster_file.hpp"
#include "io/error.hpp"

namespace groundgrid::geotiff {
namespace {

// How far the quick transformation may be off, in pixels.
constexpr double kTolerance = 0.001;

// Smaller by less than this is rounding.
constexpr double kFiner = 1.001;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

struct DestroyTransformer {
  void operator()(void* transformer) const { GDALDestroyTransformer(transformer); }
};
using TransformerPtr = std::unique_ptr<void, DestroyTransformer>;

struct DestroyWarpOptions {
  void operator()(GDALWarpOptions* options) const { GDALDestroyWarpOptions(options); }
};
using WarpOptionsPtr = std::unique_ptr<GDALWarpOptions, DestroyWarpOptions>;

OGRSpatialReference flat_crs(const std::string& wkt) {
  OGRSpatialReference crs;
  crs.importFromWkt(wkt.c_str());
  // Heights are not to be transformed.
  crs.StripVertical();
  crs.DemoteTo2D(nullptr);
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

std::string wkt_of(const OGRSpatialReference& crs) {
  char* text = nullptr;
  crs.exportToWkt(&text);
  std::string wkt = text == nullptr ? "" : text;
  CPLFree(text);
  return wkt;
}

struct Extent {
  double min_x = std::numeric_limits<double>::infinity();
  double max_x = -std::numeric_limits<double>::infinity();
  double min_y = std::numeric_limits<double>::infinity();
  double max_y = -std::numeric_limits<double>::infinity();

  void add(double x, double y) {
    min_x = std::min(min_x, x);
    max_x = std::max(max_x, x);
    min_y = std::min(min_y, y);
    max_y = std::max(max_y, y);
  }
  [[nodiscard]] std::string words() const {
    if (!(min_x <= max_x)) return "no place there at all";
    return fmt::format("x {:.1f} to {:.1f}, y {:.1f} to {:.1f}", min_x, max_x, min_y, max_y);
  }
};

/// One raster and the frame that it is brought onto.
class Warp {
 public:
  Warp(const std::filesystem::path& path, GDALDataset& source, const RasterFrame& onto)
      : path_(path), source_(source), onto_(onto), target_(make_target()) {
    make_transformer();
  }

  std::vector<float> run(Resampling resampling) {
    const WarpOptionsPtr options = options_for(resampling);
    GDALWarpOperation operation;
    if (operation.Initialize(options.get()) != CE_None ||
        operation.ChunkAndWarpImage(0, 0, onto_.columns, onto_.rows) != CE_None ||
        !errors_.first().empty())
      fail_to_read(path_, errors_.first());
    std::vector<float> values(static_cast<std::size_t>(onto_.columns) *
                              static_cast<std::size_t>(onto_.rows));
    if (target_->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, onto_.columns, onto_.rows, values.data(),
                                            onto_.columns, onto_.rows, GDT_Float32, 0, 0,
                                            nullptr) != CE_None)
      fail_to_read(path_, errors_.first());
    if (std::all_of(values.begin(), values.end(), [](float value) { return std::isnan(value); }))
      fail_without_overlap();
    return values;
  }

 private:
  DatasetPtr make_target() {
    DatasetPtr target(
        memory_driver().Create("", onto_.columns, onto_.rows, 1, GDT_Float32, nullptr));
    if (target == nullptr) throw std::bad_alloc();
    std::array<double, 6> transform = onto_.transform;
    target->SetGeoTransform(transform.data());
    target->GetRasterBand(1)->SetNoDataValue(static_cast<double>(kNaN));
    return target;
  }

  void make_transformer() {
    const std::string source_crs = frame_of(source_).crs;
    CPLStringList options;
    bool changes_crs = false;
    if (!source_crs.empty() && !onto_.crs.empty()) {
      const OGRSpatialReference from = flat_crs(source_crs);
      const OGRSpatialReference to = flat_crs(onto_.crs);
      changes_crs = from.IsSame(&to) == 0;
      if (changes_crs) {
        options.SetNameValue("SRC_SRS", wkt_of(from).c_str());
        options.SetNameValue("DST_SRS", wkt_of(to).c_str());
      }
    }
    // The target itself has no CRS, so that without these options x stays x and y stays y.
    exact_.reset(GDALCreateGenImgProjTransformer2(&source_, target_.get(), options.List()));
    if (exact_ == nullptr || !errors_.first().empty()) fail_to_transform();
    if (changes_crs)
      quick_.reset(GDALCreateApproxTransformer(GDALGenImgProjTransform, exact_.get(), kTolerance));
  }

  /// Pixels of the raster under one of the target's, along a side.
  [[nodiscard]] double pixels_a_side() const {
    const double column = onto_.columns / 2.0;
    const double row = onto_.rows / 2.0;
    std::array<double, 3> x{column, column + 1.0, column};
    std::array<double, 3> y{row, row, row + 1.0};
    std::array<double, 3> z{};
    std::array<int, 3> success{};
    GDALGenImgProjTransform(exact_.get(), TRUE, 3, x.data(), y.data(), z.data(), success.data());
    if (success[0] == 0 || success[1] == 0 || success[2] == 0) return 1.0;
    return std::sqrt(std::abs((x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0])));
  }

  [[nodiscard]] GDALResampleAlg algorithm(Resampling resampling) const {
    if (resampling == Resampling::nearest) return GRA_NearestNeighbour;
    return pixels_a_side() > kFiner ? GRA_Average : GRA_Bilinear;
  }

  [[nodiscard]] WarpOptionsPtr options_for(Resampling resampling) const {
    WarpOptionsPtr options(GDALCreateWarpOptions());
    options->hSrcDS = GDALDataset::ToHandle(&source_);
    options->hDstDS = GDALDataset::ToHandle(target_.get());
    options->eResampleAlg = algorithm(resampling);
    options->eWorkingDataType = GDT_Float32;
    options->pfnTransformer = quick_ ? GDALApproxTransform : GDALGenImgProjTransform;
    options->pTransformerArg = quick_ ? quick_.get() : exact_.get();
    GDALWarpInitDefaultBandMapping(options.get(), 1);
    set_holes(*options);
    options->papszWarpOptions = CSLSetNameValue(options->papszWarpOptions, "INIT_DEST", "NO_DATA");
    // Else the reach of the bilinear kernel would be guessed from the shapes of both windows.
    for (const char* const name : {"XSCALE", "YSCALE"})
      options->papszWarpOptions = CSLSetNameValue(options->papszWarpOptions, name, "1");
    return options;
  }

  void set_holes(GDALWarpOptions& options) const {
    GDALWarpInitDstNoDataReal(&options, static_cast<double>(kNaN));
    int has_no_data = 0;
    GDALRasterBand& band = *source_.GetRasterBand(1);
    const double no_data = band.GetNoDataValue(&has_no_data);
    // A mask of the whole raster is found by the warper itself.
    if (has_no_data == 0 && (band.GetMaskFlags() & GMF_PER_DATASET) != 0) return;
    GDALWarpInitSrcNoDataReal(&options, has_no_data != 0 ? no_data : static_cast<double>(kNaN));
  }

  [[nodiscard]] Extent extent_of_target() const {
    const std::array<double, 6>& t = onto_.transform;
    Extent extent;
    extent.add(t[0], t[3]);
    extent.add(t[0] + onto_.columns * t[1], t[3] + onto_.rows * t[5]);
    return extent;
  }

  /// Of the raster, in the frame's coordinates.
  [[nodiscard]] Extent extent_of_source() const {
    constexpr int kSteps = 20;
    const std::array<double, 6>& t = onto_.transform;
    Extent extent;
    for (int i = 0; i <= kSteps; ++i) {
      const double column = static_cast<double>(source_.GetRasterXSize()) * i / kSteps;
      const double row = static_cast<double>(source_.GetRasterYSize()) * i / kSteps;
      std::array<double, 4> x{column, column, 0.0, static_cast<double>(source_.GetRasterXSize())};
      std::array<double, 4> y{0.0, static_cast<double>(source_.GetRasterYSize()), row, row};
      std::array<double, 4> z{};
      std::array<int, 4> success{};
      GDALGenImgProjTransform(exact_.get(), FALSE, 4, x.data(), y.data(), z.data(), success.data());
      for (std::size_t k = 0; k < success.size(); ++k)
        if (success[k] != 0) extent.add(t[0] + x[k] * t[1], t[3] + y[k] * t[5]);
    }
    return extent;
  }

  [[noreturn]] void fail_without_overlap() const {
    throw io::Error(
        {.file = path_,
         .expected = fmt::format("values where the terrain lies ({})", extent_of_target().words()),
         .got = fmt::format("none there; in the terrain's frame it covers {}",
                            extent_of_source().words()),
         .remedy = "check that both lie in the same frame; segment puts a terrain into it with "
                   "--origin, --heading-deg and --crs"});
  }

  [[noreturn]] void fail_to_transform() const {
    const auto name = [](const std::string& wkt) {
      OGRSpatialReference crs;
      crs.importFromWkt(wkt.c_str());
      return fmt::format("'{}'", crs.GetName() == nullptr ? "?" : crs.GetName());
    };
    throw io::Error({.file = path_,
                     .expected = fmt::format("a reference system that can be transformed into {}",
                                             name(onto_.crs)),
                     .got = fmt::format("{}: {}", name(frame_of(source_).crs), errors_.first()),
                     .remedy = "bring both into one system with gdalwarp -t_srs, or set the right "
                               "one with gdal_edit.py -a_srs"});
  }

  const std::filesystem::path& path_;
  GDALDataset& source_;
  const RasterFrame& onto_;
  GdalErrors errors_{};
  DatasetPtr target_;
  TransformerPtr exact_{};
  TransformerPtr quick_{};
};

}  // namespace

std::vector<float> warp_band(const std::filesystem::path& path, GDALDataset& raster,
                             const RasterFrame& onto, Resampling resampling) {
  return Warp(path, raster, onto).run(resampling);
}

}  // namespace groundgrid::geotiff
