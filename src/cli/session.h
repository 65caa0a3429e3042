// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "base/context.h"
#include "base/json.h"
#include "base/result.h"

namespace dorsum {

// What all commands share: the options that each of them has, and how a command talks to the person who runs
// it. Results go to stdout, everything else to stderr.
class Session {
 public:
  bool json = false;   // results as JSON
  bool quiet = false;  // no progress, no warnings
  int threads = 0;     // 0: one per processor

  // A context whose progress goes to the terminal and which Ctrl-C cancels.
  Context MakeContext();
  void Warn(const std::vector<std::string>& warnings);
  // Ends the line of progress, if there is one.
  void EndProgress();
  // Prints the result: `text` for people, or the JSON.
  void Print(const std::string& text, const Json& result);

  void Fail(const Error& error) { error_ = error; }
  // Prints the error, if the command failed, and gives the program's exit code (DESIGN §5).
  int Finish();

 private:
  Error error_{ErrorCode::kInternal, ""};
  bool progress_shown_ = false;
};

// Exit code of an error: 1 answer is no, 2 usage, 3 bad input, 4 device, 5 our fault, 130 interrupted.
int ExitCode(ErrorCode code);

// Makes Ctrl-C and a request to terminate set the flag that contexts look at.
void CatchInterrupts();

}  // namespace dorsum
