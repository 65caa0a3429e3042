// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "calibration/board_coverage.h"
#include "studio/fitted_picture.h"

namespace dorsum {

// The live picture, over it the parts that chessboards have covered and the corners seen so far.
class CoverageView : public FittedPicture {
  Q_OBJECT

 public:
  using FittedPicture::FittedPicture;

  // `boards`: corners of each board, px. The last board's are drawn larger.
  void SetBoards(std::optional<BoardCoverage> coverage, std::vector<std::vector<cv::Point2f>> boards);
  void ShowGrid(bool shown);

 protected:
  void PaintOver(QPainter* painter, const QRectF& place) override;

 private:
  std::optional<BoardCoverage> coverage_;
  std::vector<std::vector<cv::Point2f>> boards_;
  bool grid_ = true;
};

}  // namespace dorsum
