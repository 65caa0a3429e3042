// SPDX-License-Identifier: Apache-2.0
#include "speed/child_process.h"

#include <chrono>

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace dorsum::speed {

Result<ChildUse> RunChild(const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  for (const std::string& a : command) arguments.push_back(const_cast<char*>(a.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  const auto begin = std::chrono::steady_clock::now();
  pid_t child = 0;
  const int failed = posix_spawn(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) return BadInput("cannot start " + command.front());
  int status = 0;
  rusage use{};
  if (wait4(child, &status, 0, &use) != child) return BadInput("lost " + command.front());
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return BadInput(command.front() + " failed");
  return ChildUse{taken.count(), static_cast<double>(use.ru_maxrss) / 1024.0};
}

}  // namespace dorsum::speed
