// SPDX-License-Identifier: Apache-2.0
#include "studio/surface_view.h"

#include <QElapsedTimer>
#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QSurfaceFormat>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dorsum {
namespace {

constexpr double kSmooth_ms = 8.0;            // a frame's drawing while the view moves
constexpr std::size_t kLeastPoints = 20'000;  // so many are drawn even so
constexpr int kRest_ms = 200;                 // after which a view that does not move rests
constexpr double kAim_px = 6.0;
const std::array<std::uint8_t, 4> kMark = {255, 20, 190, 255};  // a hue that no colour scale has

constexpr const char* kVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 colour;
uniform mat4 clip_from_world;
uniform mat3 view_from_world;
uniform float dot_size;
uniform float lift;
out vec3 turned;
out vec3 shade;
void main() {
  gl_Position = clip_from_world * vec4(position, 1.0);
  gl_Position.z -= lift * gl_Position.w;
  gl_PointSize = dot_size;
  turned = view_from_world * normal;
  shade = colour.rgb;
})";

// A key light from above left, a weaker one from the right; both sides of a face are lit. The colours stay
// readable in the shade.
constexpr const char* kFragmentShader = R"(#version 330 core
in vec3 turned;
in vec3 shade;
uniform bool lit;
uniform bool round_dots;
out vec4 colour;
void main() {
  if (round_dots && length(gl_PointCoord - vec2(0.5)) > 0.5) discard;
  float light = 1.0;
  if (lit) {
    vec3 n = normalize(turned);
    if (n.z < 0.0) n = -n;
    light = 0.34 + 0.56 * max(dot(n, normalize(vec3(-0.5, 0.7, 0.8))), 0.0)
                 + 0.22 * max(dot(n, normalize(vec3(0.9, 0.1, 0.5))), 0.0);
  }
  colour = vec4(min(shade * light, vec3(1.0)), 1.0);
})";

std::vector<SceneVertex> Dots(const std::vector<Eigen::Vector3d>& places) {
  std::vector<SceneVertex> dots;
  for (const Eigen::Vector3d& p : places) {
    SceneVertex dot;
    for (std::size_t i = 0; i < 3; ++i) dot.position[i] = static_cast<float>(p[static_cast<int>(i)]);
    dot.normal = {0.0F, 0.0F, 1.0F};
    dot.colour = kMark;
    dots.push_back(dot);
  }
  return dots;
}

}  // namespace

SurfaceView::SurfaceView(QWidget* parent)
    : QWidget(parent), offscreen_(new QOffscreenSurface(nullptr, this)), context_(new QOpenGLContext(this)) {
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMinimumSize(fontMetrics().averageCharWidth() * 30, fontMetrics().height() * 10);
  rest_.setSingleShot(true);
  rest_.setInterval(kRest_ms);
  connect(&rest_, &QTimer::timeout, this, [this] {
    moving_ = false;
    Redraw();
  });
}

SurfaceView::~SurfaceView() { FreeGraphics(); }

void SurfaceView::FreeGraphics() {
  if (graphics_ != Graphics::kReady || !context_->makeCurrent(offscreen_)) return;
  for (Layer* layer : {&points_, &mesh_, &line_, &places_}) {
    layer->array.destroy();
    layer->vertices.destroy();
    layer->indices.destroy();
  }
  program_.removeAllShaders();
  target_.reset();
  resolved_.reset();
  context_->doneCurrent();
}

void SurfaceView::Redraw() {
  stale_ = true;
  update();
}

void SurfaceView::resizeEvent(QResizeEvent*) { Redraw(); }

void SurfaceView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) Redraw();
  QWidget::changeEvent(event);
}

void SurfaceView::SetBuffers(std::shared_ptr<const SceneBuffers> buffers, bool frame) {
  buffers_ = std::move(buffers);
  if (frame && buffers_) camera_.Frame(buffers_->low, buffers_->high);
  surface_changed_ = true;
  moving_ = false;
  Redraw();
}

void SurfaceView::SetShown(Shown shown) {
  shown_ = shown;
  Redraw();
}

void SurfaceView::SetMarks(const SceneMarks& marks) {
  marks_ = marks;
  marks_changed_ = true;
  Redraw();
}

QImage SurfaceView::Picture() {
  moving_ = false;
  Draw();
  update();
  return frame_;
}

// The context is made when it is first needed; makes it current.
bool SurfaceView::MakeReady() {
  if (graphics_ == Graphics::kUntried) {
    graphics_ = Prepare() ? Graphics::kReady : Graphics::kNone;
    if (graphics_ == Graphics::kNone) {
      const QString why =
          tr("this display has no OpenGL 3.3, so the surface cannot be drawn; measuring and export "
             "of files work without it");
      QMetaObject::invokeMethod(
          this, [this, why] { emit Unavailable(why); }, Qt::QueuedConnection);
    }
  }
  return graphics_ == Graphics::kReady && context_->makeCurrent(offscreen_);
}

bool SurfaceView::Prepare() {
  if (!context_->create()) return false;
  offscreen_->setFormat(context_->format());
  offscreen_->create();
  if (!offscreen_->isValid() || !context_->makeCurrent(offscreen_)) return false;
  surface_changed_ = marks_changed_ = true;
  return initializeOpenGLFunctions() &&
         program_.addShaderFromSourceCode(QOpenGLShader::Vertex, kVertexShader) &&
         program_.addShaderFromSourceCode(QOpenGLShader::Fragment, kFragmentShader) && program_.link();
}

void SurfaceView::Upload(Layer* layer, const std::vector<SceneVertex>& vertices,
                         const std::vector<std::uint32_t>& indices) {
  if (!layer->array.isCreated()) {
    layer->array.create();
    layer->vertices.create();
    layer->indices.create();
  }
  const QOpenGLVertexArrayObject::Binder binder(&layer->array);
  layer->vertices.bind();
  layer->vertices.allocate(vertices.data(), static_cast<int>(vertices.size() * sizeof(SceneVertex)));
  // OpenGL's way to say an offset. NOLINTNEXTLINE(performance-no-int-to-ptr)
  const auto place = [](std::size_t offset) { return reinterpret_cast<const void*>(offset); };
  for (GLuint i = 0; i < 3; ++i) glEnableVertexAttribArray(i);
  constexpr auto kStride = static_cast<GLsizei>(sizeof(SceneVertex));
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride, place(offsetof(SceneVertex, position)));
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, kStride, place(offsetof(SceneVertex, normal)));
  glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, place(offsetof(SceneVertex, colour)));
  layer->indices.bind();
  layer->indices.allocate(indices.data(), static_cast<int>(indices.size() * sizeof(std::uint32_t)));
  layer->count = static_cast<int>(indices.empty() ? vertices.size() : indices.size());
}

void SurfaceView::UploadAll() {
  if (surface_changed_) {
    static const SceneBuffers kEmpty;
    const SceneBuffers& buffers = buffers_ ? *buffers_ : kEmpty;
    Upload(&points_, buffers.points, {});
    Upload(&mesh_, buffers.vertices, buffers.triangles);
    if (buffers.triangles.empty()) mesh_.count = 0;
  }
  if (marks_changed_) {
    Upload(&line_, Dots(marks_.line), {});
    Upload(&places_, Dots(marks_.places), {});
  }
  if (surface_changed_) glFinish();  // so that the time of a frame is that of drawing alone
  surface_changed_ = marks_changed_ = false;
}

void SurfaceView::DrawDots(Layer* layer, int count, double size, bool lit) {
  if (count == 0) return;
  const QOpenGLVertexArrayObject::Binder binder(&layer->array);
  program_.setUniformValue("dot_size", static_cast<float>(size * devicePixelRatioF()));
  program_.setUniformValue("round_dots", size > 4.0);
  program_.setUniformValue("lit", lit);
  program_.setUniformValue("lift", lit ? 0.0F : 1e-3F);
  glDrawArrays(GL_POINTS, 0, count);
}

void SurfaceView::DrawLayers() {
  if (mesh_.count > 0 && shown_ != Shown::kPoints) {
    const QOpenGLVertexArrayObject::Binder binder(&mesh_.array);
    program_.setUniformValue("round_dots", false);
    program_.setUniformValue("lit", true);
    program_.setUniformValue("lift", 0.0F);
    glDrawElements(GL_TRIANGLES, mesh_.count, GL_UNSIGNED_INT, nullptr);
  }
  points_drawn_ = 0;
  if (shown_ != Shown::kMesh) {
    points_drawn_ = static_cast<std::size_t>(points_.count);
    if (moving_ && full_ms_ > kSmooth_ms && points_drawn_ > kLeastPoints) {
      const auto share = static_cast<std::size_t>(static_cast<double>(points_.count) * kSmooth_ms / full_ms_);
      points_drawn_ = std::max(share, kLeastPoints);
    }
    DrawDots(&points_, static_cast<int>(points_drawn_), 2.0, true);
  }
  DrawDots(&line_, line_.count, 3.5, false);
  DrawDots(&places_, places_.count, 9.0, false);
}

void SurfaceView::Draw() {
  const QSize size = (QSizeF(this->size()) * devicePixelRatioF()).toSize();
  if (size.isEmpty() || !MakeReady()) return;
  if (!target_ || target_->size() != size) {
    QOpenGLFramebufferObjectFormat format;
    resolved_ = std::make_unique<QOpenGLFramebufferObject>(size, format);
    format.setAttachment(QOpenGLFramebufferObject::Depth);
    format.setSamples(std::max(0, QSurfaceFormat::defaultFormat().samples()));
    target_ = std::make_unique<QOpenGLFramebufferObject>(size, format);
  }
  target_->bind();
  glViewport(0, 0, size.width(), size.height());
  DrawOnce();
  QOpenGLFramebufferObject::blitFramebuffer(resolved_.get(), target_.get());
  frame_ = resolved_->toImage();
  frame_.setDevicePixelRatio(devicePixelRatioF());
  context_->doneCurrent();
  stale_ = false;
}

void SurfaceView::paintEvent(QPaintEvent*) {
  const bool anew = stale_ || frame_.devicePixelRatio() != devicePixelRatioF();  // on another screen
  if (anew) Draw();
  QPainter painter(this);
  if (frame_.isNull()) {
    painter.fillRect(rect(), palette().color(QPalette::Window).darker(175));
  } else {
    painter.drawImage(rect(), frame_);
  }
  if (anew) emit Drawn();
}

void SurfaceView::DrawOnce() {
  UploadAll();
  // Stripes of all orders, the white one too, stand out from it in the light and in the dark theme.
  const QColor back = palette().color(QPalette::Window).darker(175);
  glClearColor(static_cast<float>(back.redF()), static_cast<float>(back.greenF()),
               static_cast<float>(back.blueF()), 1.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_PROGRAM_POINT_SIZE);
  program_.bind();
  const Eigen::Matrix4f clip = camera_.ClipFromWorld(Aspect());
  const Eigen::Matrix3f view = camera_.ViewFromWorld();
  glUniformMatrix4fv(program_.uniformLocation("clip_from_world"), 1, GL_FALSE, clip.data());
  glUniformMatrix3fv(program_.uniformLocation("view_from_world"), 1, GL_FALSE, view.data());
  QElapsedTimer timer;
  timer.start();
  DrawLayers();
  if (!moving_) {
    glFinish();
    full_ms_ = 1e-6 * static_cast<double>(timer.nsecsElapsed());
  }
  program_.release();
}

void SurfaceView::Moved() {
  moving_ = true;
  rest_.start();
  Redraw();
}

void SurfaceView::Turn(double yaw_deg, double pitch_deg) {
  camera_.Turn(yaw_deg, pitch_deg);
  Moved();
}

void SurfaceView::Aim(const QPointF& at) {
  const double x = 2.0 * at.x() / std::max(width(), 1) - 1.0, y = 1.0 - 2.0 * at.y() / std::max(height(), 1);
  const double slope = kAim_px * camera_.HeightAtTarget() / camera_.distance() / std::max(height(), 1);
  emit Aimed(camera_.Through(x, y, Aspect()), slope);
}

void SurfaceView::mousePressEvent(QMouseEvent* event) { pressed_ = last_ = event->position(); }

void SurfaceView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF d = event->position() - last_;
  last_ = event->position();
  const bool pan = (event->buttons() & (Qt::RightButton | Qt::MiddleButton)) != 0 ||
                   (event->modifiers() & Qt::ShiftModifier) != 0;
  if (event->buttons() == Qt::NoButton) return;
  if (pan) {
    camera_.Pan(-d.x() / std::max(height(), 1), d.y() / std::max(height(), 1));
  } else {
    camera_.Turn(-360.0 * d.x() / std::max(width(), 1), 180.0 * d.y() / std::max(height(), 1));
  }
  Moved();
}

void SurfaceView::mouseReleaseEvent(QMouseEvent* event) {
  const bool still = (event->position() - pressed_).manhattanLength() < 4.0;
  if (still && event->button() == Qt::LeftButton) Aim(event->position());
}

void SurfaceView::wheelEvent(QWheelEvent* event) {
  camera_.Zoom(std::pow(1.0015, event->angleDelta().y()));
  Moved();
}

void SurfaceView::keyPressEvent(QKeyEvent* event) {
  const bool pan = (event->modifiers() & Qt::ShiftModifier) != 0;
  const auto go = [&](double right, double up) {
    if (pan) {
      camera_.Pan(0.05 * right, 0.05 * up);
    } else {
      camera_.Turn(5.0 * right, 5.0 * up);
    }
    Moved();
  };
  switch (event->key()) {
    case Qt::Key_Left:
      return go(-1.0, 0.0);
    case Qt::Key_Right:
      return go(1.0, 0.0);
    case Qt::Key_Up:
      return go(0.0, 1.0);
    case Qt::Key_Down:
      return go(0.0, -1.0);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      camera_.Zoom(1.15);
      return Moved();
    case Qt::Key_Minus:
      camera_.Zoom(1.0 / 1.15);
      return Moved();
    case Qt::Key_Home:
      camera_.Home();
      return Moved();
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return Aim(QRectF(rect()).center());
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace dorsum
