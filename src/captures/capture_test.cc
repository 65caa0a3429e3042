// SPDX-License-Identifier: Apache-2.0
#include "captures/capture.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "base/files.h"
#include "base/temp_folder_test.h"

namespace dorsum {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr int kWidth = 32, kHeight = 24;

class CaptureTest : public ::testing::Test {
 protected:
  CaptureTest() {
    for (const char* name : {"bgHand", "stripesHand0", "stripesHand1", "stripesHand2"}) Write(name);
  }
  void Write(const std::string& name, cv::Size size = {kWidth, kHeight}) {
    cv::Mat image(size, CV_8UC3, cv::Scalar(20, 40, 60));
    image.colRange(10, 14).setTo(cv::Scalar(90, 200, 90));
    cv::imwrite((folder_ / (name + ".png")).string(), image);
  }
  void WriteUniform(const std::string& name, int value) {
    cv::imwrite((folder_ / (name + ".png")).string(),
                cv::Mat(kHeight, kWidth, CV_8UC3, cv::Scalar::all(value)));
  }
  void Remove(const std::string& name) { std::filesystem::remove(folder_ / (name + ".png")); }
  Result<CaptureImages> Load() { return LoadCapture(folder_.path(), {kWidth, kHeight}, {0, 1, 2}); }
  std::string Message() {
    const auto capture = Load();
    if (capture.ok()) return "(no error)";
    EXPECT_EQ(capture.error().code, ErrorCode::kBadInput);
    return capture.error().message;
  }
  TempFolder folder_;
};

TEST_F(CaptureTest, AWholeCaptureLoadsWithoutWarning) {
  const auto capture = Load();
  ASSERT_TRUE(capture.ok()) << capture.error().message;
  EXPECT_EQ(capture->hand.size(), cv::Size(kWidth, kHeight));
  ASSERT_EQ(capture->stripes.size(), 3U);
  for (const auto& image : capture->stripes) EXPECT_TRUE(image.has_value());
  EXPECT_FALSE(capture->hand_after.has_value());
  EXPECT_TRUE(capture->warnings.empty());
}

TEST_F(CaptureTest, StripesMayBeGreenAlone) {
  const auto capture = LoadCapture(folder_.path(), {}, {0, 1}, {}, Channels::kGreen);
  ASSERT_TRUE(capture.ok()) << capture.error().message;
  EXPECT_EQ(capture->hand.type(), CV_8UC3);
  ASSERT_EQ(capture->stripes[1]->type(), CV_8UC1);
  EXPECT_EQ(capture->stripes[1]->at<std::uint8_t>(3, 12), 200);
  WriteUniform("stripesHand1", 0);
  const auto black = LoadCapture(folder_.path(), {}, {0, 1}, {}, Channels::kGreen);
  ASSERT_FALSE(black.ok());
  EXPECT_THAT(black.error().message, AllOf(HasSubstr("stripesHand1"), HasSubstr("black")));
}

TEST_F(CaptureTest, TheHandAfterIsTakenIfItIsThere) {
  Write("bgHandAfter");
  EXPECT_TRUE(Load().value().hand_after.has_value());
}

TEST_F(CaptureTest, MissingFolderAndMissingHandAreNamed) {
  EXPECT_THAT(LoadCapture(folder_ / "none", {kWidth, kHeight}, {0}).error().message, HasSubstr("none"));
  Remove("bgHand");
  EXPECT_THAT(Message(), AllOf(HasSubstr("bgHand"), HasSubstr("missing")));
}

TEST_F(CaptureTest, AMissingLaserIsAWarningAndTheOthersStay) {
  Remove("stripesHand1");
  const auto capture = Load();
  ASSERT_TRUE(capture.ok());
  EXPECT_FALSE(capture->stripes[1].has_value());
  EXPECT_TRUE(capture->stripes[0].has_value() && capture->stripes[2].has_value());
  EXPECT_THAT(capture->warnings, ElementsAre(AllOf(HasSubstr("stripesHand1"), HasSubstr("laser 1"))));
}

TEST_F(CaptureTest, NoLaserAtAllIsAnError) {
  for (const char* name : {"stripesHand0", "stripesHand1", "stripesHand2"}) Remove(name);
  EXPECT_THAT(Message(), HasSubstr("stripesHand0"));
}

TEST_F(CaptureTest, BlackAndWhiteImagesAreNamed) {
  WriteUniform("stripesHand2", 3);
  EXPECT_THAT(Message(), AllOf(HasSubstr("stripesHand2"), HasSubstr("black")));
  WriteUniform("stripesHand2", 255);
  EXPECT_THAT(Message(), AllOf(HasSubstr("stripesHand2"), HasSubstr("white")));
  WriteUniform("bgHand", 0);
  EXPECT_THAT(Message(), AllOf(HasSubstr("bgHand"), HasSubstr("black")));
}

TEST_F(CaptureTest, ImagesOfAnotherSizeAreNamed) {
  Write("stripesHand0", {kWidth + 1, kHeight});
  EXPECT_THAT(Message(), AllOf(HasSubstr("stripesHand0"), HasSubstr("33x24"), HasSubstr("32x24")));
  Write("bgHand", {kWidth, kHeight + 1});
  EXPECT_THAT(Message(), HasSubstr("bgHand"));
}

TEST_F(CaptureTest, WithoutAnExpectedSizeTheImagesMustAgreeAmongThemselves) {
  EXPECT_TRUE(LoadCapture(folder_.path(), {}, {0, 1, 2}).ok());
  Write("stripesHand1", {kWidth + 2, kHeight});
  EXPECT_THAT(LoadCapture(folder_.path(), {}, {0, 1, 2}).error().message, HasSubstr("stripesHand1"));
}

TEST_F(CaptureTest, ATruncatedImageIsAnErrorEvenIfOthersAreThere) {
  const std::string bytes = ReadFile(folder_ / "stripesHand1.png").value();
  ASSERT_TRUE(
      WriteFile(folder_ / "stripesHand1.png", std::string_view(bytes).substr(0, bytes.size() / 2)).ok());
  EXPECT_THAT(Message(), AllOf(HasSubstr("stripesHand1"), HasSubstr("cut off")));
}

}  // namespace
}  // namespace dorsum
