// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "device/attendant.h"

namespace dorsum {

class Session;

// Asks the person at the terminal: words on the standard error, the Enter key on the standard input when the
// arrangement stands, q and Enter to give up.
std::unique_ptr<Attendant> MakeTerminalAttendant(Session* session);

}  // namespace dorsum
