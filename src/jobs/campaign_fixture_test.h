// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "base/files.h"
#include "base/temp_folder_test.h"
#include "captures/names.h"
#include "jobs/campaign_add.h"
#include "jobs/campaign_create.h"
#include "jobs/campaign_files.h"
#include "jobs/campaign_names.h"
#include "jobs/campaign_verify.h"

namespace dorsum {

// Every file and folder below `dir`, hidden ones too, with the contents of files.
inline std::set<std::string> TreeOf(const std::filesystem::path& dir) {
  std::set<std::string> tree;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(dir)) {
    const std::string name = std::filesystem::relative(entry.path(), dir).string();
    tree.insert(entry.is_regular_file() ? name + "\n" + *ReadFile(entry.path()) : name);
  }
  return tree;
}

// Whether `text` occurs in any name or content below `dir`.
inline bool OccursIn(const std::filesystem::path& dir, const std::string& text) {
  const std::set<std::string> tree = TreeOf(dir);
  return std::any_of(tree.begin(), tree.end(),
                     [&](const std::string& entry) { return entry.find(text) != std::string::npos; });
}

// Pictures of noise, which LoadCapture takes: what a campaign does with them does not ask what they show.
inline void WriteNoiseCapture(const std::filesystem::path& folder, int seed, int lasers = 2,
                              cv::Size size = {32, 24}, const std::string& extension = ".png") {
  std::filesystem::create_directories(folder);
  cv::RNG random(static_cast<std::uint64_t>(seed) + 1);
  std::vector<std::string> names = {kBgHandName};
  for (int k = 0; k < lasers; ++k) names.push_back(StripesHandName(k));
  for (const std::string& name : names) {
    cv::Mat picture(size, CV_8UC3);
    random.fill(picture, cv::RNG::UNIFORM, 0, 256);
    cv::imwrite((folder / (name + extension)).string(), picture);
  }
}

inline CaptureMaker Noise(int seed, int lasers = 2, cv::Size size = {32, 24}) {
  return [=](const std::filesystem::path& folder, const Context&) {
    WriteNoiseCapture(folder, seed, lasers, size);
    return Status();
  };
}

// The error's text, or nothing.
template <class T>
std::string Why(const T& result) {
  return result.ok() ? "" : result.error().message;
}

// A campaign of two sessions with two captures of each hand, and the person p01.
class CampaignFixture : public ::testing::Test {
 protected:
  CampaignFixture() {
    CreateCampaignRequest request{dir_, "study", {}, {}, {}};
    request.plan.sessions = request.plan.captures = 2;
    EXPECT_TRUE(CreateCampaign(request, {}).ok());
    EXPECT_TRUE(Person("p01").ok());
  }

  Status Person(const std::string& id, const std::string& sex = "man", const std::string& age = "20-29") {
    AddPersonRequest request{dir_, {id, sex, age, "2024-05-31", false}, false, "2024-06-01"};
    return AddPerson(request, {});
  }
  AddCaptureRequest Wanted(const std::string& id = "p01", CampaignHand hand = CampaignHand::kLeft) {
    return {dir_, id, hand, std::nullopt, {}, "SOURCE"};
  }
  Result<AddedCapture> Capture(int seed, const std::string& id = "p01",
                               CampaignHand hand = CampaignHand::kLeft) {
    return AddCapture(Wanted(id, hand), Noise(seed), {});
  }
  std::filesystem::path Folder(int number = 1, const std::string& id = "p01", int session = 1) {
    return CaptureFolder(dir_, id, session, {CampaignHand::kLeft, number});
  }
  std::vector<std::string> Findings() {
    const auto verification = VerifyCampaign(dir_, {});
    EXPECT_TRUE(verification.ok());
    return verification.ok() ? verification->findings : std::vector<std::string>{"not verified"};
  }
  // The job says no with this sentence, and leaves everything as it was.
  template <class Job>
  void ExpectRefused(const Job& job, const std::string& why) {
    SCOPED_TRACE(why);
    const auto before = TreeOf(dir_);
    EXPECT_THAT(Why(job()), ::testing::HasSubstr(why));
    EXPECT_EQ(TreeOf(dir_), before);
  }
  std::size_t Counted() {
    const auto captures = ListCaptures(dir_);
    return captures.ok() ? captures->size() : 9999;
  }

  TempFolder temp_;
  std::filesystem::path dir_ = temp_ / "study";
};

}  // namespace dorsum
