// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QWidget>
#include <vector>

#include <opencv2/core.hpp>

namespace dorsum {

// A picture that is zoomed (wheel, + and -, 0 for all of it) and moved (mouse, arrows). Views can be linked,
// so that they show the same part of pictures of whatever size.
class PictureView : public QWidget {
  Q_OBJECT

 public:
  // What is looked at: the point in the middle, in shares of the picture; and how much larger than fitting.
  struct Look {
    QPointF centre{0.5, 0.5};
    double zoom = 1.0;  // 1 to 64
    bool operator==(const Look& other) const { return centre == other.centre && zoom == other.zoom; }
  };

  explicit PictureView(QWidget* parent = nullptr);

  // CV_8UC1 or CV_8UC3. An empty one shows the words instead.
  void SetPicture(const cv::Mat& picture, const QString& words = {});
  const QImage& picture() const { return image_; }
  QString words() const { return words_; }
  const Look& look() const { return look_; }
  void SetLook(const Look& look);
  static void Link(PictureView* one, PictureView* other);

  QSize sizeHint() const override;

 signals:
  void Looked(const dorsum::PictureView::Look& look);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  double Scale() const;  // of the picture on the screen
  void Zoom(double factor, QPointF fixed);
  void Move(QPointF by);  // px of the screen

  QImage image_;
  std::vector<QImage> smaller_;  // each half as large as the one before
  QString words_;
  Look look_;
  QPointF grabbed_;
};

}  // namespace dorsum
