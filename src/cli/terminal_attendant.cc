// SPDX-License-Identifier: Apache-2.0
#include "cli/terminal_attendant.h"

#include <cstdio>

#include <poll.h>
#include <unistd.h>

#include "cli/session.h"

namespace dorsum {
namespace {

class TerminalAttendant : public Attendant {
 public:
  explicit TerminalAttendant(Session* session) : session_(session) {}

  Status Arrange(const SeriesStep& /*step*/, const std::string& words,
                 const std::function<Status()>& keep_lit, const Context& context) override {
    Say(words + " Then press Enter (q: go on another time).");
    for (;;) {
      DORSUM_RETURN_IF_ERROR(context.CheckCancelled());
      DORSUM_RETURN_IF_ERROR(keep_lit());
      pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
      constexpr int kWaitMs = 500;
      if (poll(&input, 1, kWaitMs) <= 0) continue;
      char line[64];
      const ssize_t count = read(STDIN_FILENO, line, sizeof line);
      if (count <= 0) {
        return UsageError(
            "there is nobody to lay things down: the standard input is closed; start "
            "dorsum calibrate --live in a terminal");
      }
      if (line[0] == 'q' || line[0] == 'Q') return Cancelled();
      return {};
    }
  }

  void Tell(const std::string& words) override { Say(words); }

 private:
  void Say(const std::string& words) {
    session_->EndProgress();
    std::fprintf(stderr, "%s\n", words.c_str());
  }

  Session* session_;
};

}  // namespace

std::unique_ptr<Attendant> MakeTerminalAttendant(Session* session) {
  return std::make_unique<TerminalAttendant>(session);
}

}  // namespace dorsum
