// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "base/context.h"

namespace dorsum {

// Threads that a context means: at least one, at most one per processor that this process may use.
int ThreadsOf(const Context& context);

// Calls body(i) for every i in [begin, end), on context.threads threads (0: one per processor), and
// returns when all are done. Calls may come in any order and at the same time, so a body writes only to
// its own i: then the result is the same at any number of threads. Runs in the calling thread when
// there is one thread or one item. An exception of a body is rethrown here.
void ParallelFor(const Context& context, std::int64_t begin, std::int64_t end,
                 const std::function<void(std::int64_t)>& body);

}  // namespace dorsum
