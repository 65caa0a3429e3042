// SPDX-License-Identifier: Apache-2.0
#ifndef DORSUM_FIRMWARE_CONTROLLER_H
#define DORSUM_FIRMWARE_CONTROLLER_H

#include <stdbool.h>
#include <stdint.h>

#include "line.h"

#ifdef __cplusplus
extern "C" {
#endif

// Decides which channels are on: from what the host says, from how long it has been silent, and from how long
// the lights have been on. Knows nothing of the hardware; times are milliseconds of a clock that may wrap.

// Why nothing is on.
#define WHY_LIT '-'      // something is on
#define WHY_HOST 'H'     // the host asked for it, or nothing was on since the session began
#define WHY_SILENCE 'S'  // the host said nothing valid for SILENCE_LIMIT_MS
#define WHY_TIME 'T'     // a light reached its longest time on
#define WHY_ERROR 'E'    // a damaged line, or one that made no sense

struct controller {
  uint16_t on;  // bit n: channel n

  uint16_t wired;  // channels whose wiring was found to hold them off; no other is ever on
  char logic;      // 'N' normal, 'I' inverted
  char reset;      // why the controller started: P E B W U (docs/protocol.md)

  bool in_session;
  bool only_greeted;  // nothing was said since the greeting
  uint16_t session, sequence, nonce, seed;
  char why;
  uint32_t laser_limit_ms, led_limit_ms;
  uint32_t heard_ms;  // when the host last said something new and valid
  uint32_t set_ms;    // when the lights were last set

  char line[LINE_CAPACITY];
  uint8_t length;
  bool damaged;  // the line that is coming in
};

// Everything off, no session. `seed` should differ from start to start.
void controller_begin(struct controller* self, uint16_t wired, char logic, char reset, uint16_t seed);
// What it says by itself when it has started; the number of bytes to send. `reply` holds LINE_CAPACITY + 1.
uint8_t controller_banner(const struct controller* self, char* reply);
// Takes one received byte, `damaged` if the receiver saw an error with it or lost some before it. The number
// of bytes to send back.
uint8_t controller_byte(struct controller* self, char byte, bool damaged, uint32_t now_ms, char* reply);
// To be called at least every few milliseconds.
void controller_tick(struct controller* self, uint32_t now_ms);

#ifdef __cplusplus
}
#endif

#endif
