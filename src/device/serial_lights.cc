// SPDX-License-Identifier: Apache-2.0
#include "device/serial_lights.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "device/device_error.h"

namespace dorsum {
namespace {

std::string ChannelNames(const ChannelSet& set) {
  std::string names;
  for (int i = 0; i < kMaxChannels; ++i) {
    if (set[static_cast<std::size_t>(i)]) names += (names.empty() ? "" : ", ") + std::to_string(i);
  }
  return names;
}

class SerialLights : public Lights {
 public:
  SerialLights(std::unique_ptr<ControllerLink> link, SerialLightsOptions options, ControllerInfo info)
      : options_(std::move(options)), info_(std::move(info)), port_(link->port()), link_(std::move(link)) {
    keeper_ = std::thread([this] { KeepAlive(); });
  }
  SerialLights(const SerialLights&) = delete;
  SerialLights& operator=(const SerialLights&) = delete;

  ~SerialLights() override {
    {
      const std::lock_guard lock(mutex_);
      stop_ = true;
    }
    changed_.notify_all();
    keeper_.join();
    if (link_) link_->SayOff();
  }

  Status Set(const ChannelSet& on) override {
    const std::lock_guard lock(mutex_);
    lit_ = false;  // whatever happens: until it has worked
    DORSUM_RETURN_IF_ERROR(CheckChannels(on));
    if (fault_) DORSUM_RETURN_IF_ERROR(BeginAnew());
    const std::string words = SetWords(static_cast<std::uint16_t>(on.to_ulong()));
    ControllerLink::Answer answer = link_->Ask(words);
    if (answer.outcome == LinkOutcome::kRestarted) {
      DORSUM_RETURN_IF_ERROR(BeginAnew());  // all is off there, so the set as a whole can be asked for again
      answer = link_->Ask(words);
    }
    if (answer.outcome != LinkOutcome::kAnswered) return Fail(answer.error);
    if (answer.reply.kind != ReplyKind::kState || ChannelSet(answer.reply.on) != on) {
      link_->SayOff();
      return Fail(Unwilling(answer.reply));
    }
    lit_ = on.any();
    changed_.notify_all();
    return {};
  }

  Result<ChannelSet> On() override {
    const std::lock_guard lock(mutex_);
    return Query();
  }

  ControllerInfo info() const override { return info_; }

  Status CheckChannels(const ChannelSet& on) const {
    const ChannelSet missing = on & ~ChannelSet(link_ ? link_->greeting().wired : 0xFFFFU);
    if (missing.none()) return {};
    if ((missing >> static_cast<std::size_t>(info_.channels)).any()) {
      return DeviceError("the device description asks for channel " + ChannelNames(missing) + ", but the " +
                         info_.name + " has 0 to " + std::to_string(info_.channels - 1) +
                         "; correct the channels in the device description");
    }
    return DeviceError("the " + info_.name + " found channel " + ChannelNames(missing) +
                       " not held off by its resistor when it started, so it does not drive it; check the "
                       "wiring, and that the firmware's logic is the circuit's (docs/light-controller.md)");
  }

 private:
  Error Unwilling(const ControllerReply& reply) const {
    const std::string why =
        reply.kind == ReplyKind::kError ? reply.error : "why " + std::string(1, reply.why);
    return DeviceError("the " + info_.name + " did not switch its lights as it was told (" + why +
                       "); check its cable and power");
  }

  // Remembers the error for whoever asks next.
  Error Fail(const Error& error) {
    lit_ = false;
    fault_ = error;
    return error;
  }

  // A new session after a fault, over the same port, opened anew where it was gone.
  Status BeginAnew() {
    const Context patient;
    if (link_ && !link_->gone()) {
      const Status greeted = link_->Greet(patient);
      if (!greeted.ok()) return Fail(greeted.error());
    } else {
      link_.reset();  // first, or a port that was plugged in again would get another name
      Result<std::unique_ptr<ControllerLink>> link =
          ControllerLink::Open(port_, options_.baud, options_.link, patient);
      if (!link.ok()) return Fail(link.error());
      link_ = std::move(link).value();
    }
    fault_.reset();
    return {};
  }

  Result<ChannelSet> Query() {
    if (fault_) return *fault_;
    const ControllerLink::Answer answer = link_->Ask("GET");
    if (answer.outcome != LinkOutcome::kAnswered) return Fail(answer.error);
    if (answer.reply.kind != ReplyKind::kState) return Fail(Unwilling(answer.reply));
    lit_ = answer.reply.on != 0;
    return ChannelSet(answer.reply.on);
  }

  void KeepAlive() {
    std::unique_lock lock(mutex_);
    while (!stop_) {
      if (!lit_) {
        changed_.wait(lock);
        continue;
      }
      const auto pause = std::chrono::duration<double>(options_.keep_alive_s);
      changed_.wait_for(lock, pause, [this] { return stop_; });
      if (!stop_ && lit_) static_cast<void>(Query());  // a fault is kept for the next caller
    }
  }

  const SerialLightsOptions options_;
  const ControllerInfo info_;
  const std::string port_;
  std::mutex mutex_;  // of all that follows
  std::condition_variable changed_;
  std::unique_ptr<ControllerLink> link_;  // none where the port is gone
  std::optional<Error> fault_;            // since the last Set()
  bool lit_ = false;                      // something is on
  bool stop_ = false;
  std::thread keeper_;
};

Status CheckLogic(const ControllerLink& link, const SerialLightsOptions& options) {
  const bool inverted = link.greeting().inverted;
  if (!options.inverted || *options.inverted == inverted) return {};
  const auto word = [](bool is_inverted) { return is_inverted ? "inverted" : "normal"; };
  return DeviceError("the light controller on " + link.port() + " has firmware of " + word(inverted) +
                     " logic, but the device description says " + word(*options.inverted) +
                     "; flash the other firmware or correct the description (docs/light-controller.md)");
}

Result<std::unique_ptr<Lights>> OpenOn(const std::string& port, const SerialLightsOptions& options,
                                       const Context& context) {
  DORSUM_ASSIGN_OR_RETURN(std::unique_ptr<ControllerLink> link,
                          ControllerLink::Open(port, options.baud, options.link, context));
  DORSUM_RETURN_IF_ERROR(CheckLogic(*link, options));
  const ControllerLink::Answer limits = link->Ask("LIMITS");
  if (limits.outcome != LinkOutcome::kAnswered) return limits.error;
  if (limits.reply.kind != ReplyKind::kLimits) {
    return DeviceError("the light controller on " + port +
                       " does not tell its limits; flash the firmware that belongs to this program "
                       "(scripts/firmware)");
  }
  ControllerInfo info;
  info.name = "light controller on " + port;
  info.firmware_version = link->greeting().firmware_version;
  info.channels = link->greeting().channels;
  info.silence_limit_s = limits.reply.silence_ms * 1e-3;
  info.on_limit_s = limits.reply.laser_ms * 1e-3;
  auto lights = std::make_unique<SerialLights>(std::move(link), options, std::move(info));
  DORSUM_RETURN_IF_ERROR(lights->CheckChannels(options.needed));
  return std::unique_ptr<Lights>(std::move(lights));
}

}  // namespace

Result<std::unique_ptr<Lights>> OpenFirstSerialLights(const std::vector<std::string>& ports,
                                                      const SerialLightsOptions& options,
                                                      const Context& context) {
  if (ports.empty()) {
    return DeviceError(
        "there is no serial port of a USB device; plug the light controller in, or name its port as "
        "controller.port in the device description");
  }
  std::optional<Error> first;
  for (const std::string& port : ports) {
    Result<std::unique_ptr<Lights>> lights = OpenOn(port, options, context);
    if (lights.ok() || lights.error().code == ErrorCode::kCancelled) return lights;
    if (!first) first = lights.error();
  }
  if (ports.size() == 1) return *first;
  std::string names;
  for (const std::string& port : ports) names += (names.empty() ? "" : ", ") + port;
  return DeviceError("no light controller on any of " + names + " (" + first->message + ")");
}

Result<std::unique_ptr<Lights>> OpenSerialLights(const SerialLightsOptions& options, const Context& context) {
  return OpenFirstSerialLights(options.port.empty() ? UsbSerialPorts() : std::vector{options.port}, options,
                               context);
}

}  // namespace dorsum
