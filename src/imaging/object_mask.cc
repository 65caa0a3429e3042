// SPDX-License-Identifier: Apache-2.0
#include "imaging/object_mask.h"

#include <algorithm>
#include <stdexcept>

#include <opencv2/imgproc.hpp>

#include "base/parallel.h"
#include "imaging/band_cut.h"
#include "imaging/led_ratio.h"
#include "imaging/object_outline.h"
#include "imaging/pieces.h"
#include "imaging/seed_light.h"
#include "imaging/seed_map.h"
#include "imaging/stage_sink.h"

namespace dorsum {
namespace {

constexpr int kReach = 3;             // px: how far the outline on double pixels may be off
constexpr float kFineTexture = 0.7F;  // single pixels differ less than double ones, though noise is more
constexpr float kBridgePull = 0.03F;  // px of outline for each pixel that may be a ring

// What is not known to be empty; begins at a whole pixel of double size.
cv::Rect BusyPart(const cv::Mat& empty, cv::Size picture) {
  const cv::Rect whole({0, 0}, picture);
  if (empty.empty()) return whole;
  const cv::Rect busy = cv::boundingRect(empty == 0);
  if (busy.empty()) return whole;
  return {cv::Point(busy.x / 2 * 2, busy.y / 2 * 2), busy.br()};
}

// Seeds by their places in a part of the picture; those outside lie beyond its borders.
std::vector<ObjectSeed> SeedsWithin(std::vector<ObjectSeed> seeds, const cv::Rect& part) {
  for (ObjectSeed& seed : seeds) {
    seed.u -= static_cast<float>(part.x);
    seed.v -= static_cast<float>(part.y);
  }
  return seeds;
}

void MoveBy(cv::Point by, Outlines* outlines) {
  for (auto& outline : *outlines) {
    for (cv::Point2f& p : outline) p += cv::Point2f(by);
  }
}

// Where no seed of the object is nearer than about 30 px, in squares of 8 px.
cv::Mat FarFromObject(const cv::Mat& votes) {
  constexpr int kSquare = 8, kSquares = 4;
  const cv::Size squares((votes.cols + kSquare - 1) / kSquare, (votes.rows + kSquare - 1) / kSquare);
  cv::Mat1b near(squares, std::uint8_t{0});
  for (int v = 0; v < votes.rows; ++v) {
    const auto* row = votes.ptr<float>(v);
    auto* out = near.ptr<std::uint8_t>(v / kSquare);
    for (int u = 0; u < votes.cols; ++u) {
      if (row[u] > 0.0F) out[u / kSquare] = 255;
    }
  }
  constexpr int kSide = 2 * kSquares + 1;
  cv::dilate(near, near, cv::getStructuringElement(cv::MORPH_ELLIPSE, {kSide, kSide}));
  cv::Mat large;
  cv::resize(near, large, {squares.width * kSquare, squares.height * kSquare}, 0, 0, cv::INTER_NEAREST);
  return large(cv::Rect({0, 0}, votes.size())) == 0;
}

// Far from the object's stripes what has not changed is backplane, whether or not a stripe lies there.
void SettleUnchanged(const cv::Mat& light, const cv::Mat& votes, cv::Mat* known) {
  constexpr float kUnchanged = 0.05F;  // of the light's root
  const cv::Mat settled = FarFromObject(votes) & (light > 1.0F - kUnchanged) & (light < 1.0F + kUnchanged) &
                          (*known == kUnknownPixel);
  known->setTo(kBackplanePixel, settled);
}

// What speaks for the object at the unknown pixels of double size; the others' is not set.
cv::Mat CoarsePull(const SeedLight& near, const cv::Mat& light, const SeedMap& map,
                   const ObjectMaskOptions& options, const Context& context) {
  const auto like = static_cast<float>(options.pull), vote = static_cast<float>(0.5 * options.seed_strength);
  cv::Mat pull(light.size(), CV_32FC1);
  ParallelFor(context, 0, light.rows, [&](std::int64_t row) {
    const int v = static_cast<int>(row);
    const auto *known = map.known.ptr<std::uint8_t>(v), *bridge = map.bridge.ptr<std::uint8_t>(v);
    const auto *there = light.ptr<float>(v), *votes = map.votes.ptr<float>(v);
    auto* out = pull.ptr<float>(v);
    for (int u = 0; u < light.cols; ++u) {
      if (known[u] != kUnknownPixel) continue;
      out[u] = like * near.LikeObject(u, v, there[u]) + vote * votes[u];
      if (bridge[u] != 0) out[u] += kBridgePull;
    }
  });
  return pull;
}

// Pixels near the outline become unknown, the rest stays as it is.
cv::Mat OpenOutline(const cv::Mat& object, int reach_px) {
  const cv::Mat around = cv::getStructuringElement(cv::MORPH_RECT, {2 * reach_px + 1, 2 * reach_px + 1});
  cv::Mat grown, shrunk;
  cv::dilate(object, grown, around);
  cv::erode(object, shrunk, around);
  cv::Mat known(object.size(), CV_8UC1, cv::Scalar(kUnknownPixel));
  known.setTo(kObjectPixel, shrunk);
  known.setTo(kBackplanePixel, grown == 0);
  return known;
}

// Drops pieces of `mask` == `value` that hold fewer than `min_seeds` seeds of their kind and are smaller than
// `min_area` px.
void DropPieces(const cv::Mat& votes, std::uint8_t value, int min_seeds, double min_area, cv::Mat* mask) {
  struct Worth {
    int area = 0, seeds = 0;
  };
  const Pieces pieces(*mask, value);
  std::vector<Worth> worth(static_cast<std::size_t>(pieces.count()));
  const float sign = value != 0 ? 1.0F : -1.0F;
  for (const Pieces::Run& run : pieces.runs()) {
    const auto* vote = votes.ptr<float>(run.v);
    Worth& piece = worth[static_cast<std::size_t>(run.piece)];
    piece.area += run.end - run.first;
    for (int u = run.first; u < run.end; ++u) piece.seeds += sign * vote[u] > 0.0F ? 1 : 0;
  }
  for (const Pieces::Run& run : pieces.runs()) {
    const Worth& piece = worth[static_cast<std::size_t>(run.piece)];
    if (piece.seeds >= min_seeds || piece.area >= min_area) continue;
    auto* row = mask->ptr<std::uint8_t>(run.v);
    std::fill(row + run.first, row + run.end, value != 0 ? std::uint8_t{0} : std::uint8_t{255});
  }
}

// The part of the picture that holds the object, found on pixels of double size, and what lies around its
// outline; begins at a whole pixel of double size.
cv::Rect FinePart(const cv::Mat& object, cv::Size picture) {
  constexpr int kAround = 16;  // px
  const cv::Rect box = cv::boundingRect(object);
  if (box.empty()) return {};
  const cv::Rect grown(2 * box.x - kAround, 2 * box.y - kAround, 2 * box.width + 2 * kAround,
                       2 * box.height + 2 * kAround);
  return grown & cv::Rect({0, 0}, picture);
}

// The outlines on single pixels, within a part of the picture.
Outlines FineOutlines(const cv::Mat& light, const cv::Mat& object, const CellPicture& texture,
                      const std::vector<ObjectSeed>& seeds, const cv::Rect& part,
                      const ObjectMaskOptions& options, const Context& context) {
  const cv::Rect half(part.x / 2, part.y / 2, (part.width + 1) / 2, (part.height + 1) / 2);
  BandCut fine;
  fine.light = light(part);
  fine.texture = texture.Part(half.tl(), 2, kFineTexture);
  ParallelFor(context, 0, 2, [&](std::int64_t task) {
    if (task == 0) {
      cv::Mat large;
      cv::resize(object(half), large, {2 * half.width, 2 * half.height}, 0, 0, cv::INTER_NEAREST);
      fine.known = OpenOutline(large(cv::Rect({0, 0}, part.size())), kReach);
    } else {
      fine.pull = options.seed_strength * CountVotes(SeedsWithin(seeds, part), part.size(), 1);
    }
  });
  Outlines outlines = FindOutlines(CutInBand(fine, context), fine.light, fine.texture, context);
  MoveBy(part.tl(), &outlines);
  return outlines;
}

double ContradictingShare(const std::vector<ObjectSeed>& seeds, const cv::Mat& mask) {
  const cv::Rect image({0, 0}, mask.size());
  int wrong = 0, all = 0;
  for (const ObjectSeed& seed : seeds) {
    const cv::Point place(cv::Point2f(seed.u, seed.v));
    if (!image.contains(place)) continue;
    ++all;
    wrong += (mask.at<std::uint8_t>(place) != 0) != seed.object;
  }
  return all == 0 ? 0.0 : static_cast<double>(wrong) / all;
}

}  // namespace

ObjectLight FindObjectLight(const cv::Mat& background, const cv::Mat& hand, const cv::Mat& empty,
                            const Context& context) {
  const cv::Rect busy = BusyPart(empty, hand.size());
  ObjectLight light{.empty = empty, .busy = busy, .single = {}, .doubled = {}};
  ParallelFor(context, 0, 2, [&](std::int64_t task) {
    (task == 0 ? light.single : light.doubled) =
        LedRatio(background(busy), hand(busy), task == 0 ? 1 : 2, context);
  });
  return light;
}

Result<HandMask> RefineObjectMask(const cv::Mat& background, const cv::Mat& hand, const ObjectLight& light,
                                  const std::vector<ObjectSeed>& seeds, const ObjectMaskOptions& options,
                                  const Context& context) {
  if (background.type() != CV_8UC3 || hand.type() != CV_8UC3 || background.size() != hand.size())
    throw std::logic_error("RefineObjectMask: two CV_8UC3 pictures of one size are needed");
  const auto on_object = std::count_if(seeds.begin(), seeds.end(), [](const auto& s) { return s.object; });
  if (on_object < options.min_seeds) return ExtractHandMask(background, hand, options.picture_only, context);

  const cv::Rect busy = light.busy;
  const cv::Mat empty = light.empty;
  const std::vector<ObjectSeed> own = SeedsWithin(seeds, busy);
  BandCut coarse;
  coarse.light = light.doubled;
  SeedMap map = MapSeeds(own, coarse.light, 2, context);
  SettleUnchanged(coarse.light, map.votes, &map.known);
  if (!empty.empty()) {
    cv::Mat small;
    cv::resize(empty(busy), small, map.known.size(), 0, 0, cv::INTER_NEAREST);
    map.known.setTo(kBackplanePixel, small);
  }
  coarse.known = map.known;
  const SeedLight near(coarse.light, map.known, context);
  coarse.texture = near.usual_texture();
  coarse.pull = CoarsePull(near, coarse.light, map, options, context);
  cv::Mat object = CutInBand(coarse, context);
  DropPieces(map.votes, 255, 5, options.min_area_share * 0.25 * static_cast<double>(hand.total()), &object);
  DropPieces(map.votes, 0, 5, 40, &object);
  Sink(context, "mask/coarse", object);
  DORSUM_RETURN_IF_ERROR(context.CheckCancelled());

  HandMask result;
  const cv::Rect part = FinePart(object, busy.size());
  if (!part.empty()) {
    result.outlines = FineOutlines(light.single, object, coarse.texture, own, part, options, context);
    MoveBy(busy.tl(), &result.outlines);
  }
  result.mask = FillOutlines(result.outlines, hand.size(), context);
  result.area_share =
      static_cast<double>(cv::countNonZero(result.mask)) / static_cast<double>(result.mask.total());
  result.contradicting = ContradictingShare(seeds, result.mask);
  Sink(context, "mask/mask", result.mask);
  if (result.area_share < options.min_area_share) {
    return BadInput(
        "no object is seen: a few stripes seem to lie on one, but make no outline together with bgHand; put "
        "the "
        "hand down and capture again");
  }
  if (result.area_share > options.picture_only.max_area_share) {
    return BadInput(
        "the object seems to fill the picture, so its outline is not seen; look whether bgHand and the "
        "stripes "
        "are of one capture and the calibration is this device's");
  }
  return result;
}

}  // namespace dorsum
