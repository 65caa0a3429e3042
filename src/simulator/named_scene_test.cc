// SPDX-License-Identifier: Apache-2.0
#include "simulator/named_scene.h"

#include <gtest/gtest.h>

#include "simulator/population.h"
#include "simulator/small_device_test.h"

namespace dorsum {
namespace {

TEST(SceneName, ReadsWhatItNames) {
  const auto box = ParseSceneName("box13.5_r2");
  ASSERT_TRUE(box.ok());
  EXPECT_EQ(box->kind, SceneName::Kind::kBox);
  EXPECT_EQ(box->size_mm, 13.5);
  EXPECT_EQ(box->geometry, "box13.5");
  EXPECT_EQ(box->folder, "box13.5_r2");
  const auto hand = ParseSceneName("hand:woman:left:ann-2_x:k3_r1");
  ASSERT_TRUE(hand.ok()) << hand.error().message;
  EXPECT_EQ(hand->sex, Sex::kWoman);
  EXPECT_EQ(hand->side, Side::kLeft);
  EXPECT_EQ(hand->person, "ann-2_x");
  EXPECT_EQ(hand->visit, 3);
  EXPECT_EQ(hand->folder, "hand_woman_left_ann-2_x_k3_r1");
}

TEST(SceneName, RefusesWhatItDoesNotKnow) {
  for (const char* name :
       {"", "cube5", "box", "box0", "boxnan", "box25.5mm", "sphere-3", "cylinder1e9", "hand",
        "hand:man:right", "hand:boy:right:a", "hand:man:top:a", "hand:man:right:../../etc",
        "hand:man:right:a:3", "hand:man:right:", "plane_", "_r1"}) {
    const auto result = ParseSceneName(name);
    ASSERT_FALSE(result.ok()) << name;
    EXPECT_EQ(result.error().code, ErrorCode::kUsage);
  }
}

TEST(NamedScene, RepeatsHaveTheSameShapeAndSeedsAnother) {
  const VirtualDevice device = BuildVirtualDevice(CoarseDevice(), 1);
  const auto mesh = [&](const char* name, std::uint64_t seed) {
    return ObjectMesh(BuildNamedScene(device, *ParseSceneName(name), seed, 1)).vertices;
  };
  EXPECT_EQ(mesh("box20_r0", 1), mesh("box20_r1", 1));
  EXPECT_NE(mesh("box20", 1), mesh("box20", 2));
  EXPECT_NE(mesh("box20", 1), mesh("box21", 1));
}

TEST(NamedScene, ObjectsLieInThePictureAboveTheBackplane) {
  const auto two = ReadDeviceDescription("devices/two-lasers-70.toml");
  ASSERT_TRUE(two.ok());
  for (const DeviceDescription& d : {DefaultDevice(), *two}) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const VirtualDevice device = BuildVirtualDevice(d, seed);
      for (const char* name : {"box13.5", "box80", "cylinder10", "sphere25", "plane_tilted"}) {
        const TriangleMesh mesh = ObjectMesh(BuildNamedScene(device, *ParseSceneName(name), seed, 1));
        for (const Eigen::Vector3d& v : mesh.vertices) {
          const Eigen::Vector2d p = Project(device.camera, v);
          EXPECT_GE(v.z(), -1e-9) << name;
          EXPECT_TRUE(p.x() > 0 && p.y() > 0 && p.x() < d.camera.width && p.y() < d.camera.height) << name;
        }
      }
    }
  }
}

TEST(NamedScene, ObjectsCanBeRaisedAndShifted) {
  const VirtualDevice device = BuildVirtualDevice(CoarseDevice(), 1);
  const auto box_of = [&](const char* text) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& v :
         ObjectMesh(BuildNamedScene(device, *ParseSceneName(text), 1, 1)).vertices) {
      box.extend(v);
    }
    return box;
  };
  const auto usual = box_of("box20"), high = box_of("box20+high70"), aside = box_of("box20+side");
  EXPECT_LT((high.min() - usual.min() - Eigen::Vector3d(0, 0, 70)).norm(), 1e-9);
  EXPECT_LT((aside.max() - usual.max() - Eigen::Vector3d(0, 80, 0)).norm(), 1e-9);
  EXPECT_GT(high.max().z(), device.description.working_heights_mm[1]) << "above the working volume";
  EXPECT_LT(Project(device.camera, aside.max()).y(), 0.0) << "out of the picture";
}

TEST(NamedScene, AWhiteBoxLiesWhereNoColourTellsItFromTheBackplane) {
  const VirtualDevice device = BuildVirtualDevice(CoarseDevice(), 1);
  const Scene scene = BuildNamedScene(device, *ParseSceneName("whitebox20"), 1, 1);
  ASSERT_EQ(scene.parts.size(), 2U);
  EXPECT_EQ(scene.parts[1].paint.albedo, scene.parts[0].paint.albedo);
  EXPECT_EQ(scene.parts[1].mesh.vertices[0].z(), 20.0);
}

TEST(Population, HasTheDocumentsProportions) {
  const auto women = [](int people) {
    int count = 0;
    for (const Person& p : DrawPopulation(people, 1)) count += p.sex == Sex::kWoman;
    return count;
  };
  EXPECT_EQ(women(20), 2);
  EXPECT_EQ(women(100), 10);
  EXPECT_EQ(women(5), 1);
  EXPECT_EQ(women(4), 0);
  EXPECT_TRUE(DrawPopulation(0, 1).empty());
  const auto people = DrawPopulation(12, 3);
  ASSERT_EQ(people.size(), 12U);
  ASSERT_EQ(people[3].captures.size(), 6U) << "both hands, three times";
  EXPECT_EQ(people[3].captures[0].folder, "id03_L_k0");
  EXPECT_EQ(people[11].captures[5].folder, "id11_R_k2");
}

}  // namespace
}  // namespace dorsum
