// SPDX-License-Identifier: Apache-2.0
#include "device/controller_link.h"

#include <algorithm>
#include <random>
#include <utility>

#include "device/device_error.h"
#include "device/frame_source.h"

namespace dorsum {
namespace {

// Between greetings: long enough for a boot loader to give up on what it takes for its own.
constexpr double kGreetingPause = 0.4;
// Between looks at whether the user has had enough.
constexpr double kPatience = 0.05;

}  // namespace

Result<std::unique_ptr<ControllerLink>> ControllerLink::Open(const std::string& port, int baud,
                                                             const LinkOptions& options,
                                                             const Context& context) {
  DORSUM_ASSIGN_OR_RETURN(std::unique_ptr<SerialPort> serial, SerialPort::Open(port, baud));
  std::unique_ptr<ControllerLink> link(new ControllerLink(std::move(serial), options));
  DORSUM_RETURN_IF_ERROR(link->Greet(context));
  return link;
}

Result<std::optional<ControllerReply>> ControllerLink::NextReply(double deadline_s) {
  while (true) {
    for (std::size_t i = 0; i < received_.size(); ++i) {
      const std::optional<std::string> line = assembler_.Add(received_[i]);
      if (!line) continue;
      std::optional<ControllerReply> reply = ParseControllerReply(*line);
      if (!reply) continue;
      received_.erase(0, i + 1);
      return reply;
    }
    received_.clear();
    const double left_s = deadline_s - MonotonicSeconds();
    if (left_s <= 0.0) return std::optional<ControllerReply>();
    DORSUM_ASSIGN_OR_RETURN(received_, port_->Read(left_s));
    heard_ = heard_ || !received_.empty();
  }
}

Error ControllerLink::WrongVersion(const ControllerReply& reply) const {
  return DeviceError("the light controller on " + port() + " speaks protocol " +
                     std::to_string(reply.protocol) + " (firmware " + reply.firmware_version +
                     "), this program protocol " + std::to_string(kControllerProtocol) +
                     "; flash the firmware that belongs to this program (scripts/firmware)");
}

Status ControllerLink::Greet(const Context& context) {
  session_ = 0;
  sequence_ = 1;
  heard_ = false;
  const auto nonce = static_cast<std::uint16_t>(std::random_device()());
  const std::string hello = ControllerLine(0, sequence_, HelloWords(nonce));
  const double deadline_s = MonotonicSeconds() + options_.greeting_s;
  double next_s = 0.0;
  while (MonotonicSeconds() < deadline_s) {
    DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
    if (MonotonicSeconds() >= next_s) {
      DORSUM_RETURN_IF_ERROR(port_->Write(hello));
      next_s = MonotonicSeconds() + kGreetingPause;
    }
    const double wait_s = std::min({deadline_s, next_s, MonotonicSeconds() + kPatience});
    DORSUM_ASSIGN_OR_RETURN(const std::optional<ControllerReply> reply, NextReply(wait_s));
    if (!reply) continue;
    if (reply->kind == ReplyKind::kError && reply->error == "VERSION") return WrongVersion(*reply);
    if (reply->kind == ReplyKind::kGreeting && reply->nonce == nonce) {
      if (reply->protocol != kControllerProtocol) return WrongVersion(*reply);
      greeting_ = *reply;
      session_ = reply->session;
      return {};
    }
    // It has just started, or was in the middle of something else: now it listens.
    if (reply->kind == ReplyKind::kBoot || reply->error == "DAMAGED") next_s = 0.0;
  }
  if (heard_) {
    return DeviceError("what is on " + port() +
                       " talks, but not as a light controller; check controller.port and controller.baud, or "
                       "flash the firmware (scripts/firmware)");
  }
  return DeviceError("no answer from a light controller on " + port() +
                     "; check controller.port, cable and power, or flash the firmware (scripts/firmware)");
}

ControllerLink::Answer ControllerLink::Ask(std::string_view words) {
  const std::string line = ControllerLine(session_, ++sequence_, words);
  const Error restarted =
      DeviceError("the light controller on " + port() +
                  " has restarted in the middle, which switched its lights off; check its power and cable");
  for (int i = 0; i < options_.tries; ++i) {
    if (const Status sent = port_->Write(line); !sent.ok()) return {LinkOutcome::kFailed, {}, sent.error()};
    const double deadline_s = MonotonicSeconds() + options_.answer_s;
    while (true) {
      const Result<std::optional<ControllerReply>> next = NextReply(deadline_s);
      if (!next.ok()) return {LinkOutcome::kFailed, {}, next.error()};
      const std::optional<ControllerReply>& reply = *next;
      if (!reply) break;
      if (reply->kind == ReplyKind::kBoot) return {LinkOutcome::kRestarted, {}, restarted};
      if (reply->kind == ReplyKind::kError && reply->error == "DAMAGED") break;  // once more
      if (reply->session != session_ || reply->sequence != sequence_) continue;  // to an earlier command
      if (reply->kind == ReplyKind::kError && reply->error == "SESSION") {
        return {LinkOutcome::kRestarted, {}, restarted};
      }
      return {LinkOutcome::kAnswered, *reply, {}};
    }
  }
  return {LinkOutcome::kFailed,
          {},
          DeviceError("the light controller on " + port() +
                      " does not answer any more; check its cable and power, then start over")};
}

void ControllerLink::SayOff() { Ask("OFF"); }

}  // namespace dorsum
