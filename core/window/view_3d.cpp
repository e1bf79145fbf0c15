#include "core/window/view_3d.h"

#include <epoxy/gl.h>

#include "core/window/gl_program.h"

namespace seesaw {

namespace {

const char* const vertex_stage = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;
uniform mat4 camera_from_scene, clip_from_camera;
uniform vec4 plain_color;
uniform float has_colors, size, lift;
out vec3 at_camera, normal_camera;
out vec4 shown;
void main() {
  vec4 p = camera_from_scene * vec4(position, 1.0);
  at_camera = p.xyz;
  normal_camera = mat3(camera_from_scene) * normal;
  shown = has_colors > 0.5 ? color : plain_color;
  gl_Position = clip_from_camera * p;
  gl_Position.z += lift * clip_from_camera[3][2];
  gl_PointSize = size + 1.0;
}
)";

// A normal of length zero is none: the facet's own is then taken from how the position changes.
const char* const triangle_stage = R"(
in vec3 at_camera, normal_camera;
in vec4 shown;
uniform float opacity, lit;
out vec4 result;
void main() {
  vec3 n = dot(normal_camera, normal_camera) > 0.0 ? normal_camera : cross(dFdx(at_camera), dFdy(at_camera));
  n = normalize(n);
  vec3 to_eye = normalize(-at_camera);
  if (dot(n, to_eye) < 0.0) n = -n;
  vec3 to_light = normalize(vec3(-0.4, 0.7, 1.0));
  float diffuse = max(dot(n, to_light), 0.0);
  float shine = pow(max(dot(n, normalize(to_light + to_eye)), 0.0), 40.0);
  vec3 shaded = shown.rgb * (0.45 + 0.55 * diffuse) + 0.08 * shine;
  result = vec4(lit > 0.5 ? shaded : shown.rgb, shown.a * opacity);
}
)";

// A segment becomes a strip as wide as asked, cut at the near plane, where a division by w would turn it
// inside out.
const char* const segment_stage = R"(
layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;
in vec4 shown[];
uniform vec2 pixels;
uniform float size;
out vec4 color;
noperspective out float aside;
void main() {
  vec4 a = gl_in[0].gl_Position, b = gl_in[1].gl_Position;
  vec4 color_a = shown[0], color_b = shown[1];
  float da = a.z + a.w, db = b.z + b.w;
  if (da <= 0.0 && db <= 0.0) return;
  if (da < 0.0) { float t = da / (da - db); a = mix(a, b, t); color_a = mix(color_a, color_b, t); }
  if (db < 0.0) { float t = db / (db - da); b = mix(b, a, t); color_b = mix(color_b, color_a, t); }
  vec2 along = (b.xy / b.w - a.xy / a.w) * pixels;
  float span = length(along);
  along = span > 0.0 ? along / span : vec2(1.0, 0.0);
  float reach = 0.5 * size + 0.5;
  vec2 across = vec2(-along.y, along.x) * 2.0 * reach / pixels;
  for (int i = 0; i < 4; ++i) {
    vec4 p = i < 2 ? a : b;
    float side = i % 2 == 0 ? -1.0 : 1.0;
    color = i < 2 ? color_a : color_b;
    aside = side * reach;
    gl_Position = vec4(p.xy + side * across * p.w, p.z, p.w);
    EmitVertex();
  }
  EndPrimitive();
}
)";

const char* const line_stage = R"(
in vec4 color;
noperspective in float aside;
uniform float opacity, size;
out vec4 result;
void main() {
  result = vec4(color.rgb, color.a * opacity * clamp(0.5 * size + 0.5 - abs(aside), 0.0, 1.0));
}
)";

const char* const point_stage = R"(
in vec4 shown;
uniform float opacity, size, lit;
out vec4 result;
void main() {
  vec2 p = (gl_PointCoord - 0.5) * (size + 1.0);
  float cover = clamp(0.5 * size + 0.5 - length(p), 0.0, 1.0);
  if (cover == 0.0) discard;
  vec2 q = p / (0.5 * size + 0.5);
  vec3 n = vec3(q.x, -q.y, sqrt(max(1.0 - dot(q, q), 0.0)));
  float diffuse = max(dot(n, normalize(vec3(-0.4, 0.7, 1.0))), 0.0);
  result = vec4(lit > 0.5 ? shown.rgb * (0.45 + 0.55 * diffuse) : shown.rgb, shown.a * opacity * cover);
}
)";

}  // namespace

struct View3D::Programs {
  detail::GlProgram triangles{vertex_stage, "", triangle_stage};
  detail::GlProgram segments{vertex_stage, segment_stage, line_stage};
  detail::GlProgram points{vertex_stage, "", point_stage};
  const detail::GlProgram& of(Drawable::Kind kind) const {
    return kind == Drawable::Kind::triangles  ? triangles
           : kind == Drawable::Kind::segments ? segments
                                              : points;
  }
};

View3D::View3D(int samples) : target_(samples), programs_(std::make_unique<Programs>()) {}
View3D::~View3D() = default;

void View3D::begin(int width, int height, const OrbitCamera& camera, const Color& background) {
  target_.begin(width, height);
  camera_from_scene_ = camera.camera_from_scene();
  clip_from_camera_ = camera.clip_from_camera(width, height);
  glDisable(GL_SCISSOR_TEST);
  glDepthMask(GL_TRUE);
  glClearColor(static_cast<float>(background.r), static_cast<float>(background.g),
               static_cast<float>(background.b), 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glEnable(GL_PROGRAM_POINT_SIZE);
}

void View3D::draw(const Drawable& what, const DrawLook& look) {
  if (what.empty()) return;
  const detail::GlProgram& program = programs_->of(what.kind());
  program.use();
  program.set("camera_from_scene", camera_from_scene_);
  program.set("clip_from_camera", clip_from_camera_);
  program.set("plain_color", look.color.r, look.color.g, look.color.b, look.color.a);
  program.set("has_colors", what.has_colors() ? 1 : 0);
  program.set("opacity", look.opacity);
  program.set("lit", look.lit ? 1 : 0);
  program.set("size", look.size);
  program.set("lift", what.kind() == Drawable::Kind::triangles ? 0 : look.lift);
  program.set("pixels", target_.width(), target_.height());
  glDepthMask(look.opacity < 1 ? GL_FALSE : GL_TRUE);
  what.draw();
  glDepthMask(GL_TRUE);
}

const Texture& View3D::end() {
  glDisable(GL_DEPTH_TEST);
  glUseProgram(0);
  target_.finish();
  return target_.texture();
}

}  // namespace seesaw
