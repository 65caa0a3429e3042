// SPDX-License-Identifier: Apache-2.0
#include "simulator/hand_dressing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "simulator/hand_mesh.h"
#include "simulator/renderer.h"
#include "simulator/small_device_test.h"

namespace dorsum {
namespace {

// One coarse hand for all tests, before the coarse device.
class HandDressing : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    Rng rng(7);
    hand_ = new PosedHand{SampleHandShape(Sex::kWoman, rng), Side::kLeft, {}};
    HandMesh built = BuildHand(hand_->shape, hand_->side, hand_->pose, 1.2);
    skin_ = new ScenePart;
    skin_->paint.material = Material::kSkin;
    skin_->mesh = std::move(built.mesh);
    for (const Eigen::Vector3f& rgb : built.albedo) skin_->vertex_albedo.push_back(rgb.y());
    device_ = new VirtualDevice(BuildVirtualDevice(WithoutNoise(CoarseDevice()), 1));
  }
  static void TearDownTestSuite() {
    delete std::exchange(hand_, nullptr);
    delete std::exchange(skin_, nullptr);
    delete std::exchange(device_, nullptr);
  }

  static Stage StageOf(std::vector<ScenePart> parts) {
    Scene scene;
    scene.parts.push_back(Backplane());
    for (ScenePart& part : parts) scene.parts.push_back(std::move(part));
    auto stage = SetStage(*device_, std::move(scene), Context{});
    EXPECT_TRUE(stage.ok());
    return std::move(stage).value();
  }
  static cv::Mat Leds(const Stage& stage) { return *RenderLeds(*device_, stage, 1, Context{}); }

  // Mean green grey value where the skin is seen.
  static double SkinGrey(const Stage& stage) {
    const cv::Mat picture = Leds(stage);
    double sum = 0.0;
    int count = 0;
    for (int v = 0; v < picture.rows; ++v) {
      for (int u = 0; u < picture.cols; ++u) {
        if (stage.view.At(u, v).material != Material::kSkin) continue;
        sum += picture.at<cv::Vec3b>(v, u)[1];
        ++count;
      }
    }
    EXPECT_GT(count, 5000);
    return sum / count;
  }

  static PosedHand* hand_;
  static ScenePart* skin_;
  static VirtualDevice* device_;
};
PosedHand* HandDressing::hand_ = nullptr;
ScenePart* HandDressing::skin_ = nullptr;
VirtualDevice* HandDressing::device_ = nullptr;

TEST_F(HandDressing, ARingLiesCloseOnOneFinger) {
  const ScenePart ring = Ring(*hand_);
  ASSERT_GT(ring.mesh.faces.size(), 500U);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : ring.mesh.vertices) box.extend(v);
  const double breadth = hand_->shape.fingers[2].pip_breadth;
  EXPECT_GT(box.sizes().y(), breadth);
  EXPECT_LT(box.sizes().y(), 1.5 * breadth);
  EXPECT_LT(box.sizes().x(), 12.0);
  const Stage bare = StageOf({*skin_}), dressed = StageOf({*skin_, ring});
  int on_ring = 0;
  for (std::size_t i = 0; i < bare.view.centre.size(); ++i) {
    if (dressed.view.centre[i].material != Material::kGrey) continue;
    ++on_ring;
    const double rise = dressed.view.centre[i].position.z() - bare.view.centre[i].position.z();
    if (bare.view.centre[i].material == Material::kSkin && bare.view.centre[i].normal.z() > 0.9F) {
      EXPECT_GT(rise, 0.2) << "thinner towards its rounded edges";
      EXPECT_LT(rise, 2.0);
    }
  }
  EXPECT_GT(on_ring, 30);
  double brightest = 0.0;
  cv::Mat green, mask(bare.view.height, bare.view.width, CV_8U);
  cv::extractChannel(Leds(dressed), green, 1);
  for (std::size_t i = 0; i < dressed.view.centre.size(); ++i) {
    mask.data[i] = dressed.view.centre[i].material == Material::kGrey ? 255 : 0;
  }
  cv::minMaxLoc(green, nullptr, &brightest, nullptr, nullptr, mask);
  EXPECT_GT(brightest, 1.5 * cv::mean(green, mask)[0]) << "metal shines in places";
}

TEST_F(HandDressing, ASleeveCoversTheWristAndLeavesTheFingers) {
  const Stage bare = StageOf({*skin_}), dressed = StageOf({*skin_, Sleeve(*hand_)});
  int skin_before = 0, covered = 0, least_x = 1000, cloth_most_x = -1000;
  for (std::size_t i = 0; i < bare.view.centre.size(); ++i) {
    const SurfaceSample &before = bare.view.centre[i], &after = dressed.view.centre[i];
    if (before.material == Material::kSkin) ++skin_before;
    const int x = static_cast<int>(after.position.x());
    if (after.material == Material::kSkin) least_x = std::min(least_x, x);
    if (after.material != Material::kGrey) continue;
    cloth_most_x = std::max(cloth_most_x, x);
    if (before.material == Material::kSkin) ++covered;
    EXPECT_GT(after.position.z(), before.position.z() - 1e-6);
  }
  EXPECT_GT(covered, skin_before / 20);
  EXPECT_LT(covered, skin_before / 2);
  EXPECT_NEAR(least_x, cloth_most_x, 12.0) << "cloth ends where skin begins";
}

TEST_F(HandDressing, DarkAndLightSkinDifferAsAsked) {
  ScenePart dark = *skin_, light = *skin_;
  Brighten(0.28, dark);
  Brighten(1.25, light);
  const double usual = SkinGrey(StageOf({*skin_}));
  EXPECT_NEAR(SkinGrey(StageOf({dark})) / usual, 0.28, 0.05);
  EXPECT_NEAR(SkinGrey(StageOf({light})) / usual, 1.25, 0.1);
}

TEST_F(HandDressing, WetSkinShinesUnderTheLaserWhereDryDoesNot) {
  ScenePart wet = *skin_;
  MakeWet(3, wet);
  const Stage dry_stage = StageOf({*skin_}), wet_stage = StageOf({wet});
  const cv::Mat dry_light = *RenderLaser(*device_, dry_stage, 1, 1, Context{});
  const cv::Mat wet_light = *RenderLaser(*device_, wet_stage, 1, 1, Context{});
  int brighter = 0, darker = 0;
  for (int v = 0; v < dry_light.rows; ++v) {
    for (int u = 0; u < dry_light.cols; ++u) {
      EXPECT_EQ(dry_stage.view.At(u, v).position, wet_stage.view.At(u, v).position);
      const int difference = wet_light.at<cv::Vec3b>(v, u)[1] - dry_light.at<cv::Vec3b>(v, u)[1];
      brighter += difference > 25;
      darker += difference < -1;
    }
  }
  EXPECT_GT(brighter, 5);
  EXPECT_GT(darker, brighter);
}

TEST_F(HandDressing, HairDarkensThinLinesOnly) {
  ScenePart hairy = *skin_;
  GrowHair(*hand_, 5, hairy);
  int thin = 0, untouched = 0;
  double least = 1.0;
  for (std::size_t i = 0; i < skin_->mesh.vertices.size(); i += 3) {
    const double left = hairy.strands(skin_->mesh.vertices[i], 0.02);
    least = std::min(least, left);
    thin += left < 0.5;
    untouched += left == 1.0;
  }
  EXPECT_LT(least, 0.3);
  EXPECT_GT(thin, 50);
  EXPECT_GT(untouched, 10 * thin);
  // A coarse pixel sees a hair as little as its share of the pixel.
  EXPECT_NEAR(SkinGrey(StageOf({hairy})) / SkinGrey(StageOf({*skin_})), 0.95, 0.045);
}

TEST_F(HandDressing, VarnishMakesNailsBrightAndNothingElse) {
  ScenePart varnished = *skin_;
  VarnishNails(*hand_, varnished);
  int nails = 0, others = 0;
  double fingers_from = 0.0;
  for (std::size_t i = 0; i < skin_->mesh.vertices.size(); ++i) {
    if (varnished.vertex_gloss[i] > 0.025F) {
      ++nails;
      EXPECT_GT(varnished.vertex_albedo[i], skin_->vertex_albedo[i]);
      fingers_from = std::min(fingers_from, skin_->mesh.vertices[i].x());
    } else if (varnished.vertex_gloss[i] == 0.0F) {
      ++others;
      EXPECT_EQ(varnished.vertex_albedo[i], skin_->vertex_albedo[i]);
    }
  }
  EXPECT_GT(nails, 200) << "five nails of about 100 mm^2";
  EXPECT_GT(others, 20 * nails);
  EXPECT_GT(fingers_from, -30.0);
}

}  // namespace
}  // namespace dorsum
