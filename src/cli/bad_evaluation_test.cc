// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "cli/bad_images_test.h"
#include "cli/program_test.h"
#include "surface/ply.h"

namespace dorsum {
namespace {

namespace fs = std::filesystem;

// A flat top of 20 mm as reconstruct leaves it.
class BadEvaluationTest : public ProgramTest {
 protected:
  BadEvaluationTest() {
    PutImage(Out() / "mask.png", cv::Mat(60, 80, CV_8UC1, cv::Scalar(255)));
    SurfacePoints points;
    for (int i = 0; i < 600; ++i) {
      SurfacePoint p;
      const int column = i % 30, row = i / 30;
      p.position = {1.0 * column, 1.0 * row, i % 2 == 0 ? 20.1 : 19.9};
      p.u = static_cast<float>(20 + column);
      p.v = static_cast<float>(20 + row);
      points.push_back(p);
    }
    EXPECT_TRUE(WritePointsPly(Out() / "points.ply", points).ok());
    PutFile(*this / "plate.ply", "");
    TriangleMesh mesh;
    mesh.vertices = {{-50, -50, 20}, {50, -50, 20}, {0, 90, 20}};
    mesh.faces = {{0, 1, 2}};
    EXPECT_TRUE(WriteMeshPly(*this / "plate.ply", mesh).ok());
  }
  fs::path Out() const { return *this / "out"; }
  ProgramRun Evaluate(const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"evaluate", Out()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunProgram(arguments);
  }
};

TEST_F(BadEvaluationTest, TheAnswerNoIsExitCodeOneWithTheFigures) {
  EXPECT_EQ(Evaluate({"--plane-height", "20", "--max-rmse", "0.11"}).code, 0);
  EXPECT_EQ(Evaluate({"--against", *this / "plate.ply", "--max-rmse", "0.11"}).code, 0);
  const ProgramRun no = Evaluate({"--plane-height", "20", "--max-rmse", "0.09"});
  EXPECT_EQ(no.code, 1) << no.err;
  EXPECT_NE(no.out.find("merged"), std::string::npos) << no.out;
  EXPECT_NE(no.err.find("RMSE"), std::string::npos) << no.err;
}

TEST_F(BadEvaluationTest, AFolderWithoutPointsOrMask) {
  ExpectRefused(RunProgram({"evaluate", *this / "none", "--plane-height", "20"}), 3, {"none"});
  fs::remove(Out() / "mask.png");
  ExpectRefused(Evaluate({"--plane-height", "20"}), 3, {"mask.png"});
  fs::remove(Out() / "points.ply");
  ExpectRefused(Evaluate({"--plane-height", "20"}), 3, {"points.ply"});
}

TEST_F(BadEvaluationTest, DamagedPointsAndMeshes) {
  for (const char* name : {"out/points.ply", "plate.ply"}) {
    const fs::path path = *this / name;
    const std::string whole = WholeFile(path);
    const std::size_t body = whole.find("end_header\n") + 11;
    std::string many = whole;
    const std::size_t count = many.find("element vertex ") + 15;
    many.replace(count, many.find('\n', count) - count, "4000000000");
    std::string text_format = whole;
    text_format.replace(text_format.find("binary_little_endian"), 20, "ascii");
    std::string nan = whole;
    nan.replace(body, 4, std::string("\x00\x00\xc0\x7f", 4));
    std::string no_x = whole;
    no_x.replace(no_x.find("float x"), 7, "float q");
    for (const std::string& bytes :
         {std::string(), std::string("ply"), std::string("no mesh at all\n"), whole.substr(0, body),
          whole.substr(0, body / 2), whole.substr(0, whole.size() - 3), many, text_format, nan, no_x}) {
      SCOPED_TRACE(std::string(name) + ": " + bytes.substr(0, 80));
      PutFile(path, bytes);
      ExpectRefused(Evaluate({"--against", *this / "plate.ply"}), 3, {path.string()});
    }
    PutFile(path, whole);
  }
}

TEST_F(BadEvaluationTest, AMeshWhoseFacesNameNoVertex) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.faces = {{0, 1, 7}};
  ASSERT_TRUE(WriteMeshPly(*this / "plate.ply", mesh).ok());
  ExpectRefused(Evaluate({"--against", *this / "plate.ply"}), 3, {"plate.ply"});
}

TEST_F(BadEvaluationTest, AMaskThatIsNoGood) {
  for (const std::string& bytes :
       {std::string(), std::string("text"), PngHeader(20000, 20000), PngHeader(1000000000, 1000000000)}) {
    PutFile(Out() / "mask.png", bytes);
    ExpectRefused(Evaluate({"--plane-height", "20"}), 3, {"mask.png"});
  }
  PutImage(Out() / "mask.png", cv::Mat(60, 80, CV_8UC1, cv::Scalar(0)));
  ExpectRefused(Evaluate({"--plane-height", "20"}), 3, {"mask"});
}

TEST_F(BadEvaluationTest, AShapeThatThePointsDoNotHave) {
  SurfacePoints points(9);
  for (SurfacePoint& p : points) p.u = p.v = 30.0F;
  ASSERT_TRUE(WritePointsPly(Out() / "points.ply", points).ok());
  for (const char* shape : {"plane", "sphere", "cylinder"}) {
    ExpectRefused(Evaluate({"--fit", shape}), 3, {Out().string()});
  }
  EXPECT_EQ(Evaluate({"--plane-height", "0", "--repeat", Out()}).code, 0);
}

}  // namespace
}  // namespace dorsum
