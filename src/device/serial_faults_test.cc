// SPDX-License-Identifier: Apache-2.0
// A byte lost, doubled or garbled, each way, at each place of each command of a session with the very
// firmware.
#include <string>

#include <gtest/gtest.h>

#include "device/serial_lights.h"
#include "device/serial_relay_test.h"
#include "device/simulated_controller_test.h"

namespace dorsum {
namespace {

struct Harm {
  Way way;
  Mischief mischief;
};

class SerialFaults : public ::testing::TestWithParam<Harm> {
 protected:
  void SetUp() override {
    if (!SimulatedController::Available()) GTEST_SKIP() << "needs avr-gcc and simavr: scripts/setup";
  }
  static SerialLightsOptions Options(const std::string& port) {
    SerialLightsOptions options;
    options.port = port;
    options.keep_alive_s = 1.0;  // seldom, so that it is the command that meets the harm
    options.link.answer_s = 0.09;
    options.link.tries = 20;  // a busy machine may be late; together below the silence limit
    return options;
  }
};

// A pseudo-terminal of a busy machine may hold its bytes back for longer than all tries of a command; then
// the lights say that the controller does not answer, and the next Set() begins anew.
Status SetPatiently(Lights& lights, const ChannelSet& on) {
  Status status;
  for (int i = 0; i < 4; ++i) {
    status = lights.Set(on);
    if (status.ok() || status.error().message.find("does not answer") == std::string::npos) break;
  }
  return status;
}
Result<ChannelSet> OnPatiently(Lights& lights) {
  Result<ChannelSet> on = lights.On();
  if (!on.ok() && SetPatiently(lights, {}).ok()) on = lights.On();
  return on;
}

TEST_P(SerialFaults, SetAndQueryStillDoWhatTheySayAndLightNothingElse) {
  SimulatedController controller;
  SerialRelay relay(controller.port());
  auto lights = OpenSerialLights(Options(relay.port()), {});
  ASSERT_TRUE(lights.ok()) << lights.error().message;
  for (const int at : {0, 3, 11, 14, 17, 20, 23}) {  // of a SET's 24 bytes; a reply has 26
    relay.Arm(GetParam().way, GetParam().mischief, at);
    const Status set = SetPatiently(**lights, ChannelSet(2));
    ASSERT_TRUE(set.ok()) << at << ": " << set.error().message;
    EXPECT_TRUE(relay.Done()) << at;
    EXPECT_TRUE(controller.WaitForLit(2)) << at;
    const Result<ChannelSet> lit = (*lights)->On();
    EXPECT_TRUE(!lit.ok() || *lit == ChannelSet(2)) << at;

    // A query that is damaged on its way puts the lights out; it never tells what is not so.
    relay.Arm(GetParam().way, GetParam().mischief, at % 18);
    const Result<ChannelSet> on = OnPatiently(**lights);
    ASSERT_TRUE(on.ok()) << at << ": " << on.error().message;
    EXPECT_EQ(on->to_ulong(), SimulatedController::LastLit(controller.Log())) << at;

    relay.Arm(GetParam().way, GetParam().mischief, at);
    ASSERT_TRUE(SetPatiently(**lights, {}).ok()) << at;
    EXPECT_EQ(SimulatedController::LastLit(controller.Log()), 0U) << at;
  }
  for (const unsigned lit : controller.LitSets()) EXPECT_EQ(lit, 2U);
}

TEST_P(SerialFaults, GreetingSurvives) {
  SimulatedController controller;
  SerialRelay relay(controller.port());
  for (const int at : {0, 6, 16, 24}) {
    relay.Arm(GetParam().way, GetParam().mischief, at);
    auto lights = OpenSerialLights(Options(relay.port()), {});
    ASSERT_TRUE(lights.ok()) << at << ": " << lights.error().message;
    EXPECT_TRUE(SetPatiently(**lights, ChannelSet(1)).ok()) << at;
    EXPECT_TRUE(relay.Done()) << at;
  }
  EXPECT_TRUE(controller.WaitForLit(0));
}

std::string HarmName(const ::testing::TestParamInfo<Harm>& harm) {
  std::string way = harm.param.way == Way::kToHost ? "ToHost" : "ToController";
  switch (harm.param.mischief) {
    case Mischief::kLose:
      return way + "Lost";
    case Mischief::kDouble:
      return way + "Doubled";
    case Mischief::kGarble:
      return way + "Garbled";
  }
  return way;
}

constexpr Harm kHarms[] = {{Way::kToController, Mischief::kLose},   {Way::kToController, Mischief::kDouble},
                           {Way::kToController, Mischief::kGarble}, {Way::kToHost, Mischief::kLose},
                           {Way::kToHost, Mischief::kDouble},       {Way::kToHost, Mischief::kGarble}};
INSTANTIATE_TEST_SUITE_P(EachWay, SerialFaults, ::testing::ValuesIn(kHarms), HarmName);

}  // namespace
}  // namespace dorsum
