// SPDX-License-Identifier: Apache-2.0
#include "jobs/laser_agreement.h"

#include <gtest/gtest.h>

namespace dorsum {
namespace {

LaserConsistency Laser(int number, const Eigen::Vector3d& shift, const Eigen::Vector3d& sd) {
  LaserConsistency one;
  one.laser = number;
  one.samples = 2000;
  one.shift_mm = shift;
  one.shift_sd_mm = sd;
  return one;
}

std::string Complaint(const std::vector<LaserConsistency>& lasers) {
  const Status status = CheckAgreement(lasers, {});
  return status.ok() ? "" : status.error().message;
}

const Eigen::Vector3d kSure(0.03, 0.02, 0.01);

TEST(LaserAgreementTest, LasersThatSeeOneSurfaceAreFine) {
  EXPECT_EQ(Complaint({Laser(0, {-0.03, 0.01, 0.0}, kSure), Laser(1, {0.12, -0.03, 0.02}, kSure)}), "");
  EXPECT_EQ(Complaint({}), "");
}

TEST(LaserAgreementTest, AHandThatMovedIsRefused) {
  const std::string text = Complaint({Laser(0, {0.95, 0.0, 0.0}, kSure), Laser(1, {-0.5, 0.1, 0.0}, kSure)});
  EXPECT_NE(text.find("moved by about 1.4 mm"), std::string::npos) << text;
}

// A flat object says nothing about shifts in its own plane: one laser's large shift there is its edges'
// doing.
TEST(LaserAgreementTest, ABoxIsNotTakenForMoved) {
  EXPECT_EQ(Complaint({Laser(0, {-0.7, 0.0, 0.0}, {0.35, 0.3, 0.003}),
                       Laser(2, {-1.9, -0.3, 0.0}, {0.04, 0.1, 0.003}),
                       Laser(3, {0.9, -0.1, 0.0}, {0.5, 0.2, 0.003})}),
            "");
}

// Measured on a box at rest: where most lasers know little, one that seems to know much is wrong.
TEST(LaserAgreementTest, AFlatBoxIsNotTakenForMovedByOneSureLaser) {
  EXPECT_EQ(
      Complaint({Laser(0, {-0.3, -0.1, 0.0}, {1.1, 0.9, 0.01}), Laser(1, {0.8, 0.4, 0.0}, {0.11, 0.3, 0.003}),
                 Laser(2, {-0.5, 0.5, 0.0}, {0.1, 0.4, 0.003}),
                 Laser(3, {4.1, -0.1, 0.0}, {1.6, 0.6, 0.01})}),
      "");
}

// Measured on a hand 60 mm too high, whose orders were all one too low.
TEST(LaserAgreementTest, FarShiftsAreRefusedThoughTheyAreKnownBadly) {
  const std::string text = Complaint({Laser(0, {-4.0, 0.1, 0.15}, {0.47, 0.34, 0.32}),
                                      Laser(1, {0.0, 0.0, -0.3}, {0.1, 0.16, 0.13}),
                                      Laser(3, {2.6, -0.2, -0.3}, {0.23, 0.19, 0.23})});
  EXPECT_NE(text.find("differ by 6.6 mm"), std::string::npos) << text;
  EXPECT_NE(text.find("working volume of 0 to 80 mm"), std::string::npos) << text;
}

TEST(LaserAgreementTest, HeightsOutOfTheVolumeAreRefused) {
  const std::string text = Complaint(
      {Laser(0, {1.7, 0.6, -3.2}, {0.14, 0.24, 0.19}), Laser(1, {-1.7, -0.6, 2.9}, {0.19, 0.22, 0.16})});
  EXPECT_NE(text.find("working volume of 0 to 80 mm"), std::string::npos) << text;
}

}  // namespace
}  // namespace dorsum
