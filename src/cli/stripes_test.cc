// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "base/random.h"
#include "cli/bad_images_test.h"
#include "cli/program_test.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

// Three upright stripes, the middle one ending half-way.
class StripesCommandTest : public ProgramTest {
 protected:
  StripesCommandTest() { PutImage(Picture(), Stripes(560, 420)); }

  static cv::Mat Stripes(int width, int height) {
    cv::Mat image(height, width, CV_8UC3, cv::Scalar(1, 8, 1));
    Rng rng(NamedSeed("stripes command"));
    for (int k = 0; k < 3; ++k) {
      for (int v = 0; v < (k == 1 ? height / 2 : height); ++v) {
        for (int x = 0; x < width; ++x) {
          const double t = (x - 100.25 - 150.0 * k) / 2.0;
          auto& green = image.at<cv::Vec3b>(v, x)[1];
          green = cv::saturate_cast<std::uint8_t>(green + 90.0 * std::exp(-0.5 * t * t) + rng.Normal());
        }
      }
    }
    return image;
  }
  fs::path Picture() const { return *this / "stripes.png"; }
  fs::path Csv() const { return *this / "out" / "stripes.csv"; }
};

TEST_F(StripesCommandTest, OneImageGivesOneLinePerStripeAndRow) {
  const ProgramRun run = RunProgram({"stripes", Picture(), "-o", Csv()});
  ASSERT_EQ(run.code, 0) << run.err;
  std::istringstream csv(WholeFile(Csv()));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "row,column,sd,peak,width,segment");
  int lines = 0;
  while (std::getline(csv, line)) {
    double row = 0.0, column = 0.0, sd = 0.0, peak = 0.0, width = 0.0;
    int segment = -1;
    ASSERT_EQ(
        std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf,%d", &row, &column, &sd, &peak, &width, &segment), 6);
    EXPECT_NEAR(std::remainder(column - 100.25, 150.0), 0.0, 0.1) << line;
    EXPECT_NEAR(width, 2.0, 0.2) << line;
    EXPECT_NEAR(peak, 90.0, 6.0) << line;
    EXPECT_GT(sd, 0.0) << line;
    EXPECT_LT(segment, 3) << line;
    ++lines;
  }
  EXPECT_NEAR(lines, 2.5 * 420, 4);
  EXPECT_NE(run.out.find("3 segments"), std::string::npos) << run.out;
}

TEST_F(StripesCommandTest, SeveralImagesAreNamedInFrontAndJsonCounts) {
  PutImage(*this / "a, second.png", Stripes(500, 100));
  const ProgramRun run = RunProgram({"stripes", Picture(), *this / "a, second.png", "-o", Csv(), "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string csv = WholeFile(Csv());
  EXPECT_EQ(csv.rfind("image,row,column,sd,peak,width,segment\n", 0), 0U);
  EXPECT_NE(csv.find("\n\"" + (*this / "a, second.png").string() + "\",0,"), std::string::npos);
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json["schema"], "dorsum/stripes");
  ASSERT_EQ(json["images"].size(), 2U);
  EXPECT_EQ(json["images"][1]["segments"], 3);
}

TEST_F(StripesCommandTest, SingleRowsAreLessSureThanPooledOnes) {
  const fs::path single = *this / "out" / "single.csv";
  const ProgramRun pooled = RunProgram({"stripes", Picture(), "-o", Csv(), "--json"});
  const ProgramRun rows = RunProgram({"stripes", Picture(), "-o", single, "--json", "--single-rows"});
  ASSERT_EQ(rows.code, 0) << rows.err;
  const Json all = Json::parse(pooled.out)["images"][0], each = Json::parse(rows.out)["images"][0];
  EXPECT_EQ(all["points"], each["points"]);
  EXPECT_LT(all["median_sd_px"].get<double>(), 0.6 * each["median_sd_px"].get<double>());
  EXPECT_FALSE(WholeFile(Csv()) == WholeFile(single));
}

TEST_F(StripesCommandTest, NoStripesIsNoError) {
  PutImage(Picture(), cv::Mat(100, 120, CV_8UC3, cv::Scalar(3, 3, 3)));
  const ProgramRun run = RunProgram({"stripes", Picture(), "-o", Csv()});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(WholeFile(Csv()), "row,column,sd,peak,width,segment\n");
}

TEST_F(StripesCommandTest, BadImagesAreRefusedInOneSentence) {
  for (const BadImage& bad : BadImages()) {
    if (std::string(bad.what) == "of another size") continue;  // any size will do here
    SCOPED_TRACE(bad.what);
    fs::remove_all(Picture());
    fs::remove(*this / "stripes.jpg");
    PutImage(Picture(), Stripes(560, 420));
    bad.spoil(*this / ".", "stripes");
    const fs::path image = fs::exists(*this / "stripes.jpg") ? *this / "stripes.jpg" : Picture();
    ExpectRefused(RunProgram({"stripes", image, "-o", Csv()}), 3, {image.filename()});
    ExpectNothingWritten();
  }
}

TEST_F(StripesCommandTest, NowhereToWriteAndWrongUsage) {
  ExpectRefused(RunProgram({"stripes", Picture(), "-o", *this / "none" / "deep" / "x.csv"}), 3, {"x.csv"});
  EXPECT_EQ(RunProgram({"stripes", Picture()}).code, 2);
  EXPECT_EQ(RunProgram({"stripes", "-o", Csv()}).code, 2);
  EXPECT_EQ(RunProgram({"stripes", Picture(), "-o", Csv(), "--width", "nan"}).code, 2);
  const ProgramRun help = RunProgram({"stripes", "--help"});
  EXPECT_EQ(help.code, 0);
  EXPECT_NE(help.out.find("Example: dorsum stripes"), std::string::npos);
  ExpectNothingWritten();
}

}  // namespace
}  // namespace dorsum
