// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/context.h"
#include "base/result.h"
#include "device/controller_protocol.h"
#include "device/serial_port.h"

namespace dorsum {

struct LinkOptions {
  double greeting_s = 6.0;  // an old boot loader keeps the line for two seconds after a reset; 0.1 to 60
  double answer_s = 0.25;   // for one try, 0.02 to 5; all tries together must stay below the silence limit
  int tries = 4;            // 1 to 20
};

// What came of a command.
enum class LinkOutcome {
  kAnswered,   // or refused: see the reply
  kRestarted,  // the controller has started anew and knows nothing of this session: everything is off
  kFailed,     // gone or silent
};

// One session with a light controller over one port: greeting, sequence numbers, retries. Used by one thread
// at a time.
class ControllerLink {
 public:
  // Opens the port and greets. Opening may reset the controller, so the greeting is repeated until it
  // answers.
  static Result<std::unique_ptr<ControllerLink>> Open(const std::string& port, int baud,
                                                      const LinkOptions& options, const Context& context);

  // A new session on the open port; everything goes off.
  Status Greet(const Context& context);

  struct Answer {
    LinkOutcome outcome = LinkOutcome::kFailed;
    ControllerReply reply;  // kAnswered
    Error error;            // otherwise
  };
  // Sends the command until it is answered; the same sequence number makes a repetition harmless.
  Answer Ask(std::string_view words);
  // Tells the controller to switch everything off, and hears whether it has. Never fails, for then the
  // controller's own limits do it.
  void SayOff();

  const ControllerReply& greeting() const { return greeting_; }
  const std::string& port() const { return port_->path(); }
  bool gone() const { return port_->gone(); }  // nothing but opening the port anew can help

 private:
  ControllerLink(std::unique_ptr<SerialPort> port, const LinkOptions& options)
      : port_(std::move(port)), options_(options) {}
  // The next undamaged reply before the deadline; nothing when there is none, an error when the port is gone.
  Result<std::optional<ControllerReply>> NextReply(double deadline_s);
  Error WrongVersion(const ControllerReply& reply) const;

  std::unique_ptr<SerialPort> port_;
  LinkOptions options_;
  LineAssembler assembler_;
  std::string received_;  // bytes not yet looked at
  bool heard_ = false;    // anything at all
  ControllerReply greeting_;
  std::uint16_t session_ = 0, sequence_ = 0;
};

}  // namespace dorsum
