// SPDX-License-Identifier: Apache-2.0
#ifndef DORSUM_FIRMWARE_LIGHTS_H
#define DORSUM_FIRMWARE_LIGHTS_H

#include <stdint.h>

// The light pins: channel n is Arduino pin D(n + 2), so lasers 0 to 7 are D2 to D9 and the LEDs D10. D13 is
// the board's own status LED.

// Finds the channels whose external resistor holds them off while the pins float, then drives those to off. A
// pin that is held to the wrong level, or to none, stays an input for good: a firmware of the wrong logic
// lights nothing. Takes about 20 ms. Returns the channels that can be switched.
uint16_t lights_begin(void);
// Writes levels and directions anew each time, so that a disturbed register does not last.
void lights_show(uint16_t on);
void lights_status(uint8_t lit);

#endif
