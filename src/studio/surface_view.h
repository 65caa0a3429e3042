// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLBuffer>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <vector>

#include "studio/orbit_camera.h"
#include "studio/surface_scene.h"

namespace dorsum {

// A surface in perspective under two lights, turned by mouse or keys. Vertices go to the graphics card when
// they change, never for a frame. Where drawing all points takes too long for a smooth movement, a spread
// part of them is drawn as long as the view moves, and all when it rests.
// Drawn aside and painted as a picture. A QOpenGLWidget would have OpenGL compose the whole window, on all
// pages: without a graphics card, beside a computation that takes all cores, for a third of a second.
class SurfaceView : public QWidget, protected QOpenGLFunctions_3_3_Core {
  Q_OBJECT

 public:
  explicit SurfaceView(QWidget* parent = nullptr);
  ~SurfaceView() override;

  // `frame`: look at it from the home view; else from where one looks now.
  void SetBuffers(std::shared_ptr<const SceneBuffers> buffers, bool frame);
  void SetShown(Shown shown);
  void SetMarks(const SceneMarks& marks);
  QImage Picture();  // as it is seen, all points drawn
  void Turn(double yaw_deg, double pitch_deg);

  const OrbitCamera& camera() const { return camera_; }
  std::size_t points_drawn() const { return points_drawn_; }  // in the last frame

 signals:
  // A person points at what the ray meets; a finger's or pixel's breadth is `slope` of the distance.
  void Aimed(const dorsum::Ray& ray, double slope);
  void Unavailable(const QString& why);  // no OpenGL 3.3 here
  void Drawn();                          // anew, and painted

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Layer {  // vertices on the graphics card
    QOpenGLVertexArrayObject array;
    QOpenGLBuffer vertices{QOpenGLBuffer::VertexBuffer}, indices{QOpenGLBuffer::IndexBuffer};
    int count = 0;  // of vertices, or of indices where there are some
  };
  enum class Graphics { kUntried, kReady, kNone };
  void Redraw();  // the picture is to be made anew
  bool MakeReady();
  bool Prepare();
  void Draw();      // frame_
  void DrawOnce();  // into the current target
  void Upload(Layer* layer, const std::vector<SceneVertex>& vertices,
              const std::vector<std::uint32_t>& indices);
  void UploadAll();
  void DrawLayers();
  void DrawDots(Layer* layer, int count, double size, bool lit);
  void Moved();
  void Aim(const QPointF& at);
  double Aspect() const { return static_cast<double>(width()) / std::max(height(), 1); }
  void FreeGraphics();

  std::shared_ptr<const SceneBuffers> buffers_;
  SceneMarks marks_;
  Shown shown_ = Shown::kMesh;
  OrbitCamera camera_;
  bool surface_changed_ = false, marks_changed_ = false, stale_ = true;
  Graphics graphics_ = Graphics::kUntried;
  QOffscreenSurface* offscreen_;
  QOpenGLContext* context_;  // owned as children are, so that it outlives the functions
  std::unique_ptr<QOpenGLFramebufferObject> target_, resolved_;  // target_ has samples
  QImage frame_;
  QOpenGLShaderProgram program_;
  Layer points_, mesh_, line_, places_;
  QTimer rest_;
  bool moving_ = false;
  double full_ms_ = 0.0;  // that drawing everything takes
  std::size_t points_drawn_ = 0;
  QPointF pressed_, last_;
};

}  // namespace dorsum
