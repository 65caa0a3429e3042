// SPDX-License-Identifier: Apache-2.0
// The host's real code against the very firmware, in simavr.
#include "device/serial_lights.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "device/serial_relay_test.h"
#include "device/simulated_controller_test.h"

namespace dorsum {
namespace {

#define DORSUM_NEEDS_SIMULATOR() \
  if (!SimulatedController::Available()) GTEST_SKIP() << "needs avr-gcc and simavr: scripts/setup"

// simulated seconds: what the simulator's own steps and the line's speed add to a limit.
constexpr double kSlack_s = 0.005;

SerialLightsOptions On(const std::string& port) {
  SerialLightsOptions options;
  options.port = port;
  return options;
}

std::unique_ptr<Lights> OpenOrDie(const SerialLightsOptions& options) {
  Result<std::unique_ptr<Lights>> lights = OpenSerialLights(options, {});
  if (!lights.ok()) ADD_FAILURE() << lights.error().message;
  return lights.ok() ? std::move(lights).value() : nullptr;
}

void ExpectDeviceError(const Error& error, const std::string& culprit) {
  EXPECT_EQ(error.code, ErrorCode::kDevice);
  EXPECT_NE(error.message.find(culprit), std::string::npos) << error.message;
  EXPECT_EQ(error.message.find(". "), std::string::npos) << "two sentences: " << error.message;
}

TEST(SerialLights, SwitchesExactlyWhatItIsToldAndSaysWhatIsOn) {
  DORSUM_NEEDS_SIMULATOR();
  SimulatedController controller;
  {
    const auto lights = OpenOrDie(On(controller.port()));
    ASSERT_TRUE(lights);
    EXPECT_EQ(lights->info().channels, 9);
    EXPECT_EQ(lights->info().firmware_version, "1.0.0");
    EXPECT_EQ(lights->info().silence_limit_s, 2.0);
    EXPECT_EQ(lights->info().on_limit_s, 10.0);
    for (int channel = 0; channel < 9; ++channel) {
      const ChannelSet on = ChannelSet(1) << static_cast<std::size_t>(channel);
      ASSERT_TRUE(lights->Set(on).ok());
      EXPECT_EQ(lights->On().value(), on);
      EXPECT_TRUE(controller.WaitForLit(static_cast<unsigned>(on.to_ulong()))) << channel;
    }
    ASSERT_TRUE(lights->Set(ChannelSet(0x10F)).ok());
  }
  EXPECT_TRUE(controller.WaitForLit(0)) << "lights outlived whoever held them";
}

TEST(SerialLights, NothingIsLitFromPowerOnToTheFirstCommandInEitherLogic) {
  DORSUM_NEEDS_SIMULATOR();
  for (const bool inverted : {false, true}) {
    SimulatedController controller(inverted ? "dorsum-controller-inverted" : "dorsum-controller",
                                   {"--pull", inverted ? "up" : "down"});
    auto options = On(controller.port());
    options.inverted = inverted;
    const auto lights = OpenOrDie(options);
    ASSERT_TRUE(lights);
    EXPECT_EQ(lights->On().value(), ChannelSet());
    EXPECT_TRUE(controller.LitSets().empty());
    EXPECT_EQ(controller.Log()[1].text, inverted ? "hhhhhhhhh" : "lllllllll") << "pins must float at reset";
    ASSERT_TRUE(lights->Set(ChannelSet(0x101)).ok());
    EXPECT_TRUE(controller.WaitForLit(0x101));
    controller.Command("reset");
    EXPECT_TRUE(controller.WaitForLit(0));
  }
}

TEST(SerialLights, FirmwareOfTheWrongLogicLightsNothing) {
  DORSUM_NEEDS_SIMULATOR();
  for (const bool inverted : {false, true}) {
    SimulatedController controller(inverted ? "dorsum-controller-inverted" : "dorsum-controller",
                                   {"--pull", inverted ? "down" : "up"});
    auto options = On(controller.port());
    const auto lights = OpenOrDie(options);
    ASSERT_TRUE(lights);
    const Status set = lights->Set(ChannelSet(1));
    ASSERT_FALSE(set.ok());
    ExpectDeviceError(set.error(), "logic");
    controller.Now();
    EXPECT_TRUE(controller.LitSets().empty());
  }
}

TEST(SerialLights, OtherLogicThanTheDescriptionsIsRefused) {
  DORSUM_NEEDS_SIMULATOR();
  SimulatedController controller;
  auto options = On(controller.port());
  options.inverted = true;
  const auto lights = OpenSerialLights(options, {});
  ASSERT_FALSE(lights.ok());
  ExpectDeviceError(lights.error(), "normal logic");
}

TEST(SerialLights, ChannelThatDoesNotExistIsRefusedBeforeAnythingIsLit) {
  DORSUM_NEEDS_SIMULATOR();
  SimulatedController controller;
  auto options = On(controller.port());
  options.needed = ChannelSet(1) << 12U;
  const auto lights = OpenSerialLights(options, {});
  ASSERT_FALSE(lights.ok());
  ExpectDeviceError(lights.error(), "channel 12");
}

TEST(SerialLights, HolderKeepsThemAliveBeyondTheSilenceLimit) {
  DORSUM_NEEDS_SIMULATOR();
  SimulatedController controller;
  const auto lights = OpenOrDie(On(controller.port()));
  ASSERT_TRUE(lights);
  ASSERT_TRUE(lights->Set(ChannelSet(4)).ok());
  const double lit_s = controller.LastChange();
  while (controller.Now() < lit_s + 2.5) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(lights->On().value(), ChannelSet(4));
}

TEST(SerialLights, BootLoaderThatHoldsTheLineIsWaitedFor) {
  DORSUM_NEEDS_SIMULATOR();
  SimulatedController controller("dorsum-controller", {"--boot-ms", "900"});
  const auto lights = OpenOrDie(On(controller.port()));
  ASSERT_TRUE(lights);
  EXPECT_TRUE(lights->Set(ChannelSet(1)).ok());
}

TEST(SerialLights, LaserGoesOffAfterItsLongestTimeThoughTheHostIsAlive) {
  DORSUM_NEEDS_SIMULATOR();
  SimulatedController controller("dorsum-controller", {"--speed", "6"});
  auto link = ControllerLink::Open(controller.port(), 115200, {}, {});
  ASSERT_TRUE(link.ok());
  ASSERT_EQ((*link)->Ask("SET 0001").reply.on, 1);
  ASSERT_TRUE(controller.WaitForLit(1));
  const double lit_s = controller.LastChange();
  ControllerLink::Answer answer;
  do {
    answer = (*link)->Ask("GET");
    ASSERT_EQ(answer.outcome, LinkOutcome::kAnswered);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  } while (answer.reply.on != 0);
  EXPECT_EQ(answer.reply.why, 'T');
  ASSERT_TRUE(controller.WaitForLit(0));
  EXPECT_NEAR(controller.LastChange() - lit_s, 10.0, kSlack_s);
}

TEST(SerialLights, SilenceLimitIsTwoSecondsOfTheFirmwaresOwnClock) {
  DORSUM_NEEDS_SIMULATOR();
  SimulatedController controller("dorsum-controller", {"--speed", "4"});
  auto link = ControllerLink::Open(controller.port(), 115200, {}, {});
  ASSERT_TRUE(link.ok());
  ASSERT_EQ((*link)->Ask("SET 0103").reply.on, 0x0103);
  ASSERT_TRUE(controller.WaitForLit(0x103));
  const double lit_s = controller.LastChange();
  ASSERT_TRUE(controller.WaitForLit(0));
  EXPECT_NEAR(controller.LastChange() - lit_s, 2.0, kSlack_s);
  const ControllerLink::Answer answer = (*link)->Ask("GET");
  EXPECT_EQ(answer.reply.on, 0);
  EXPECT_EQ(answer.reply.why, 'S');
}

// The process that the next test kills: this program again, running that test with a port in its environment.
void HoldLightsUntilKilled(const char* port) {
  const auto lights = OpenOrDie(On(port));
  ASSERT_TRUE(lights);
  ASSERT_TRUE(lights->Set(ChannelSet(0x102)).ok());
  while (true) pause();
}

TEST(SerialLights, KilledHostLeavesEverythingOffWithinTwoSeconds) {
  if (const char* port = std::getenv("DORSUM_TEST_PORT")) return HoldLightsUntilKilled(port);
  DORSUM_NEEDS_SIMULATOR();
  SimulatedController controller;
  std::string program = "/proc/self/exe";
  std::string filter = "--gtest_filter=SerialLights.KilledHostLeavesEverythingOffWithinTwoSeconds";
  std::vector<char*> argv = {program.data(), filter.data(), nullptr};
  std::string variable = "DORSUM_TEST_PORT=" + controller.port();
  std::vector<char*> environment = {variable.data(), nullptr};
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t pid = 0;
  ASSERT_EQ(posix_spawn(&pid, argv[0], &files, nullptr, argv.data(), environment.data()), 0);
  posix_spawn_file_actions_destroy(&files);
  const bool lit = controller.WaitForLit(0x102);
  // Past several signs of life, so that it is the kill that ends them.
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  EXPECT_EQ(SimulatedController::LastLit(controller.Log()), 0x102U);
  kill(pid, SIGKILL);
  waitpid(pid, nullptr, 0);
  const double killed_s = controller.Now();
  ASSERT_TRUE(lit);
  ASSERT_TRUE(controller.WaitForLit(0));
  EXPECT_LE(controller.LastChange(), killed_s + 2.0 + kSlack_s);
}

TEST(SerialLights, RestartInTheMiddleIsNoticedAndTheNextSetBeginsAnew) {
  DORSUM_NEEDS_SIMULATOR();
  for (const char* disaster : {"reset", "brownout", "hang"}) {
    SimulatedController controller;
    const auto lights = OpenOrDie(On(controller.port()));
    ASSERT_TRUE(lights);
    ASSERT_TRUE(lights->Set(ChannelSet(1)).ok());
    const int resets = controller.Resets();
    const double before_s = controller.Now();
    controller.Command(disaster);
    ASSERT_TRUE(controller.WaitForLit(0)) << disaster;
    EXPECT_LE(controller.LastChange() - before_s, 2.0) << disaster;
    ASSERT_TRUE(controller.WaitFor([&](const auto& events) {
      return std::count_if(events.begin(), events.end(),
                           [](const auto& one) { return one.kind == "reset"; }) > resets;
    })) << disaster;
    const Result<ChannelSet> on = lights->On();
    ASSERT_FALSE(on.ok()) << disaster << ": a light that is off is believed on";
    ExpectDeviceError(on.error(), "restarted");
    EXPECT_FALSE(lights->On().ok()) << "forgotten after it was said once";
    ASSERT_TRUE(lights->Set(ChannelSet(2)).ok()) << disaster;
    EXPECT_EQ(lights->On().value(), ChannelSet(2));
    EXPECT_TRUE(controller.WaitForLit(2));
  }
}

TEST(SerialLights, RestartJustBeforeASetLosesNothing) {
  DORSUM_NEEDS_SIMULATOR();
  SimulatedController controller;
  const auto lights = OpenOrDie(On(controller.port()));
  ASSERT_TRUE(lights);
  controller.Command("reset");
  ASSERT_TRUE(controller.WaitFor([](const auto& events) {
    return std::count_if(events.begin(), events.end(),
                         [](const auto& one) { return one.text == "command"; }) > 0;
  }));
  ASSERT_TRUE(lights->Set(ChannelSet(1)).ok());
  EXPECT_TRUE(controller.WaitForLit(1));
}

TEST(SerialLights, SilentFirmwareIsAnErrorAndTheLightsGoOff) {
  DORSUM_NEEDS_SIMULATOR();
  SimulatedController controller;
  auto options = On(controller.port());
  options.link.answer_s = 0.1;
  options.link.greeting_s = 0.5;
  const auto lights = OpenOrDie(options);
  ASSERT_TRUE(lights);
  ASSERT_TRUE(lights->Set(ChannelSet(1)).ok());
  controller.Command("mute");
  const double muted_s = controller.Now();
  while (lights->On().ok()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  ExpectDeviceError(lights->On().error(), "does not answer any more");
  // It hears still: the host's own last try counts as a sign of life, and then no more come.
  ASSERT_TRUE(controller.WaitForLit(0));
  EXPECT_LE(controller.LastChange(), muted_s + 2.0 + 4 * 0.5 + kSlack_s);
  const Status set = lights->Set(ChannelSet(1));
  ASSERT_FALSE(set.ok());
  ExpectDeviceError(set.error(), "no answer");
  controller.Command("unmute");
  controller.Now();
  EXPECT_TRUE(lights->Set(ChannelSet(1)).ok()) << "a controller that speaks again is not listened to";
}

TEST(SerialLights, PortGoneInTheMiddleIsAnErrorAndTheLightsGoOff) {
  DORSUM_NEEDS_SIMULATOR();
  SimulatedController controller;
  SerialRelay relay(controller.port());
  const auto lights = OpenOrDie(On(relay.port()));
  ASSERT_TRUE(lights);
  ASSERT_TRUE(lights->Set(ChannelSet(1)).ok());
  relay.Cut();
  const double cut_s = controller.Now();
  const Result<ChannelSet> on = lights->On();
  ASSERT_FALSE(on.ok());
  ExpectDeviceError(on.error(), "is gone");
  const Status set = lights->Set(ChannelSet(1));
  ASSERT_FALSE(set.ok());
  ExpectDeviceError(set.error(), relay.port());
  ASSERT_TRUE(controller.WaitForLit(0));
  EXPECT_LE(controller.LastChange(), cut_s + 2.0 + kSlack_s);
}

TEST(SerialLights, NoiseOnTheLinePutsTheLightsOutAndOnSaysSo) {
  DORSUM_NEEDS_SIMULATOR();
  SimulatedController controller;
  const auto lights = OpenOrDie(On(controller.port()));
  ASSERT_TRUE(lights);
  ASSERT_TRUE(lights->Set(ChannelSet(1)).ok());
  controller.Command("noise");  // within the next line, which is a sign of life
  ASSERT_TRUE(controller.WaitForLit(0));
  EXPECT_EQ(lights->On().value(), ChannelSet());
  EXPECT_TRUE(lights->Set(ChannelSet(1)).ok());
}

TEST(SerialLights, OtherProtocolIsNamed) {
  DORSUM_NEEDS_SIMULATOR();
  SimulatedController controller("dorsum-controller-other-protocol");
  const auto lights = OpenSerialLights(On(controller.port()), {});
  ASSERT_FALSE(lights.ok());
  ExpectDeviceError(lights.error(), "speaks protocol 2");
}

TEST(SerialLights, FirstPortThatAnswersIsTaken) {
  DORSUM_NEEDS_SIMULATOR();
  SimulatedController controller;
  const Terminal dumb;
  SerialLightsOptions options;
  options.link.greeting_s = 0.3;
  const auto none = OpenFirstSerialLights({dumb.name(), "/dev/no-such-port"}, options, {});
  ASSERT_FALSE(none.ok());
  ExpectDeviceError(none.error(), "/dev/no-such-port");
  options.link.greeting_s = 2.0;
  const auto lights = OpenFirstSerialLights({dumb.name(), controller.port()}, options, {});
  ASSERT_TRUE(lights.ok()) << lights.error().message;
  EXPECT_EQ((*lights)->info().name, "light controller on " + controller.port());
}

TEST(SerialLights, PortThatIsInUseIsNotShared) {
  DORSUM_NEEDS_SIMULATOR();
  SimulatedController controller;
  const auto lights = OpenOrDie(On(controller.port()));
  ASSERT_TRUE(lights);
  const auto second = OpenSerialLights(On(controller.port()), {});
  ASSERT_FALSE(second.ok());
  ExpectDeviceError(second.error(), "in use by another program");
  EXPECT_TRUE(lights->Set(ChannelSet(1)).ok());
}

TEST(SerialLights, WhatIsNoControllerGetsASentence) {
  auto options = On("/dev/no-such-port");
  options.link.greeting_s = 0.2;
  ExpectDeviceError(OpenSerialLights(options, {}).error(), "there is no port /dev/no-such-port");
  options.port = "/dev/null";
  ExpectDeviceError(OpenSerialLights(options, {}).error(), "is no serial port");
  const Terminal dumb;
  options.port = dumb.name();
  ExpectDeviceError(OpenSerialLights(options, {}).error(), "no answer");
  const std::string chatter = "ok T:21.3 /0.0\nstart\n";
  std::atomic<bool> enough = false;
  std::thread talker([&] {
    while (!enough) {
      EXPECT_EQ(write(dumb.master(), chatter.data(), chatter.size()), static_cast<ssize_t>(chatter.size()));
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  });
  options.link.greeting_s = 0.6;
  ExpectDeviceError(OpenSerialLights(options, {}).error(), "not as a light controller");
  enough = true;
  talker.join();
  options.baud = 12345;
  ExpectDeviceError(OpenSerialLights(options, {}).error(), "12345");
  ExpectDeviceError(OpenFirstSerialLights({}, options, {}).error(), "no serial port of a USB device");
}

TEST(SerialLights, MissingPermissionNamesTheGroup) {
  const Terminal port;
  ASSERT_EQ(chmod(port.name().c_str(), 0), 0);
  const uid_t self = geteuid();
  if (self == 0) {
    ASSERT_EQ(seteuid(65534), 0);
  }
  const auto lights = OpenSerialLights(On(port.name()), {});
  ASSERT_EQ(seteuid(self), 0);
  ASSERT_FALSE(lights.ok());
  ExpectDeviceError(lights.error(), "dialout");
}

TEST(SerialLights, WaitingForAGreetingCanBeInterrupted) {
  const Terminal dumb;
  const std::atomic<bool> cancel = true;
  Context context;
  context.cancel = &cancel;
  const auto lights = OpenSerialLights(On(dumb.name()), context);
  ASSERT_FALSE(lights.ok());
  EXPECT_EQ(lights.error().code, ErrorCode::kCancelled);
}

}  // namespace
}  // namespace dorsum
