#include "rendering/perspective.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

#include "rendering/gl.hpp"
#include "rendering/offscreen.hpp"
#include "rendering/render_target.hpp"
#include "rendering/shader_program.hpp"

namespace groundgrid::rendering {
namespace {

// A picture is drawn twice as large and then averaged, so that edges are smooth.
constexpr int kOversampling = 2;

constexpr double kNear_m = 0.5;
constexpr double kFar_m = 20000.0;

const char* const kSceneVertex = R"(#version 330 core
layout(location = 0) in vec4 place_and_size;
layout(location = 1) in vec3 color_in;
uniform mat4 projection;
uniform float pixels_per_tangent;
uniform float least_point_px;
out vec3 color;
void main() {
  gl_Position = projection * vec4(place_and_size.xyz, 1.0);
  gl_PointSize = max(least_point_px, place_and_size.w * pixels_per_tangent / gl_Position.w);
  color = color_in;
})";

const char* const kSceneFragment = R"(#version 330 core
in vec3 color;
uniform int round_points;
out vec4 result;
void main() {
  if (round_points == 1 && length(gl_PointCoord - vec2(0.5)) > 0.5) discard;
  result = vec4(color, 1.0);
})";

const char* const kAllVertex = R"(#version 330 core
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
})";

// Eye-dome lighting (Boucheny): a pixel is the darker the more its neighbours are nearer.
const char* const kShadeFragment = R"(#version 330 core
uniform sampler2D colors;
uniform sampler2D depths;
uniform float near_m;
uniform float far_m;
uniform float strength;
uniform int reach_px;
out vec4 result;
float log_distance(ivec2 place) {
  float depth = 2.0 * texelFetch(depths, place, 0).r - 1.0;
  return log2(2.0 * near_m * far_m / (far_m + near_m - depth * (far_m - near_m)));
}
vec3 shaded(ivec2 place) {
  vec3 color = texelFetch(colors, place, 0).rgb;
  if (strength <= 0.0 || texelFetch(depths, place, 0).r >= 1.0) return color;
  ivec2 last = textureSize(depths, 0) - ivec2(1);
  float here = log_distance(place);
  float hidden = 0.0;
  for (int i = 0; i < 8; ++i) {
    float angle = 0.785398 * float(i);
    ivec2 other = place + ivec2(round(float(reach_px) * vec2(cos(angle), sin(angle))));
    // A plane that is seen at a flat angle has no edges.
    hidden += clamp(here - log_distance(clamp(other, ivec2(0), last)) - 0.01, 0.0, 0.15);
  }
  return color * max(0.25, exp(-strength * hidden));
}
void main() {
  ivec2 first = 2 * ivec2(gl_FragCoord.xy);
  result = vec4(0.25 * (shaded(first) + shaded(first + ivec2(1, 0)) + shaded(first + ivec2(0, 1)) +
                        shaded(first + ivec2(1, 1))),
                1.0);
})";

/// Vertices in OpenGL's memory, with how they lie there.
class VertexBuffer {
 public:
  explicit VertexBuffer(const std::vector<Vertex>& vertices) {
    glGenVertexArrays(1, &array_);
    glBindVertexArray(array_);
    glGenBuffers(1, &buffer_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)),
                 vertices.data(), GL_STATIC_DRAW);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
    // OpenGL takes an offset for a pointer.
    const void* const color =
        reinterpret_cast<const void*>(offsetof(Vertex, color));  // NOLINT(*-no-int-to-ptr)
    glVertexAttribPointer(1, 3, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Vertex), color);
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
  }
  ~VertexBuffer() {
    glDeleteBuffers(1, &buffer_);
    glDeleteVertexArrays(1, &array_);
  }
  VertexBuffer(const VertexBuffer&) = delete;
  VertexBuffer& operator=(const VertexBuffer&) = delete;
  VertexBuffer(VertexBuffer&&) = delete;
  VertexBuffer& operator=(VertexBuffer&&) = delete;

 private:
  GLuint array_ = 0;
  GLuint buffer_ = 0;
};

void draw_triangles(const Scene& scene) {
  if (scene.triangles.empty()) return;
  const VertexBuffer corners(scene.corners);
  GLuint indices = 0;
  glGenBuffers(1, &indices);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(scene.triangles.size() * sizeof(std::uint32_t)),
               scene.triangles.data(), GL_STATIC_DRAW);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(scene.triangles.size()), GL_UNSIGNED_INT,
                 nullptr);
  glDeleteBuffers(1, &indices);
}

void draw_points(const Scene& scene) {
  if (scene.points.empty()) return;
  const VertexBuffer points(scene.points);
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(scene.points.size()));
}

void draw_everywhere() {
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDeleteVertexArrays(1, &array);
}

double tangent_of_half_field(const Camera& camera) {
  return std::tan(camera.vertical_field_deg * std::numbers::pi / 360.0);
}

Eigen::Matrix4d view_of(const Camera& camera) {
  const Eigen::Vector3d back = (camera.eye - camera.target).normalized();
  const Eigen::Vector3d right = Eigen::Vector3d::UnitZ().cross(back).normalized();
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
  view.block<1, 3>(0, 0) = right;
  view.block<1, 3>(1, 0) = back.cross(right);
  view.block<1, 3>(2, 0) = back;
  view.block<3, 1>(0, 3) = -view.block<3, 3>(0, 0) * camera.eye;
  return view;
}

void check_errors() {
  if (const GLenum error = glGetError(); error != GL_NO_ERROR)
    throw std::runtime_error("OpenGL failed with error " + std::to_string(error));
}

}  // namespace

Eigen::Matrix4d projection_of(const Camera& camera, double aspect) {
  const double tangent = tangent_of_half_field(camera);
  Eigen::Matrix4d projection = Eigen::Matrix4d::Zero();
  projection(0, 0) = 1.0 / (tangent * aspect);
  projection(1, 1) = 1.0 / tangent;
  projection(2, 2) = -(kFar_m + kNear_m) / (kFar_m - kNear_m);
  projection(2, 3) = -2.0 * kFar_m * kNear_m / (kFar_m - kNear_m);
  projection(3, 2) = -1.0;
  return projection * view_of(camera);
}

class PerspectiveRenderer::Programs {
 public:
  [[nodiscard]] const ShaderProgram& scene() const { return scene_; }
  [[nodiscard]] const ShaderProgram& shade() const { return shade_; }

 private:
  OffscreenContext context_{};
  ShaderProgram scene_{kSceneVertex, kSceneFragment};
  ShaderProgram shade_{kAllVertex, kShadeFragment};
};

PerspectiveRenderer::PerspectiveRenderer() : programs_(std::make_unique<Programs>()) {}
PerspectiveRenderer::~PerspectiveRenderer() = default;

Image PerspectiveRenderer::draw(const Scene& scene, const Camera& camera, ImageSize size) const {
  const ImageSize large{kOversampling * size.width, kOversampling * size.height};
  const RenderTarget drawn(large);
  const RenderTarget result(size);
  const Eigen::Matrix4f projection =
      projection_of(camera, static_cast<double>(size.width) / size.height).cast<float>();

  drawn.begin();
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_PROGRAM_POINT_SIZE);
  programs_->scene().use();
  programs_->scene().set_matrix("projection", projection.data());
  programs_->scene().set("pixels_per_tangent",
                         static_cast<float>(large.height / 2.0 / tangent_of_half_field(camera)));
  programs_->scene().set("least_point_px",
                         static_cast<float>(kOversampling * scene.least_point_px));
  programs_->scene().set("round_points", 0);
  draw_triangles(scene);
  programs_->scene().set("round_points", 1);
  draw_points(scene);

  result.begin();
  glDisable(GL_DEPTH_TEST);
  drawn.bind_textures();
  programs_->shade().use();
  programs_->shade().set("colors", 0);
  programs_->shade().set("depths", 1);
  programs_->shade().set("near_m", static_cast<float>(kNear_m));
  programs_->shade().set("far_m", static_cast<float>(kFar_m));
  programs_->shade().set("strength", static_cast<float>(scene.depth_shading));
  programs_->shade().set("reach_px", 1 + large.height / 700);
  draw_everywhere();
  Image image = result.read();
  check_errors();
  return image;
}

}  // namespace groundgrid::rendering
