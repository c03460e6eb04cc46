// The only file that knows Embree, of version 3 or 4.
#include "simulation/ray_caster.hpp"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <stdexcept>
#include <string>

namespace groundgrid::simulation {
namespace {

// On one thread the hierarchy, and with it the choice between two triangles that meet in an edge,
// is always the same.
constexpr const char* kDeviceConfig = "threads=1";

struct ReleaseDevice {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
using DevicePtr = std::unique_ptr<std::remove_pointer_t<RTCDevice>, ReleaseDevice>;

struct ReleaseScene {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using ScenePtr = std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseScene>;

void check(RTCDevice device) {
  if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE)
    throw std::runtime_error("Embree reports error " + std::to_string(static_cast<int>(error)));
}

template <typename Element>
void copy_to(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
             const std::vector<Element>& elements) {
  void* const memory =
      rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Element), elements.size());
  if (memory != nullptr && !elements.empty())
    std::copy(elements.begin(), elements.end(), static_cast<Element*>(memory));
}

void attach(RTCDevice device, RTCScene scene, const Mesh& mesh, unsigned index) {
  RTCGeometry const geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  copy_to(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.vertices);
  copy_to(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.triangles);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, index);
  rtcReleaseGeometry(geometry);
}

RTCRayHit to_embree(const Ray& ray, double least_m, double most_m) {
  RTCRayHit query{};
  query.ray.org_x = static_cast<float>(ray.origin.x());
  query.ray.org_y = static_cast<float>(ray.origin.y());
  query.ray.org_z = static_cast<float>(ray.origin.z());
  query.ray.dir_x = static_cast<float>(ray.direction.x());
  query.ray.dir_y = static_cast<float>(ray.direction.y());
  query.ray.dir_z = static_cast<float>(ray.direction.z());
  query.ray.tnear = static_cast<float>(least_m);
  query.ray.tfar = static_cast<float>(most_m);
  query.ray.mask = ~0U;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  return query;
}

void intersect(RTCScene scene, RTCRayHit& query) {
#if RTC_VERSION >= 40000
  rtcIntersect1(scene, &query);
#else
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &query);
#endif
}

}  // namespace

struct RayCaster::Scene {
  DevicePtr device;
  ScenePtr scene;
};

RayCaster::RayCaster(const std::vector<const Mesh*>& meshes) : scene_(std::make_unique<Scene>()) {
  scene_->device.reset(rtcNewDevice(kDeviceConfig));
  if (!scene_->device) check(nullptr);
  scene_->scene.reset(rtcNewScene(scene_->device.get()));
  rtcSetSceneFlags(scene_->scene.get(), RTC_SCENE_FLAG_ROBUST);
  for (std::size_t i = 0; i < meshes.size(); ++i)
    attach(scene_->device.get(), scene_->scene.get(), *meshes[i], static_cast<unsigned>(i));
  rtcCommitScene(scene_->scene.get());
  check(scene_->device.get());
}

RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

std::optional<Hit> RayCaster::cast(const Ray& ray, double least_m, double most_m) const {
  RTCRayHit query = to_embree(ray, least_m, most_m);
  intersect(scene_->scene.get(), query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const Eigen::Vector3f normal(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z);
  return Hit{static_cast<double>(query.ray.tfar), query.hit.geomID, query.hit.primID,
             normal.cast<double>().normalized()};
}

}  // namespace groundgrid::simulation
