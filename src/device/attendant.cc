// SPDX-License-Identifier: Apache-2.0
#include "device/attendant.h"

#include <utility>

#include "device/virtual_bench.h"

namespace dorsum {
namespace {

class VirtualAttendant : public Attendant {
 public:
  explicit VirtualAttendant(std::shared_ptr<VirtualBench> bench) : bench_(std::move(bench)) {}

  Status Arrange(const SeriesStep& step, const std::string& /*words*/,
                 const std::function<Status()>& /*keep_lit*/, const Context& /*context*/) override {
    return bench_->PlaceSeries(step);
  }
  void Tell(const std::string& /*words*/) override {}

 private:
  std::shared_ptr<VirtualBench> bench_;
};

}  // namespace

std::unique_ptr<Attendant> MakeVirtualAttendant(std::shared_ptr<VirtualBench> bench) {
  return std::make_unique<VirtualAttendant>(std::move(bench));
}

}  // namespace dorsum
