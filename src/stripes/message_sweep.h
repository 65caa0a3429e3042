// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dorsum {

// One end of an edge, seen from its piece.
struct MessageEnd {
  std::uint32_t other = 0;        // the piece at the other end
  std::uint32_t in = 0, out = 0;  // where its messages to this piece and back begin
  std::uint32_t cost = 0;         // where the edge's costs begin, by candidate of this piece
};

// A graph of pieces in flat arrays, by the pieces' places in the order of the sweeps. Whatever belongs to a
// piece's candidates takes `wide` places, a multiple of kMessageLanes; places behind the last candidate hold
// kNoCandidate.
struct MessageTable {
  std::size_t wide = 0;
  std::vector<std::size_t> candidates;  // of each piece
  std::vector<float> unary;
  std::vector<std::vector<MessageEnd>> ends;
  std::vector<float> costs, messages;
};

inline constexpr std::size_t kMessageLanes = 8;  // candidates that are worked on together
inline constexpr float kNoCandidate = 1e30F;     // more than all costs, and of no digit of theirs

// Sends messages from the pieces in [first, end) to their neighbours on one side, in the order of the pieces
// or against it; the largest change of a message.
float SweepMessages(bool ahead, std::size_t first, std::size_t end, MessageTable* table);

}  // namespace dorsum
